--- Looking at a place on the field: with the head where the neck reaches, else by turning the body as well.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local p = param {
  reach = { 1.4,  range = { 0.2, 2.0 },  unit = "rad",   doc = "largest yaw of the head toward a target" },
  pitch = { 0.0,  range = { -0.6, 0.5 }, unit = "rad",   doc = "pitch of the head: a little of the field and much of the wall" },
  speed = { 2.0,  range = { 0.1, 5.0 },  unit = "rad/s", doc = "how fast to turn the head" },
  turn  = { 0.5,  range = { 0.1, 2 },    unit = "rad/s", doc = "how fast to turn the body" },
  near  = { 0.15, range = { 0.02, 1 },   unit = "rad",   doc = "largest angle between the target and the middle of the view" },
}

local gaze = {}

--- How far the head has to turn from where it is until a point of the field is straight ahead of it.
---@param x number m
---@param y number m
---@return number angle rad, never negative
function gaze.angle_to(x, y)
  local _, bearing = walking.distance_and_bearing(x, y)
  return math.abs(bearing - robot.head_yaw)
end

--- Whether the robot looks at a point of the field, by the pose that it believes in.
---@param x number m
---@param y number m
---@return boolean
function gaze.is_at(x, y) return gaze.angle_to(x, y) < p.near end

--- One frame's look at a point of the field; the body turns while the neck alone does not reach it, else it stands.
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
