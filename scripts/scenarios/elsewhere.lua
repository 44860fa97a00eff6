--- A robot learns the room at one or more places and is then tested at another one. Objects in front of the virtual wall, and
--- walls nearer or farther than it, appear there beside the tiles where the robot learned them (parallax). At the end the
--- scenario sets either the true pose or the mirrored pose as initial pose, and then observes the belief.

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"

local p = param {
  places   = { 1,     range = { 1, 8 }, integer = true, doc = "number of places where the robot learns the room" },
  headings = { 8,     range = { 1, 32 }, integer = true, doc = "number of body headings at each place, evenly distributed" },
  learn    = { 60.0,  range = { 1, 600 }, unit = "s", doc = "learning time at all places together" },
  reach_x  = { 3.0,   range = { 0, 20 },  unit = "m", doc = "largest distance of a place from the field center along the field" },
  reach_y  = { 2.0,   range = { 0, 20 },  unit = "m", doc = "largest distance of a place from the field center across the field" },
  told     = { "truth", choices = { "truth", "reflection" }, doc = "initial pose that is set at the end: true or mirrored" },
  carry    = { 1.5,   range = { 0.2, 30 }, unit = "s", doc = "time for which the robot is lifted" },
  watch    = { 10.0,  range = { 1, 600 }, unit = "s", doc = "time for which the belief is observed" },
}

local STAND = 1.0   -- s on the ground before the initial pose is set

local memory = keep { heading = 0, place = 0, x = 0.0, y = 0.0, rotation = 0.0 }

local function somewhere(share)
  return chance.between(-share * p.reach_x, share * p.reach_x), chance.between(-share * p.reach_y, share * p.reach_y),
    chance.between(-math.pi, math.pi)
end

local function is_heading_learned() return time_in_state() >= p.learn / (p.places * p.headings) end

local function is_place_learned() return memory.heading >= p.headings and is_heading_learned() end

local function put_down(x, y, rotation)
  operator.put_down(x, y, rotation)
  operator.set_initial_pose(x, y, rotation)
end

scenario "elsewhere" {
  behaviors = { "orientation", "background_training", "wall_gaze", "head_scan" },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function()
      memory.place, memory.heading = memory.place + 1, 1
      memory.x, memory.y, memory.rotation = somewhere(1.0)
      put_down(memory.x, memory.y, memory.rotation)
    end,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "learning" {
    { "carrying",
      when = function() return memory.place >= p.places and is_place_learned() end,
      because = "the time to learn is over" },
    { "placing", when = is_place_learned, because = "the robot continues at another place" },
    { "turning", when = is_heading_learned, because = "the body turns" },
  },

  state "turning" {
    enter = function()
      memory.heading = memory.heading + 1
      put_down(memory.x, memory.y, memory.rotation + 2 * math.pi * (memory.heading - 1) / p.headings)
    end,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "carrying" {
    enter = function()
      operator.change_light()
      operator.pick_up()
    end,
    { "standing", after = "carry", because = "the robot is placed elsewhere" },
  },

  state "standing" {
    enter = function() operator.put_down(somewhere(1.2)) end,
    { "told", after = STAND, because = "the initial pose is set" },
  },

  state "told" {
    enter = function()
      if p.told == "truth" then
        operator.set_initial_pose(truth.x, truth.y, truth.rotation)
      else
        operator.set_initial_pose(-truth.x, -truth.y, truth.rotation + math.pi)
      end
      ground_truth.note("initial pose: " .. p.told)
    end,
    { "right", when = ground_truth.is_belief_right, after = "watch", because = "the time is up and the belief is right" },
    { "wrong", after = "watch", because = "the time is up and the belief is wrong" },
  },

  state "right" {
    enter = function() ground_truth.give_verdict(true) end,
  },

  state "wrong" {
    enter = function() ground_truth.give_verdict(false) end,
  },
}
