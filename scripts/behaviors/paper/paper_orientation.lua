--- The decisions of the paper (Sections 3.1 and 3.5): every pose that wins causes a command, and the orientation is reset
--- after a fall. It does not check whether the room is symmetric or learned enough. Use it with `--params paper`, where
--- every command resets the confidences to zero.

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
    { "flipping", when = function() return lead() < -p.lead end, because = "the mirrored pose wins" },
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
