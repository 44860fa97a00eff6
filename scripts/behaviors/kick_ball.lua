--- Kicks the ball when it lies before a foot, and waits after a kick that failed.
--
-- It needs the interface `ball` of an application, which detects the ball and kicks: `reorient run --interface ball`.

-- SPDX-License-Identifier: MIT

local p = param {
  reach = { 0.25, range = { 0.1, 0.5 }, unit = "m", doc = "distance of the ball at which the robot kicks" },
  rest = { 2.0, range = { 0, 10 }, unit = "s", doc = "time before another kick after one that failed" },
}

local function is_at_the_feet()
  return input.valid.ball.position and input.ball.distance < p.reach and input.ball.position.x > 0
end

local function kick()
  local where = input.ball.position
  action.kick { foot = where.y > 0 and "left" or "right", direction = 0 }
end

behavior "kick_ball" {
  priority = 40,
  initial = "waiting",

  state "waiting" {
    { "kicking", when = is_at_the_feet, lasting = 0.3, because = "the ball lies before a foot" },
  },

  state "kicking" {
    enter = kick,
    update = function() walk.stand() end,
    { "waiting", when = function() return action.kick.state == "done" end, because = "the robot has kicked" },
    { "resting", when = function() return action.kick.state == "failed" end, because = "the kick failed" },
  },

  state "resting" {
    enter = function() log.info("the kick failed: " .. action.kick.reason) end,
    { "waiting", after = "rest", because = "the robot has rested" },
  },
}
