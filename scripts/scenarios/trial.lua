--- One trial of an experiment: a robot learns its room, then an event happens, and after it the belief is measured. The
--- parameters `light.*` can change the light after learning. Parameters choose the event, its position and its time; the
--- seed chooses the rest. All experiments in assets/experiments use it. Example: `reorient run trial --set trial.event=fallen`

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local p = param {
  event = { "mirrored_placement", doc = "event that happens to the robot", choices = {
    "none",           -- no event
    "mirrored_placement",   -- it is lifted and placed at the reflection of its belief
    "put_back",       -- it is lifted and placed where it was
    "kidnapped",      -- it is lifted and placed anywhere on the field
    "fallen",         -- it is pushed over
    "penalized",      -- it is removed from the game and returns from the sideline
    "misled",         -- it is placed at its start, and the reflection is set as pose
    "half_time",      -- the teams change sides
  } },
  side    = { "own", choices = { "own", "opponent" }, doc = "half of the field beside which the robot starts" },
  learn   = { 40.0,  range = { 0, 600 },   unit = "s", doc = "time for which the robot learns the room" },
  wait_least = { 0.0, range = { 0, 600 },  unit = "s", doc = "shortest time after learning before the event" },
  wait_most  = { 0.0, range = { 0, 600 },  unit = "s", doc = "longest time after learning before the event; the seed chooses" },
  carry   = { 1.5,   range = { 0.2, 30 },  unit = "s", doc = "time for which the robot is lifted" },
  penalty = { 10.0,  range = { 0.5, 120 }, unit = "s", doc = "duration of the penalty" },
  margin  = { 0.5,   range = { 0, 3 },     unit = "m", doc = "smallest distance from the lines at which a kidnapped robot is placed" },
  timeout = { 60.0,  range = { 1, 36000 }, unit = "s", doc = "time for which the belief is observed" },
}

local memory = keep { x = 0.0, y = 0.0, rotation = 0.0, wait = 0.0 }   -- the belief before the event

local function start_pose()
  local x, y, rotation = ground_truth.start_pose()
  if p.side == "own" then return x, y, rotation end
  return -x, -y, rotation + math.pi
end

local function remember_belief()
  memory.x, memory.y, memory.rotation = pose.x, pose.y, pose.rotation
end

local function put_down_anywhere()
  local x, y = field.length / 2 - p.margin, field.width / 2 - p.margin
  operator.put_down(chance.between(-x, x), chance.between(-y, y), chance.between(-math.pi, math.pi))
end

-- Executes the event; the belief is observed from this moment.
local EVENTS = {
  none = function() end,
  mirrored_placement = function() operator.put_down(-memory.x, -memory.y, memory.rotation + math.pi) end,
  put_back = function() operator.put_down(truth.x, truth.y, truth.rotation) end,
  kidnapped = put_down_anywhere,
  fallen = function() operator.push_over() end,
  penalized = function()
    operator.put_down(start_pose())
    operator.penalize(false)
  end,
  half_time = function() operator.half_time() end,
  misled = function()
    local x, y, rotation = start_pose()
    operator.put_down(x, y, rotation)
    operator.set_initial_pose(-x, -y, rotation + math.pi)
  end,
}

local CARRIED = { mirrored_placement = true, put_back = true, kidnapped = true }

scenario "trial" {
  behaviors = {
    "orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan", "get_up", "penalty_marks",
  },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function()
      local x, y, rotation = start_pose()
      operator.put_down(x, y, rotation)
      operator.set_initial_pose(x, y, rotation)
    end,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "learning" {
    { "waiting", after = "learn", because = "the time to learn is over" },
  },

  state "waiting" {
    enter = function()
      memory.wait = chance.between(p.wait_least, math.max(p.wait_least, p.wait_most))
      operator.change_light()
    end,
    { "carried", when = function() return CARRIED[p.event] and time_in_state() >= memory.wait end,
      because = "the operator lifts the robot" },
    { "out of the game", when = function() return p.event == "penalized" and time_in_state() >= memory.wait end,
      because = "the referee calls the robot" },
    { "measured", when = function() return time_in_state() >= memory.wait end, because = "the waiting time is over" },
  },

  state "carried" {
    enter = function()
      remember_belief()
      operator.pick_up()
    end,
    { "measured", after = "carry", because = "the robot is placed" },
  },

  state "out of the game" {
    enter = function()
      operator.penalize(true)
      operator.pick_up()
    end,
    { "measured", after = "penalty", because = "the penalty is over" },
  },

  state "measured" {
    enter = function()
      ground_truth.note(p.event)
      EVENTS[p.event]()
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
