--- A robot that has learned the room is lifted and placed elsewhere: some meters away from the reflection of its belief, and
--- rotated. Its believed pose and the reflection are both wrong. It should distrust its pose, search, and walk to its own
--- penalty mark.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local p = param {
  learn    = { 60.0,  range = { 0, 600 },   unit = "s",   doc = "time for which the robot learns the room" },
  carry    = { 2.0,   range = { 0.2, 30 },  unit = "s",   doc = "time for which the robot is lifted" },
  ahead    = { 1.0,   range = { -3, 3 },    unit = "m",   doc = "distance at which it is placed ahead of the reflection of its belief" },
  left     = { 1.2,   range = { -3, 3 },    unit = "m",   doc = "distance to the left of the reflection of its belief" },
  turn     = { 0.7,   range = { -3.2, 3.2 }, unit = "rad", doc = "rotation to the left relative to the reflection of its belief" },
  mark_tolerance = { 0.5,   range = { 0.1, 2 },   unit = "m",   doc = "largest distance from the correct mark" },
  stay     = { 0.5,   range = { 0, 10 },    unit = "s",   doc = "time for which it must stay near a mark" },
  timeout  = { 180.0, range = { 1, 600 },   unit = "s",   doc = "longest time after it was placed" },
}

local memory = keep { x = 0.0, y = 0.0, rotation = 0.0 }   -- the belief when the robot was lifted

local function put_down_elsewhere()
  local rotation = memory.rotation + math.pi   -- of the reflection
  local cosine, sine = math.cos(rotation), math.sin(rotation)
  operator.put_down(
    -memory.x + p.ahead * cosine - p.left * sine,
    -memory.y + p.ahead * sine + p.left * cosine,
    rotation + p.turn)
end

local function stands_on_a_mark() return behaviors.penalty_marks.state == "on the mark" end

scenario "kidnapped" {
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
    { "carrying", after = "learn", because = "the time to learn is over" },
  },

  state "carrying" {
    enter = function()
      memory.x, memory.y, memory.rotation = pose.x, pose.y, pose.rotation
      ground_truth.note("lifted")
      operator.pick_up()
    end,
    { "elsewhere", after = "carry", because = "the robot is placed elsewhere" },
  },

  state "elsewhere" {
    initial = "lost",
    enter = put_down_elsewhere,
    { "failed", after = "timeout", because = "the time is up" },

    state "lost" {
      { "right",
        when = function() return stands_on_a_mark() and ground_truth.is_on_mark(-1, p.mark_tolerance) end,
        lasting = "stay", because = "the robot stands on the right mark" },
      { "wrong",
        when = function() return stands_on_a_mark() and not ground_truth.is_on_mark(-1, p.mark_tolerance) end,
        lasting = "stay", because = "the robot believes that it stands on a mark" },
    },
  },

  state "right" {
    enter = function()
      ground_truth.note("arrived")
      verdict.succeed("the kidnapped robot found its position and walked to the correct mark")
    end,
  },

  state "wrong" {
    enter = function()
      ground_truth.note("arrived")
      verdict.fail("the robot believes that it stands on its mark; its belief is " .. ground_truth.error_in_words())
    end,
  },

  state "failed" {
    enter = function()
      ground_truth.note("time is up")
      verdict.fail("the robot did not reach its mark in time; its belief is " .. ground_truth.error_in_words())
    end,
  },
}
