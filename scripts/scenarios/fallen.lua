--- A robot that has learned the room is pushed over. It should get up, reset its orientation (the rotation of the feet
--- during a fall is unknown), and find its pose again with the help of the room.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"
local ground_truth = require "lib.ground_truth"

param {
  learn   = { 60.0,  range = { 0, 600 }, unit = "s", doc = "time for which the robot learns the room" },
  stay    = { 10.0,  range = { 0, 60 },  unit = "s", doc = "time for which the belief must be correct and confirmed" },
  timeout = { 120.0, range = { 1, 600 }, unit = "s", doc = "longest time after the push" },
}

scenario "fallen" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function() ground_truth.start() end,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "learning" {
    { "pushed over", after = "learn", because = "the time to learn is over" },
  },

  state "pushed over" {
    initial = "down",
    enter = function()
      ground_truth.note("pushed over")
      operator.push_over()
    end,
    { "failed", after = "timeout", because = "the time is up" },

    state "down" {
      { "up again",
        when = function() return behaviors.orientation.state == "resetting" and not truth.fallen end,
        because = "the robot got up and reset its orientation" },
    },

    state "up again" {
      { "right",
        when = function() return ground_truth.is_belief_right() and decision.for_believed() end,
        lasting = "stay", because = "the robot knows its pose again" },
    },
  },

  state "right" {
    enter = function()
      ground_truth.note("found")
      verdict.succeed("the robot got up, reset its orientation and found it again")
    end,
  },

  state "failed" {
    enter = function()
      ground_truth.note("time is up")
      verdict.fail("the robot did not confirm a correct pose in time; its belief is " .. ground_truth.error_in_words())
    end,
  },
}
