--- A field player: goes to its place before the kick-off, then searches for the ball, approaches and kicks it. It only
--- puts other behaviors together: each does one thing and can be tested alone.
--
-- It needs the interface `ball`: `reorient game --behaviors striker,...`.

-- SPDX-License-Identifier: MIT

local ball = require "lib.ball"

local p = param {
  place_x = { -1.0, range = { -10, 0 },  unit = "m", doc = "where to wait for the kick-off, toward the opponents' goal" },
  place_y = { 0.0,  range = { -10, 10 }, unit = "m", doc = "where to wait for the kick-off, to the left" },
}

local function is_before_kick_off() return game.state == "ready" end

behavior "striker" {
  priority = 35,
  initial = "waiting",
  common = {
    { "going to its place", when = is_before_kick_off, because = "the game begins soon" },
    { "playing", when = ball.is_in_play, because = "the ball is in play" },
    { "waiting", when = function() return not ball.is_in_play() and not is_before_kick_off() end,
      because = "the robots must stand still" },
  },

  state "waiting" {
    run "search_ball" {},
  },

  state "going to its place" {
    run "walk_to" {
      x = function() return p.place_x end,
      y = function() return p.place_y end,
      turns = true,
    },
  },

  -- The first one wins: a robot that kicks does not walk, and a robot that approaches the ball does not turn to search.
  state "playing" {
    run "kick_ball" {},
    run "approach_ball" {},
    run "search_ball" {},
  },
}
