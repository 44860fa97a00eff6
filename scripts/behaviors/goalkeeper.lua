--- Stays between the ball and its own goal, and clears a ball that comes near.
--
-- It needs the interface `ball`: `reorient game --behaviors goalkeeper,...`.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"
local ball = require "lib.ball"

local p = param {
  distance = { 0.8, range = { 0.2, 3 }, unit = "m", doc = "distance from the middle of the goal at which it stands" },
  slack    = { 0.3, range = { 0.1, 2 }, unit = "m", doc = "distance from its place at which it moves" },
  near     = { 1.2, range = { 0.3, 5 }, unit = "m", doc = "distance of a ball that it clears" },
  safe     = { 2.0, range = { 0.3, 9 }, unit = "m", doc = "distance of a cleared ball, at which it returns" },
}

local function goal_x() return -field.length / 2 end

-- Direction from the middle of the goal to the ball; straight ahead while the ball is unknown (rad).
local function direction()
  if not ball.is_known() then return 0.0 end
  local x, y = ball.on_field()
  return math.max(-1.2, math.min(1.2, math.atan(y, x - goal_x())))
end

local function place_x() return goal_x() + p.distance * math.cos(direction()) end

local function place_y() return p.distance * math.sin(direction()) end

local function is_off_its_place() return not walking.is_near(place_x(), place_y(), p.slack) end

local function ball_comes_near() return ball.is_in_play() and ball.is_known() and input.ball.distance < p.near end

local function ball_is_gone() return not ball.is_known() or input.ball.distance > p.safe or not ball.is_in_play() end

behavior "goalkeeper" {
  priority = 35,
  initial = "guarding",

  state "guarding" {
    initial = "standing",
    run "search_ball" {},
    { "clearing", when = ball_comes_near, lasting = 0.3, because = "the ball comes near" },

    state "standing" {
      update = function() walk.stand() end,
      { "moving", when = is_off_its_place, lasting = 0.2, because = "the ball has moved" },
    },

    state "moving" {
      run "walk_to" { x = place_x, y = place_y, turns = true, rotation = direction, timeout = 20 },
      { "standing", when = done "walk_to", because = "it stands before the goal" },
      { "standing", when = failed "walk_to", because = "it did not get there" },
    },
  },

  state "clearing" {
    run "kick_ball" {},
    run "approach_ball" {},
    run "search_ball" {},
    { "guarding", when = ball_is_gone, lasting = 0.5, because = "the ball is away" },
  },
}
