--- The main task: a robot stands beside the field with a known pose and learns the room while it walks and looks around.
--- Then it is lifted and placed where its belief is the exact reflection of the truth. It should notice, flip its belief,
--- and walk to the correct penalty mark. A robot that cannot walk succeeds when its belief is correct and stays so.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local p = param {
  learn   = { 40.0,  range = { 0, 600 },  unit = "s", doc = "time for which the robot learns the room" },
  carry   = { 1.5,   range = { 0.2, 30 }, unit = "s", doc = "time for which the robot is lifted" },
  mark_tolerance = { 0.5,   range = { 0.1, 2 },  unit = "m", doc = "largest distance from the correct mark" },
  settle  = { 2.0,   range = { 0, 30 },   unit = "s", doc = "time for which the belief must stay correct if the robot cannot walk" },
  stay    = { 0.5,   range = { 0, 10 },   unit = "s", doc = "time for which it must stay near a mark" },
  timeout = { 120.0, range = { 1, 600 },  unit = "s", doc = "longest time after it was placed" },
}

local memory = keep { x = 0.0, y = 0.0, rotation = 0.0 }   -- the belief when the robot was lifted

local function stands_on_mark(side)
  return ground_truth.is_on_mark(side, p.mark_tolerance) and behaviors.penalty_marks.state == "on the mark"
end

scenario "mirrored_placement" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = ground_truth.start,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "learning" {
    { "carrying", after = "learn", because = "the time to learn is over" },
  },

  state "carrying" {
    enter = function()
      memory.x, memory.y, memory.rotation = pose.x, pose.y, pose.rotation
      ground_truth.note("lifted")
      operator.pick_up()
    end,
    { "mirrored", after = "carry", because = "the robot is placed at the reflection of its belief" },
  },

  state "mirrored" {
    initial = "lost",
    enter = function() operator.put_down(-memory.x, -memory.y, memory.rotation + math.pi) end,
    { "failed", after = "timeout", because = "the time is up" },

    state "lost" {
      { "right", when = function() return stands_on_mark(-1) end,
        lasting = "stay", because = "the robot stands on the right mark" },
      { "wrong", when = function() return stands_on_mark(1) end,
        lasting = "stay", because = "the robot stands on the wrong mark" },
      { "right again", when = function() return not robot.can_walk and ground_truth.is_belief_right() end,
        lasting = "settle", because = "the belief of a robot that cannot walk is right again" },
    },
  },

  state "right again" {
    enter = function()
      ground_truth.note("the belief is correct again")
      verdict.succeed("the robot noticed that its belief was mirrored")
    end,
  },

  state "right" {
    enter = function()
      ground_truth.note("arrived")
      verdict.succeed("the robot noticed that its belief was mirrored and walked to the right mark")
    end,
  },

  state "wrong" {
    enter = function()
      ground_truth.note("arrived")
      verdict.fail("the robot believes its mirrored pose and stands on the wrong mark")
    end,
  },

  state "failed" {
    enter = function()
      ground_truth.note("time is up")
      verdict.fail("the robot did not correct its belief or did not reach the correct mark in time")
    end,
  },
}
