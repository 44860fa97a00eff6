--- A robot starts with the mirrored pose as its belief and learns the room: the learned room is rotated by 180 degrees, so
--- it agrees with the wrong belief. Then the true pose is set once, or set again after the robot has flipped it, or nothing
--- happens.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local function set_true_pose() operator.set_initial_pose(truth.x, truth.y, truth.rotation) end

local p = param {
  learn    = { 60.0, range = { 0, 600 }, unit = "s", doc = "learning time with the mirrored pose as belief" },
  remedy   = { "none", choices = { "none", "set", "set_again" },
               doc = "action after learning: nothing, set the true pose, or set it and set it again after a flip" },
  reaction = { 2.0, range = { 0, 60 }, unit = "s", doc = "shortest time until the pose is set again" },
  timeout  = { 30.0, range = { 1, 36000 }, unit = "s", doc = "time for which the belief is observed" },
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
      operator.put_down(x, y, rotation)
      operator.set_initial_pose(-x, -y, rotation + math.pi)
    end,
    { "learning", after = 0.1, because = "the mirrored pose is set" },
  },

  state "learning" {
    { "measured", after = "learn", because = "the time to learn is over" },
  },

  state "measured" {
    enter = function()
      ground_truth.note("learned with the mirrored pose")
      if p.remedy ~= "none" then set_true_pose() end
    end,
    { "set again",
      when = function() return p.remedy == "set_again" and not ground_truth.is_belief_right() end,
      after = "reaction", because = "the robot has flipped the pose that was set" },
    { "right", when = ground_truth.is_belief_right, after = "timeout", because = "the time is up and the belief is right" },
    { "wrong", after = "timeout", because = "the time is up and the belief is wrong" },
  },

  state "set again" {
    enter = set_true_pose,
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
