--- Walks to a point on the field by the believed pose. Made for `run "walk_to" { x = 1.0 }` in other behaviors.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local a = args {
  x         = { 0.0,  range = { -15, 15 },     unit = "m",   doc = "where to walk, toward the opponents' goal" },
  y         = { 0.0,  range = { -15, 15 },     unit = "m",   doc = "where to walk, to the left" },
  turns     = { false,                                       doc = "whether to turn to `rotation` there" },
  rotation  = { 0.0,  range = { -3.15, 3.15 }, unit = "rad", doc = "direction to turn to: 0 toward the opponents' goal" },
  tolerance = { 0.15, range = { 0.01, 5 },     unit = "m",   doc = "distance at which the robot has arrived" },
  timeout   = { 60.0, range = { 1, 3600 },     unit = "s",   doc = "time after which it gives up" },
}

local p = param {
  angle   = { 0.15, range = { 0.01, 3.2 }, unit = "rad", doc = "error of direction at which the robot has arrived" },
  settled = { 0.2,  range = { 0, 5 },      unit = "s",   doc = "time for which the robot must be there" },
}

local function step() walking.walk_to(a.x, a.y, a.turns and a.rotation or nil) end

local function has_arrived()
  local error = walking.normalize(a.rotation - pose.rotation)
  return walking.is_near(a.x, a.y, a.tolerance) and (not a.turns or math.abs(error) < p.angle)
end

behavior "walk_to" {
  priority = 20,
  initial = "walking",

  state "walking" {
    update = step,
    { "unable", when = function() return not robot.can_walk end, because = "this body cannot walk" },
    { "there", when = has_arrived, lasting = "settled", because = "the robot has arrived" },
    { "given up", after = "timeout", because = "it took too long" },
  },

  state "there" { ends = "done" },
  state "unable" { ends = "failed" },
  state "given up" { ends = "failed" },
}
