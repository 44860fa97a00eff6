--- Walks to a point on the field by the believed pose.

-- SPDX-License-Identifier: MIT

local p = param {
  speed    = { 1.0, range = { 0, 2 },                   doc = "forward speed as a fraction of robot.cruise" },
  turn     = { 0.6, range = { 0, 2 },   unit = "rad/s", doc = "rotation speed" },
  near     = { 0.3, range = { 0, 2 },   unit = "m",     doc = "distance below which it walks slower and does not turn to the target" },
  aligned  = { 0.4, range = { 0, 3.2 }, unit = "rad",   doc = "largest bearing at which it walks while turning; above, it turns in place" },
  distance = { 0.1, range = { 0, 1 },   unit = "m",     doc = "distance at which the robot counts as arrived" },
  angle    = { 0.1, range = { 0, 3.2 }, unit = "rad",   doc = "error of direction at which the robot counts as arrived" },
}

local walk_library = {}

--- The same direction in (-pi, pi].
---@param angle number rad
---@return number angle rad
function walk_library.normalize(angle)
  local turned = angle % (2 * math.pi)
  if turned > math.pi then turned = turned - 2 * math.pi end
  return turned
end

local function forward_speed() return p.speed * robot.cruise end   -- m/s

local function clamp(value, limit) return math.max(-limit, math.min(limit, value)) end

--- Distance and bearing of a point on the field from the robot.
---@param x number m
---@param y number m
---@return number distance m
---@return number bearing rad, positive to the left of straight ahead
function walk_library.distance_and_bearing(x, y)
  local dx, dy = x - pose.x, y - pose.y
  return math.sqrt(dx * dx + dy * dy), walk_library.normalize(math.atan(dy, dx) - pose.rotation)
end

--- Whether the robot believes that it stands near a point.
---@param x number m
---@param y number m
---@param distance number m
---@return boolean
function walk_library.is_near(x, y, distance) return (walk_library.distance_and_bearing(x, y)) <= distance end

--- Walks toward a point for one frame; there it turns to `rotation` if given.
---@param x number m
---@param y number m
---@param rotation? number rad
---@return boolean has_arrived
function walk_library.walk_to(x, y, rotation)
  local distance, bearing = walk_library.distance_and_bearing(x, y)
  if distance > p.near then
    local forward = math.abs(bearing) < p.aligned and forward_speed() or 0.0
    walk.velocity(forward, 0.0, clamp(2.0 * bearing, p.turn))
    return false
  end
  local error = rotation and walk_library.normalize(rotation - pose.rotation) or 0.0
  if distance > p.distance then
    local speed = math.min(forward_speed(), distance)
    walk.velocity(speed * math.cos(bearing), speed * math.sin(bearing), clamp(error, p.turn))
    return false
  end
  if math.abs(error) > p.angle then
    walk.velocity(0.0, 0.0, clamp(2.0 * error, p.turn))
    return false
  end
  walk.stand()
  return true
end

--- Turns on the spot for one frame.
---@param speed number rad/s, to the left
function walk_library.turn(speed) walk.velocity(0.0, 0.0, speed) end

return walk_library
