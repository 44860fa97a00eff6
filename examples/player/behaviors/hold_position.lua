--- Returns to a position on the field and holds it: stands there, and returns again if it was moved away.
---
--- Other behaviors run it. It does not end, because its caller decides when something better is to do.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local a = args {
  x = { -1.0, range = { -15, 15 }, unit = "m", doc = "position to hold, toward the opponents' goal" },
  y = { 0.0, range = { -15, 15 }, unit = "m", doc = "position to hold, to the left" },
}

local p = param {
  slack = { 0.4, range = { 0.1, 3 }, unit = "m", doc = "distance from the position at which the robot returns to it" },
  rest = { 3.0, range = { 0, 30 }, unit = "s", doc = "time to stand after the robot did not arrive" },
}

local function position_x() return a.x end

local function position_y() return a.y end

local function is_away() return not walking.is_near(a.x, a.y, p.slack) end

-- At its position, the robot looks at the center of the field.
local function direction() return math.atan(-a.y, -a.x) end

behavior "hold_position" {
  priority = 20,
  initial = "standing",

  state "standing" {
    update = function() walk.stand() end,
    { "returning", when = is_away, because = "the robot is away from its position" },
  },

  state "returning" {
    run "walk_to" { x = position_x, y = position_y, turns = true, rotation = direction, timeout = 60 },
    { "standing", when = done "walk_to", because = "the robot is at its position" },
    { "resting", when = failed "walk_to", because = "the robot did not arrive" },
  },

  state "resting" {
    update = function() walk.stand() end,
    { "standing", after = "rest", because = "the robot tries again" },
  },
}
