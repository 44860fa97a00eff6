--- Walks to a point behind the ball, from which the robot faces the opponents' goal, with the ball before a foot.
--
-- It needs an application that detects the ball: `reorient run --interface ball`, or `reorient game`. Teammates send how
-- far they are from the ball, so that the nearest one approaches it and the others keep a distance.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"
local ball_library = require "lib.ball"

local p = param {
  distance = { 0.22, range = { 0.1, 1 }, unit = "m", doc = "distance of the ball in front of the robot when it has arrived" },
  foot = { 0.05, range = { 0, 0.3 }, unit = "m", doc = "distance to the side at which the ball lies before a foot" },
  clearance = { 0.45, range = { 0.2, 2 }, unit = "m", doc = "distance from the ball at which the robot walks around it" },
  angle = { 0.25, range = { 0.05, 1.5 }, unit = "rad", doc = "largest error of the robot's direction when it has arrived" },
  precision = { 0.025, range = { 0.01, 0.3 }, unit = "m", doc = "largest distance from the point behind the ball when it has arrived" },
  lead = { 0.3, range = { 0, 3 }, unit = "m", doc = "distance by which a teammate must be nearer to the ball to approach it instead" },
  report_time = { 0.5, range = { 0.1, 10 }, unit = "s", doc = "time between messages to the teammates" },
  trust_time = { 2.0, range = { 0.1, 30 }, unit = "s", doc = "time for which a message of a teammate counts" },
  support = { 1.2, range = { 0.3, 5 }, unit = "m", doc = "distance from the ball that a robot keeps while a teammate approaches it" },
}

local MESSAGE = "^ball (%d+%.%d+)$"   -- distance of the sender from the ball, m
local FAR = 1000.0                    -- m

local memory = keep { teammate_distance = FAR, heard_at = -1000.0, sent_at = -1000.0 }

local function clamp(value, limit) return math.max(-limit, math.min(limit, value)) end

local knows_ball = ball_library.is_known

local function may_play() return robot.may_walk and robot.can_walk and ball_library.is_in_play() end

local function listen()
  for which = 1, team.heard() do
    local distance = tonumber(team.text(which):match(MESSAGE))
    local is_stale = clock.time - memory.heard_at > p.trust_time
    if distance and (is_stale or distance < memory.teammate_distance) then
      memory.teammate_distance, memory.heard_at = distance, clock.time
    end
  end
end

local function report()
  if clock.time - memory.sent_at < p.report_time then return end
  memory.sent_at = clock.time
  team.send(string.format("ball %.2f", input.ball.distance))
end

local function is_teammate_nearer()
  return clock.time - memory.heard_at < p.trust_time and memory.teammate_distance + p.lead < input.ball.distance
end

-- Direction from the ball to the opponents' goal in the robot's frame (rad), by the believed pose.
local function direction_of_kick()
  local x, y = ball_library.on_field()
  return walking.normalize(math.atan(-y, field.length / 2 - x) - pose.rotation)
end

-- Where the robot is to stand, in its own frame (m), and how it is to turn (rad).
local function target()
  local ball = input.ball.position
  local kick = direction_of_kick()
  local cosine, sine = math.cos(kick), math.sin(kick)
  local side = ball.y >= 0 and p.foot or -p.foot
  return ball.x - p.distance * cosine + side * sine, ball.y - p.distance * sine - side * cosine, kick
end

local function has_arrived()
  if not knows_ball() then return false end
  local x, y, turn = target()
  return x * x + y * y < p.precision * p.precision and math.abs(turn) < p.angle
end

-- Far away the robot walks straight at a point behind the ball, and beside the ball if that lies in the way.
local function approach()
  listen()
  if not knows_ball() then return walk.stand() end
  report()
  local x, y, turn = target()
  local ball = input.ball.position
  local distance = math.sqrt(x * x + y * y)
  if input.ball.distance > p.clearance and distance > p.clearance then
    local bearing = math.atan(y, x)
    local forward = math.abs(bearing) < 0.5 and robot.cruise or 0.0
    return walk.velocity(forward, 0.0, clamp(2.0 * bearing, 0.8))
  end
  -- Near the ball: step sideways around it while the ball is between the robot and the point behind it.
  local forward, left = 1.2 * x, 1.2 * y
  if math.abs(turn) > 2 * p.angle then
    local bearing = math.atan(ball.y, ball.x)
    local radial = input.ball.distance - p.clearance
    forward, left = 0.8 * radial * math.cos(bearing), (turn > 0 and -0.12 or 0.12) + 0.8 * radial * math.sin(bearing)
    turn = bearing
  end
  walk.velocity(clamp(forward, robot.cruise), clamp(left, robot.cruise), clamp(1.5 * turn, 0.6))
end

-- Faces the ball at a distance, for the next chance.
local function support()
  listen()
  if not knows_ball() then return walk.stand() end
  local ball = input.ball.position
  local bearing = math.atan(ball.y, ball.x)
  local forward = math.abs(bearing) < 0.5 and 0.5 * (input.ball.distance - p.support) or 0.0
  walk.velocity(clamp(forward, robot.cruise), 0.0, clamp(bearing, 0.6))
end

behavior "approach_ball" {
  priority = 35,
  initial = "waiting",
  common = {
    { "waiting", when = function() return not may_play() end, because = "the robot may not walk" },
    { "waiting", when = function() return not knows_ball() end, because = "the ball is unknown" },
  },

  state "waiting" {
    update = listen,
    { "approaching", when = function() return may_play() and knows_ball() end, because = "the ball is known" },
  },

  state "approaching" {
    update = approach,
    { "supporting", when = is_teammate_nearer, lasting = 0.5, because = "a teammate is nearer to the ball" },
    { "at the ball", when = has_arrived, because = "the ball lies before a foot" },
  },

  state "at the ball" {
    update = function()
      listen()
      walk.stand()
    end,
    { "approaching", when = function() return not has_arrived() end, lasting = 0.5, because = "the ball has moved" },
    { "approaching", after = 5.0, because = "the ball was not kicked" },
  },

  state "supporting" {
    update = support,
    { "approaching", when = function() return not is_teammate_nearer() end, lasting = 0.5, because = "no teammate is nearer to the ball" },
  },
}
