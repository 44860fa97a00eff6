--- What a field player does around a kick-off: walks to its place in its own half, faces the ball, stands still while the
--- rules want it, and ends when it may go for the ball. Made for `run "kick_off" { x = -1.0 }` in other behaviors.
--
-- It needs the interface `ball`: `reorient game --behaviors striker,...`.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"
local ball = require "lib.ball"

local a = args {
  x     = { -1.2, range = { -10, 0 },  unit = "m", doc = "where to wait for the kick-off, toward the opponents' goal" },
  y     = { 0.0,  range = { -10, 10 }, unit = "m", doc = "where to wait for the kick-off, to the left" },
  takes = { true, doc = "whether this robot takes the kick-offs of its team: then it waits behind the ball" },
}

local p = param {
  behind    = { 0.35, range = { 0.15, 2 }, unit = "m", doc = "distance behind the center mark of a robot that takes the kick-off" },
  margin    = { 0.25, range = { 0, 2 },    unit = "m", doc = "distance of other robots from the center circle and the halfway line" },
  slack     = { 0.3,  range = { 0.1, 2 },  unit = "m", doc = "distance from its place at which it walks again" },
  moved     = { 0.4,  range = { 0.1, 3 },  unit = "m", doc = "distance by which the ball must have moved after the others' kick-off" },
  certain   = { 0.3,  range = { 0, 3 },    unit = "s", doc = "time for which it must have moved" },
  wait_time = { 10.0, range = { 0, 60 },   unit = "s", doc = "time after the others' kick-off after which the ball is free" },
}

-- Where the ball lay before the kick-off, in the robot's frame (m): the robot stands still, so no pose is needed.
local before = keep { is_known = false, x = 0.0, y = 0.0 }

local function is_kicker() return a.takes and game.kick_off == "ours" end

-- Behind the ball, or outside of the center circle in its own half.
local function place()
  if is_kicker() then return -p.behind, 0.0 end
  local x, y = math.min(a.x, -p.margin), a.y
  local least = field.center_circle_radius + p.margin
  if x * x + y * y < least * least then x = -math.sqrt(math.max(least * least - y * y, p.margin * p.margin)) end
  return x, y
end

local function place_x() return (place()) end

local function place_y() return select(2, place()) end

-- Direction from the robot to the ball, or to the center mark while the ball is unknown (rad, on the field).
local function direction()
  if ball.is_known() then
    local seen = input.ball.position
    return walking.normalize(pose.rotation + math.atan(seen.y, seen.x))
  end
  return math.atan(-pose.y, -pose.x)
end

local function is_off_its_place()
  local x, y = place()
  return robot.can_walk and not walking.is_near(x, y, p.slack)
end

local function must_stand() return robot.penalized or game.state == "initial" or game.state == "finished" end

local function is_positioning() return not robot.penalized and game.state == "ready" end

local function is_set() return not robot.penalized and game.state == "set" end

local function is_free() return not robot.penalized and ball.is_in_play() end

local function forget_ball() before.is_known = false end

-- The mean of what the detector measures: far balls have errors of decimeters.
local function note_ball()
  walk.stand()
  if not ball.is_known() then return end
  local seen = input.ball.position
  local share = before.is_known and 0.1 or 1.0
  before.x, before.y = before.x + share * (seen.x - before.x), before.y + share * (seen.y - before.y)
  before.is_known = true
end

local function wait()
  if before.is_known then walk.stand() else note_ball() end
end

local function has_ball_moved()
  if not (before.is_known and ball.is_known()) then return false end
  local dx, dy = input.ball.position.x - before.x, input.ball.position.y - before.y
  return dx * dx + dy * dy > p.moved * p.moved
end

behavior "kick_off" {
  priority = 35,
  initial = "standing",
  common = {
    { "standing", when = must_stand, because = "the robot must stand still" },
    { "positioning", when = is_positioning, because = "the kick-off is near" },
    { "set", when = is_set, because = "the robots must stand still before the kick-off" },
  },

  state "standing" {
    update = function() walk.stand() end,
    run "search_ball" {},
    { "over", when = is_free, because = "the game runs" },
  },

  state "positioning" {
    initial = "walking",
    run "search_ball" {},
    { "over", when = is_free, because = "the game runs" },

    state "walking" {
      run "walk_to" { x = place_x, y = place_y, turns = true, rotation = direction },
      { "there", when = done "walk_to", because = "the robot is at its place" },
      { "there", when = failed "walk_to", because = "it did not get there" },
    },

    state "there" {
      update = function() walk.stand() end,
      { "walking", when = is_off_its_place, lasting = 0.5, because = "its place is elsewhere" },
    },
  },

  state "set" {
    enter = forget_ball,
    update = note_ball,
    run "search_ball" {},
    { "over", when = function() return is_free() and game.kick_off == "ours" end, because = "it is the own kick-off" },
    { "waiting", when = is_free, because = "it is the others' kick-off" },
  },

  state "waiting" {
    update = wait,
    run "search_ball" {},
    { "over", when = has_ball_moved, lasting = "certain", because = "the ball has moved" },
    { "over", after = "wait_time", because = "the ball is free" },
  },

  state "over" { ends = "done" },
}
