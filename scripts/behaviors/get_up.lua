--- Gets up after a fall, once the robot lies still. Does nothing while the robot is lifted.

-- SPDX-License-Identifier: MIT

param {
  rest_time = { 1.0, range = { 0, 10 }, unit = "s", doc = "time for which the robot lies still before it gets up" },
}

local function is_on_its_feet_or_lifted() return robot.posture == "upright" or robot.posture == "lifted" end

behavior "get_up" {
  priority = 90,
  initial = "idle",

  state "idle" {
    { "lying", when = function() return robot.posture == "lying" end, because = "the robot fell" },
  },

  state "lying" {
    update = function() walk.stand() end,
    { "idle", when = function() return robot.posture ~= "lying" end, because = "the robot was helped up" },
    { "getting up", when = function() return robot.can_get_up end, after = "rest_time", because = "the robot lies still" },
  },

  state "getting up" {
    update = function()
      walk.stand()
      motion.get_up()
    end,
    { "idle", when = is_on_its_feet_or_lifted, because = "the robot stands again or is lifted" },
  },
}
