--- Measures how exactly a robot knows its pose that walks between the penalty marks and is pushed over from time to time.
--- Either the operator sets the initial pose, or the robot is placed anywhere and no initial pose is set.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local p = param {
  duration = { 600.0, range = { 1, 36000 }, unit = "s", doc = "duration of the run; above 600 s also set --seconds" },
  falls    = { 2,     range = { 0, 100 }, integer = true, doc = "number of times the robot is pushed over, at about equal intervals" },
  told     = { true,  doc = "whether the initial pose is set; otherwise the robot stands anywhere" },
  margin   = { 0.5,   range = { 0, 3 }, unit = "m", doc = "smallest distance from the lines at which it is placed without a pose" },
}

local memory = keep { falls = 0, next_fall = 0.0 }

local function put_down_anywhere()
  local x, y = field.length / 2 - p.margin, field.width / 2 - p.margin
  operator.put_down(chance.between(-x, x), chance.between(-y, y), chance.between(-math.pi, math.pi))
end

local function plan_next_fall()
  local between = p.duration / (p.falls + 1)
  memory.next_fall = (memory.falls + 1) * between + chance.between(-0.2, 0.2) * between
end

local function is_fall_due() return memory.falls < p.falls and clock.time >= memory.next_fall end

local function push_over()
  memory.falls = memory.falls + 1
  ground_truth.note("pushed over")
  operator.push_over()
end

local function is_over() return clock.time >= p.duration end

scenario "falls" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function() if p.told then ground_truth.start() else put_down_anywhere() end end,
    { "walking", after = 0.1, because = "the robot stands" },
  },

  state "walking" {
    initial = "on its feet",
    { "right", when = function() return is_over() and ground_truth.is_belief_right() end,
      because = "the time is up and the belief is right" },
    { "wrong", when = is_over, because = "the time is up and the belief is wrong" },

    state "on its feet" {
      enter = plan_next_fall,
      { "pushed over", when = is_fall_due, because = "the robot is pushed over" },
    },

    state "pushed over" {
      enter = push_over,
      { "on its feet", after = 0.1, because = "it falls" },
    },
  },

  state "right" {
    enter = function() ground_truth.give_verdict(true) end,
  },

  state "wrong" {
    enter = function() ground_truth.give_verdict(false) end,
  },
}
