--- A field player: obeys the referee around a kick-off, then searches for the ball, approaches and kicks it. It only puts
--- other behaviors together: each does one thing and can be tested alone.
--
-- It needs the interface `ball`: `reorient game --behaviors striker,...`.

-- SPDX-License-Identifier: MIT

local ball = require "lib.ball"

local p = param {
  place_x = { -1.2, range = { -10, 0 },  unit = "m", doc = "where to wait for the kick-off, toward the opponents' goal" },
  place_y = { 0.0,  range = { -10, 10 }, unit = "m", doc = "where to wait for the kick-off, to the left" },
}

local function may_not_play() return robot.penalized or not ball.is_in_play() end

behavior "striker" {
  priority = 35,
  initial = "before the kick-off",

  state "before the kick-off" {
    run "kick_off" {
      x = function() return p.place_x end,
      y = function() return p.place_y end,
    },
    { "playing", when = done "kick_off", because = "the robot may go for the ball" },
  },

  -- The first one wins: a robot that kicks does not walk, and a robot that approaches the ball does not turn to search.
  state "playing" {
    run "kick_ball" {},
    run "approach_ball" {},
    run "search_ball" {},
    { "before the kick-off", when = may_not_play, because = "the robot must stand still" },
  },
}
