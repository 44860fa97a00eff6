--- Follows the ball with the head. If it is lost, looks at the center mark, then all around.
---
--- The referee puts the ball on the center mark for each kick-off, and when no robot has touched it for long.
--- Other behaviors run this one. It does not end. It needs the interface `ball`.

-- SPDX-License-Identifier: MIT

local ball = require "lib.ball"
local gaze = require "lib.gaze"

local p = param {
  center_time = { 4.0, range = { 0.1, 30 }, unit = "s", doc = "time to look at the center mark" },
  around_time = { 20.0, range = { 1, 120 }, unit = "s", doc = "longest time to look all around" },
}

local function sees_ball() return input.valid.ball.seen and input.ball.seen end

behavior "find_ball" {
  priority = 20,
  initial = "following",

  state "following" {
    run "search_ball" {},
    { "looking at the center", when = function() return not ball.is_known() end, because = "the ball is lost" },
  },

  state "looking at the center" {
    update = function() gaze.at(0.0, 0.0) end,
    { "following", when = sees_ball, because = "the ball is seen" },
    { "looking around", after = "center_time", because = "the ball is not at the center" },
  },

  state "looking around" {
    run "search_ball" {},
    { "following", when = sees_ball, because = "the ball is seen" },
    { "looking at the center", after = "around_time", because = "the ball was not found" },
  },
}
