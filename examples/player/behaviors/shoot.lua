--- Stands still, then kicks the ball that lies before a foot into the direction of the opponents' goal.
---
--- Other behaviors run it. It needs the interface `ball`.

-- SPDX-License-Identifier: MIT

local ball = require "lib.ball"
local aim = require "lib.aim"

local p = param {
  reach = { 0.28, range = { 0.1, 0.5 }, unit = "m", doc = "largest distance of a ball that the robot kicks" },
  angle = { 1.0, range = { 0.05, 1 }, unit = "rad", doc = "largest angle of a kick to the left or right" },
  steady_time = { 0.1, range = { 0, 3 }, unit = "s", doc = "time to stand still before the kick" },
  patience = { 2.0, range = { 0.5, 20 }, unit = "s", doc = "longest time to wait until the robot stands still" },
}

local function is_within_reach()
  return ball.is_known() and input.ball.distance < p.reach and input.ball.position.x > 0
    and math.abs(aim.direction()) < p.angle
end

local function is_out_of_reach() return not is_within_reach() end

local function is_steady() return not robot.walking and is_within_reach() end

local function kick()
  action.kick { foot = input.ball.position.y > 0 and "left" or "right", direction = aim.direction() }
end

behavior "shoot" {
  priority = 20,
  initial = "stopping",

  state "stopping" {
    update = function() walk.stand() end,
    { "missed", when = is_out_of_reach, lasting = 0.2, because = "the ball is out of reach" },
    { "kicking", when = is_steady, lasting = "steady_time", because = "the robot stands still before the ball" },
    { "missed", after = "patience", because = "the robot did not stand still in time" },
  },

  state "kicking" {
    enter = kick,
    update = function() walk.stand() end,
    { "kicked", when = function() return action.kick.state == "done" end, because = "the ball was kicked" },
    { "refused", when = function() return action.kick.state == "failed" end, because = "the kick failed" },
  },

  state "refused" {
    enter = function() log.info("the kick failed: " .. action.kick.reason) end,
    ends = "failed",
  },

  state "kicked" { ends = "done" },
  state "missed" { ends = "failed" },
}
