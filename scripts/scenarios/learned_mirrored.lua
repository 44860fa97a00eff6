--- A robot starts with the mirrored pose as its belief and learns the room for some time: what it learns is turned by half a
--- turn, and so agrees with its wrong belief. Then the true pose is set, or nothing happens.

local ground_truth = require "lib.ground_truth"

local p = param {
  learn   = { 60.0, range = { 0, 600 }, unit = "s", doc = "how long the robot learns with the mirrored pose as its belief" },
  remedy  = { "none", choices = { "none", "told" }, doc = "what happens then: nothing, or the true pose is set" },
  timeout = { 30.0, range = { 1, 36000 }, unit = "s", doc = "how long the belief is observed after that" },
}

scenario "learned_mirrored" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function()
      local x, y, rotation = ground_truth.start_pose()
      experimenter.put_down(x, y, rotation)
      experimenter.set_initial_pose(-x, -y, rotation + math.pi)
    end,
    { "learning", after = 0.1, because = "the mirrored pose is set" },
  },

  state "learning" {
    { "measured", after = "learn", because = "the time to learn is over" },
  },

  state "measured" {
    enter = function()
      ground_truth.note("learned with the mirrored pose")
      if p.remedy == "told" then experimenter.set_initial_pose(truth.x, truth.y, truth.rotation) end
    end,
    { "right", when = ground_truth.is_belief_right, after = "timeout", because = "the time is up and the belief is right" },
    { "wrong", after = "timeout", because = "the time is up and the belief is wrong" },
  },

  state "right" {
    enter = function() ground_truth.give_verdict(true) end,
  },

  state "wrong" {
    enter = function() ground_truth.give_verdict(false) end,
  },
}
