--- A robot learns the room at one or a few places and is asked at another one. Objects between the robot and the virtual
--- wall, and walls nearer or farther than it, then appear beside the tiles where they were learned (parallax). The robot is
--- told either its true pose or the reflection of it, and its belief is watched from then on.

local ground_truth = require "lib.ground_truth"

local p = param {
  places   = { 1,     range = { 1, 8 }, integer = true, doc = "at how many places the room is learned" },
  headings = { 8,     range = { 1, 32 }, integer = true, doc = "how many headings the body has at each place, evenly spread" },
  learn    = { 60.0,  range = { 1, 600 }, unit = "s", doc = "how long the room is learned, at all places together" },
  reach_x  = { 3.0,   range = { 0, 20 },  unit = "m", doc = "how far from the field's center the places are at most, along the field" },
  reach_y  = { 2.0,   range = { 0, 20 },  unit = "m", doc = "the same across the field" },
  told     = { "truth", choices = { "truth", "reflection" }, doc = "which pose the robot is told at the end" },
  carry    = { 1.5,   range = { 0.2, 30 }, unit = "s", doc = "how long the robot is in the air" },
  watch    = { 10.0,  range = { 1, 600 }, unit = "s", doc = "how long its belief is watched" },
}

local STAND = 1.0   -- s between the moment when the robot is put down and the one when it is told its pose

local memory = keep { heading = 0, place = 0, x = 0.0, y = 0.0, rotation = 0.0 }

local function somewhere(share)
  return chance.between(-share * p.reach_x, share * p.reach_x), chance.between(-share * p.reach_y, share * p.reach_y),
    chance.between(-math.pi, math.pi)
end

local function time_of_a_heading() return p.learn / (p.places * p.headings) end

local function put_down(x, y, rotation)
  experimenter.put_down(x, y, rotation)
  experimenter.set_initial_pose(x, y, rotation)
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
    { "learning", after = 0.1, because = "the robot was told where it stands" },
  },

  state "learning" {
    { "carrying",
      when = function() return memory.heading >= p.headings and memory.place >= p.places and time_in_state() >= time_of_a_heading() end,
      because = "the time to learn is over" },
    { "placing",
      when = function() return memory.heading >= p.headings and time_in_state() >= time_of_a_heading() end,
      because = "the room is learned at another place as well" },
    { "turning", when = function() return time_in_state() >= time_of_a_heading() end, because = "the body turns" },
  },

  state "turning" {
    enter = function()
      memory.heading = memory.heading + 1
      put_down(memory.x, memory.y, memory.rotation + 2 * math.pi * (memory.heading - 1) / p.headings)
    end,
    { "learning", after = 0.1, because = "the robot was told where it stands" },
  },

  state "carrying" {
    enter = function()
      experimenter.change_light()
      experimenter.pick_up()
    end,
    { "standing", after = "carry", because = "the robot is put down elsewhere" },
  },

  state "standing" {
    enter = function() experimenter.put_down(somewhere(1.2)) end,
    { "told", after = STAND, because = "somebody tells the robot where it stands" },
  },

  state "told" {
    enter = function()
      if p.told == "truth" then
        experimenter.set_initial_pose(truth.x, truth.y, truth.rotation)
      else
        experimenter.set_initial_pose(-truth.x, -truth.y, truth.rotation + math.pi)
      end
      ground_truth.note("told the " .. p.told)
    end,
    { "right", when = ground_truth.is_belief_right, after = "watch", because = "the time is up and the belief is right" },
    { "wrong", after = "watch", because = "the time is up and the belief is wrong" },
  },

  state "right" {
    enter = function() verdict.succeed("in the end the belief is " .. ground_truth.error_in_words()) end,
  },

  state "wrong" {
    enter = function() verdict.fail("in the end the belief is " .. ground_truth.error_in_words()) end,
  },
}
