--- The decisions of the paper, to the letter (Sections 3.1 and 3.5): whichever pose wins is acted on, always, and the
--- orientation is reset after a fall. There is no question whether the room can tell its two ends apart, nor whether
--- enough of it is known. Goes with `--params paper`, where every command starts the confidences from zero.

-- SPDX-License-Identifier: MIT

local p = param {
  lead     = { 0.3, range = { 0, 1 },              doc = "difference of the confidences at which the greater one wins" },
  min_time = { 3.0, range = { 0, 30 }, unit = "s", doc = "waiting time after a command until its effect shows" },
}

local function lead() return confidence.current - confidence.opposite end

behavior "paper_orientation" {
  priority = 50,
  initial = "watching",
  common = {
    { "fallen", when = function() return robot.posture == "lying" end, because = "the robot fell" },
  },

  state "watching" {
    { "flipping", when = function() return lead() < -p.lead end, because = "the reflected pose wins" },
    { "purging", when = function() return lead() > p.lead end, because = "the current pose wins" },
  },

  state "flipping" {
    enter = function() command.flip_pose() end,
    { "watching", after = "min_time" },
  },

  state "purging" {
    enter = function() command.purge_reflection() end,
    { "watching", after = "min_time" },
  },

  state "fallen" {
    { "resetting", when = function() return robot.posture == "upright" end, because = "the robot got up again" },
  },

  state "resetting" {
    enter = function() command.reset_orientation() end,
    { "watching", after = "min_time" },
  },
}
