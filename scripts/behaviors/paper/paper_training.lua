--- The training rule of the paper (Sections 3.3, 3.5 and 4): a robot that knows its pose but not the room pauses the
--- evaluation and rotates to learn the room; after that the room is trained online in every frame. Only a fall, a lift or a
--- penalty interrupts the training. A robot with a wrong belief learns a wrong room, which causes the paper's 15 % of
--- failures.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local p = param {
  turn     = { 0.6,  range = { 0, 2 },   unit = "rad/s", doc = "rotation speed while the room is learned" },
  min_time = { 20.0, range = { 0, 600 }, unit = "s",     doc = "training time before the evaluation starts" },
}

local function is_disturbed() return robot.time_since_disturbance == 0.0 end

local function is_learned() return training.seconds >= p.min_time end

behavior "paper_training" {
  priority = 45,
  initial = "waiting",
  common = {
    { "disturbed", when = is_disturbed, because = "the robot falls, is lifted or is penalized" },
  },

  state "disturbed" {
    enter = function()
      command.pause_training()
      command.pause_evaluation()
    end,
    { "waiting", when = function() return not is_disturbed() end, because = "the robot stands on the field" },
  },

  state "waiting" {
    enter = function() command.pause_evaluation() end,
    { "training online", when = is_learned, because = "the room is known" },
    { "learning", when = function() return pose.known end, because = "the pose is known, the room is unknown" },
  },

  state "learning" {
    enter = function() command.pause_evaluation() end,
    update = function() walking.turn(p.turn) end,
    { "training online", when = is_learned, because = "the room is known" },
  },

  state "training online" {},
}
