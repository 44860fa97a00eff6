--- Looks at a point on the field: with the head within the reach of the neck, otherwise by turning the body, too.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local p = param {
  reach = { 1.4,  range = { 0.2, 2.0 },  unit = "rad",   doc = "largest yaw of the head toward a target" },
  pitch = { 0.0,  range = { -0.6, 0.5 }, unit = "rad",   doc = "pitch of the head, positive downward" },
  speed = { 2.0,  range = { 0.1, 5.0 },  unit = "rad/s", doc = "rotation speed of the head" },
  turn  = { 0.5,  range = { 0.1, 2 },    unit = "rad/s", doc = "rotation speed of the body" },
  near  = { 0.15, range = { 0.02, 1 },   unit = "rad",   doc = "largest angle between the target and the middle of the view" },
}

local gaze = {}

--- Angle by which the head must turn to look straight at a point of the field.
---@param x number m
---@param y number m
---@return number angle rad, never negative
function gaze.angle_to(x, y)
  local _, bearing = walking.distance_and_bearing(x, y)
  return math.abs(bearing - robot.head_yaw)
end

--- Whether the robot looks at a point of the field, by the believed pose.
---@param x number m
---@param y number m
---@return boolean
function gaze.is_at(x, y) return gaze.angle_to(x, y) < p.near end

--- Looks at a point of the field for one frame; the body turns if the neck alone cannot reach it, otherwise it stands.
---@param x number m
---@param y number m
function gaze.at(x, y)
  local _, bearing = walking.distance_and_bearing(x, y)
  local reach = math.min(p.reach, robot.head_reach)
  head.look(math.max(-reach, math.min(reach, bearing)), p.pitch, p.speed)
  if math.abs(bearing) > reach then
    walking.turn(bearing > 0 and p.turn or -p.turn)
  else
    walk.stand()
  end
end

return gaze
