--- The paper's test (Section 4) with the paper's own behaviors: a robot stands beside the field and has learned the room;
--- then the reflection of its pose is set. It should notice and flip within 200 s, otherwise it has failed. Use it with
--- `--params paper`.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

param {
  learn   = { 40.0,  range = { 0, 600 },  unit = "s", doc = "time for which the robot learns the room" },
  stay    = { 2.0,   range = { 0, 60 },   unit = "s", doc = "time for which the belief must be correct" },
  timeout = { 200.0, range = { 1, 600 },  unit = "s", doc = "longest time until the flip; in the paper a longer time counts as failed" },
}

scenario "wrong_start" {
  behaviors = { "paper/paper_orientation", "paper/paper_training", "head_scan", "get_up", "penalty_marks" },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function() ground_truth.start() end,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "learning" {
    { "misled", after = "learn", because = "the time to learn is over" },
  },

  state "misled" {
    initial = "wrong",
    enter = function()
      ground_truth.note("initial pose: reflection")
      operator.set_initial_pose(-truth.x, -truth.y, truth.rotation + math.pi)
    end,
    { "failed", after = "timeout", because = "the time is up" },

    state "wrong" {
      { "right",
        when = ground_truth.is_belief_right, after = 1.0,
        lasting = "stay", because = "the belief is right again" },
    },
  },

  state "right" {
    enter = function() verdict.succeed("the robot noticed that the initial pose was mirrored") end,
  },

  state "failed" {
    enter = function() verdict.fail("the robot still believes " .. ground_truth.error_in_words()) end,
  },
}
