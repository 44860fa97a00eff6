--- Endurance: the robot walks between the penalty marks for a long time without any event. It should neither flip a correct
--- belief nor degrade the learned room.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local p = param {
  duration = { 600.0, range = { 1, 36000 }, unit = "s", doc = "duration of the run; above 600 s also set --seconds" },
  report   = { 60.0,  range = { 1, 3600 },  unit = "s", doc = "interval at which truth and belief are logged" },
}

local memory = keep { wrong = 0.0 }   -- s for which the belief was wrong so far

local function is_over() return clock.time >= p.duration end

local function watch_belief()
  if not ground_truth.is_belief_right() then memory.wrong = memory.wrong + clock.step end
end

scenario "patrol" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function() ground_truth.start() end,
    { "walking", after = 0.1, because = "the initial pose is set" },
  },

  state "walking" {
    initial = "on its way",
    update = watch_belief,
    { "right",
      when = function() return is_over() and ground_truth.is_belief_right() end,
      because = "the time is up and the belief is right" },
    { "wrong", when = is_over, because = "the time is up and the belief is wrong" },

    state "on its way" {
      exit = function() ground_truth.note(string.format("wrong for %.1f s so far", memory.wrong)) end,
      { "on its way", after = "report", because = "it is time for a report" },
    },
  },

  state "right" {
    enter = function()
      verdict.succeed(string.format("the belief is right in the end; it was wrong for %.1f s", memory.wrong))
    end,
  },

  state "wrong" {
    enter = function() ground_truth.give_verdict(false) end,
  },
}
