--- Half-time: a robot has learned the room when the teams change sides. It stays in place and only the field's axes rotate.
--- Its belief and its model of the room must rotate with them within one frame, and later views must not make the belief
--- unconfirmed.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

param {
  learn    = { 40.0, range = { 0, 600 }, unit = "s", doc = "time for which the robot learns the room" },
  duration = { 60.0, range = { 1, 600 }, unit = "s", doc = "duration of the second half" },
  patience = { 2.0,  range = { 0, 60 },  unit = "s", doc = "longest time with a wrong belief" },
}

scenario "half_time" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function() ground_truth.start() end,
    { "first half", after = 0.1, because = "the initial pose is set" },
  },

  state "first half" {
    exit = function()
      ground_truth.note("before half-time")
      operator.half_time()
    end,
    { "second half", after = "learn", because = "the teams change sides" },
  },

  state "second half" {
    initial = "knowing",
    { "right", after = "duration", because = "the time is up" },

    state "knowing" {
      { "flipped", when = function() return behaviors.orientation.state == "correcting" end,
        because = "the robot flips its belief" },
      { "wrong", when = function() return game.sides_changed and not ground_truth.is_belief_right() end,
        lasting = "patience", because = "the belief is wrong" },
    },
  },

  state "right" {
    enter = function()
      ground_truth.note("after half-time")
      verdict.succeed("the robot knows its position after the change of sides")
    end,
  },

  state "flipped" {
    enter = function() verdict.fail("the robot flipped its belief after half-time") end,
  },

  state "wrong" {
    enter = function() verdict.fail("after half-time the belief is " .. ground_truth.error_in_words()) end,
  },
}
