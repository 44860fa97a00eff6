--- Walks to the ball and around it, until the ball lies before a foot and a kick can reach the direction of the goal.
---
--- Other behaviors run it. It needs the interface `ball`.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"
local ball = require "lib.ball"
local aim = require "lib.aim"

local p = param {
  near = { 0.8, range = { 0.3, 3 }, unit = "m", doc = "distance of the ball below which the robot faces it" },
  clearance = { 0.35, range = { 0.2, 1 }, unit = "m", doc = "distance from the ball while walking around it" },
  behind = { 0.8, range = { 0.05, 1.5 }, unit = "rad", doc = "largest offset (lib.aim) at which it closes in" },
  aside = { 1.1, range = { 0.1, 2 }, unit = "rad", doc = "offset (lib.aim) at which it walks around again" },
  ahead = { 0.19, range = { 0.1, 0.4 }, unit = "m", doc = "distance of the ball ahead to which it closes in" },
  reach = { 0.26, range = { 0.1, 0.4 }, unit = "m", doc = "largest distance of the ball ahead at the end" },
  beside = { 0.05, range = { 0, 0.2 }, unit = "m", doc = "distance of the ball to the side, that of a foot" },
  side = { 0.07, range = { 0.01, 0.1 }, unit = "m", doc = "largest distance of the ball beside that foot at the end" },
  angle = { 0.9, range = { 0.05, 1 }, unit = "rad", doc = "largest angle of the kick at the end" },
  turn = { 0.8, range = { 0.1, 2 }, unit = "rad/s", doc = "largest rotation speed" },
  post = { 0.6, range = { 0, 2 }, unit = "m", doc = "distance beside a post at which it leaves the goal line" },
  line = { 0.35, range = { 0, 2 }, unit = "m", doc = "distance from the goal line at which a post is in the way" },
  speed = { 0.25, range = { 0.05, 0.5 }, unit = "m/s", doc = "walking speed far from the ball" },
  slowest = { 0.04, range = { 0, 0.2 }, unit = "m/s", doc = "lowest walking speed near the ball" },
}

local AHEAD = 0.5   -- rad: largest bearing at which a robot far from the ball walks while it turns

local function clamp(value, limit) return math.max(-limit, math.min(limit, value)) end

local function bearing() return math.atan(input.ball.position.y, input.ball.position.x) end

local function is_near() return ball.is_known() and input.ball.distance < p.near end

local function is_far() return ball.is_known() and input.ball.distance > 1.3 * p.near end

local function is_behind() return ball.is_known() and math.abs(aim.offset()) < p.behind end

local function is_aside() return ball.is_known() and math.abs(aim.offset()) > p.aside end

-- A robot that walks along the goal line would be stopped by a goal post or by the net.
local function is_at_a_goal()
  return math.abs(pose.x) > field.length / 2 - p.line and math.abs(pose.y) < field.goal_post_y + p.post
end

local function has_left_the_goal() return math.abs(pose.x) < field.length / 2 - 2 * p.line end

-- From the robot to the position where the ball lies before the nearer foot (m).
local function remaining()
  local position = input.ball.position
  return position.x - p.ahead, position.y - (position.y >= 0 and p.beside or -p.beside)
end

local function is_at_the_ball()
  if not ball.is_known() then return false end
  local x, y = remaining()
  local is_before_a_foot = input.ball.position.x > 0 and x < p.reach - p.ahead and math.abs(y) < p.side
  return is_before_a_foot and math.abs(aim.direction()) < p.angle
end

-- Direction of walking past the ball at the clearance, on the side that leads behind the ball (rad).
local function heading()
  local offset = aim.offset()
  local widest = math.asin(math.min(1.0, p.clearance / input.ball.distance))
  return bearing() - clamp(offset, widest)
end

local function walk_far()
  if not ball.is_known() then return walk.stand() end
  local turn = heading()
  walk.velocity(math.abs(turn) < AHEAD and p.speed or 0.0, 0.0, clamp(2.0 * turn, p.turn))
end

local function leave_the_goal()
  local _, direction = walking.distance_and_bearing(0.0, pose.y)
  walk.velocity(robot.cruise * math.cos(direction), robot.cruise * math.sin(direction), 0.0)
end

local function walk_around()
  if not ball.is_known() then return walk.stand() end
  local direction = heading()
  local away = 2.0 * math.max(0.0, p.clearance - input.ball.distance)
  local forward = robot.cruise * math.cos(direction) - away * math.cos(bearing())
  local left = robot.cruise * math.sin(direction) - away * math.sin(bearing())
  walk.velocity(clamp(forward, robot.cruise), clamp(left, robot.cruise), clamp(2.0 * bearing(), p.turn))
end

local function close_in()
  if not ball.is_known() then return walk.stand() end
  local x, y = remaining()
  local distance = math.max(0.001, math.sqrt(x * x + y * y))
  local speed = math.min(p.speed, math.max(p.slowest, distance))
  walk.velocity(speed * x / distance, speed * y / distance, clamp(1.5 * aim.direction(), p.turn))
end

behavior "line_up" {
  priority = 20,
  initial = "far",
  common = {
    { "at the ball", when = is_at_the_ball, because = "the ball lies before a foot, and the goal is ahead" },
  },

  state "far" {
    update = walk_far,
    { "around", when = is_near, because = "the ball is near" },
    { "leaving the goal", when = is_at_a_goal, because = "a goal post is in the way" },
  },

  state "leaving the goal" {
    update = leave_the_goal,
    { "around", when = is_near, because = "the ball is near" },
    { "far", when = has_left_the_goal, because = "the goal is free" },
  },

  state "around" {
    update = walk_around,
    { "far", when = is_far, because = "the ball is far again" },
    { "closing in", when = is_behind, because = "the robot is behind the ball" },
  },

  state "closing in" {
    update = close_in,
    { "far", when = is_far, because = "the ball is far again" },
    { "around", when = is_aside, because = "the robot is not behind the ball any more" },
  },

  state "at the ball" { ends = "done" },
}
