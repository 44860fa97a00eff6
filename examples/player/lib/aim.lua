--- Where to kick: a direction from the ball into the opponents' goal, by the believed pose.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"
local ball = require "lib.ball"

local p = param {
  margin = { 0.15, range = { 0, 1 }, unit = "rad", doc = "angle beside each goal post at which it does not aim" },
}

local SHORTEST = 0.1   -- m, to the goal line: limits the angles for a ball that lies on this line

local aim = {}

--- Direction of the kick that needs the smallest turn, relative to the robot. Call it only while the ball is known.
---@return number direction rad, positive to the left
function aim.direction()
  local x, y = ball.on_field()
  local ahead = math.max(SHORTEST, field.length / 2 - x)
  local left, right = math.atan(field.goal_post_y - y, ahead), math.atan(-field.goal_post_y - y, ahead)
  local middle, slack = (left + right) / 2, math.max(0.0, (left - right) / 2 - p.margin)
  local best = math.max(middle - slack, math.min(middle + slack, walking.normalize(pose.rotation)))
  return walking.normalize(best - pose.rotation)
end

--- Angle between the line of sight to the ball and the direction of the kick: 0 if the robot stands behind the ball.
--- Call it only while the ball is known.
---@return number angle rad, positive if the robot must go around the ball to its right
function aim.offset()
  local position = input.ball.position
  return walking.normalize(aim.direction() - math.atan(position.y, position.x))
end

return aim
