--- A complete field player: obeys the referee, holds its position before a kick-off, finds the ball, walks to it and
--- kicks it toward the opponents' goal.
---
--- It needs the interface `ball`, and beside it the behaviors `get_up`, `orientation`, `background_training` and
--- `kidnap_recovery`: `reorient game --behaviors player,get_up,...`.

-- SPDX-License-Identifier: MIT

local ball = require "lib.ball"
local decision = require "lib.decision"

local p = param {
  home_x = { -1.2, range = { -10, 0 }, unit = "m", doc = "position without a task, toward the opponents' goal" },
  home_y = { 0.0, range = { -10, 10 }, unit = "m", doc = "position without a task, to the left" },
  kick_off_time = { 10.0, range = { 0, 60 }, unit = "s", doc = "time in which the kick-off team alone plays the ball" },
  moved = { 0.4, range = { 0.1, 3 }, unit = "m", doc = "distance from the center at which a kick-off has been taken" },
  search_time = { 25.0, range = { 1, 300 }, unit = "s", doc = "time of a search before it returns to its position" },
  orient_time = { 5.0, range = { 0, 60 }, unit = "s", doc = "longest time to look at the room before the robot plays" },
}

local memory = keep { waits_for_kick_off = false }

-- What the robot must do now, by its body and by the referee.
local function duty()
  if robot.posture ~= "upright" then return "lie" end
  if robot.penalized then return "sit out" end
  if game.stopped then return "wait" end
  if published.pose_is_searched and robot.may_walk then return "find itself" end
  if game.state == "ready" then return "take position" end
  if ball.is_in_play() then return "play" end
  return "wait"
end

local function must(what)
  return function() return duty() == what end
end

local function has_been_kicked_off()
  if not ball.is_known() then return false end
  local x, y = ball.on_field()
  return math.sqrt(x * x + y * y) > p.moved
end

local function belongs_to_opponents() return memory.waits_for_kick_off and game.kick_off == "theirs" end

local function is_free() return not belongs_to_opponents() end

-- Right after a fall, the evaluation of the room still rests, so confidence.can_tell comes too late.
local function must_orient()
  local status = confidence.status
  return not pose.known and status ~= "off" and status ~= "unlearned" and status ~= "symmetric"
end

local function is_oriented() return pose.known or confidence.status == "usable" and decision.for_believed() end

local function home_x() return p.home_x end

local function home_y() return p.home_y end

behavior "player" {
  priority = 35,
  initial = "waiting",
  common = {
    { "down", when = must "lie", because = "the robot does not stand on its feet" },
    { "sitting out", when = must "sit out", because = "the referee has penalized the robot" },
    { "waiting", when = must "wait", because = "the referee does not let the robots play" },
    { "finding itself", when = must "find itself", because = "kidnap_recovery searches the pose" },
    { "taking position", when = must "take position", because = "the kick-off comes soon" },
    { "playing", when = must "play", because = "the ball is in play" },
  },

  -- The behavior get_up acts here.
  state "down" {},

  -- The behavior kidnap_recovery turns the body here.
  state "finding itself" {
    run "wall_gaze" {},
  },

  state "sitting out" {
    run "wall_gaze" {},
    run "search_ball" {},
    update = function() walk.stand() end,
  },

  state "waiting" {
    run "wall_gaze" {},
    run "search_ball" {},
    enter = function() memory.waits_for_kick_off = true end,
    update = function() walk.stand() end,
  },

  state "taking position" {
    run "hold_position" { x = home_x, y = home_y },
    run "wall_gaze" {},
    run "search_ball" {},
  },

  state "playing" {
    initial = "deciding",

    state "deciding" {
      update = function() walk.stand() end,
      { "letting them kick off", when = belongs_to_opponents, because = "the opponents kick off" },
      { "orienting", when = must_orient, because = "the orientation is unknown" },
      { "searching", when = is_free, because = "the ball is free" },
    },

    state "letting them kick off" {
      run "find_ball" {},
      update = function() walk.stand() end,
      exit = function() memory.waits_for_kick_off = false end,
      { "searching", when = has_been_kicked_off, lasting = 0.2, because = "the opponents have kicked off" },
      { "searching", after = "kick_off_time", because = "the time of the kick-off is over" },
    },

    state "orienting" {
      run "wall_gaze" {},
      run "search_ball" {},
      update = function() walk.stand() end,
      { "searching", when = is_oriented, because = "the orientation is known" },
      { "searching", after = "orient_time", because = "the room does not decide in time" },
    },

    state "searching" {
      run "find_ball" {},
      { "lining up", when = ball.is_known, because = "the ball is known" },
      { "returning", after = "search_time", because = "the ball was not found" },
    },

    state "returning" {
      run "hold_position" { x = home_x, y = home_y },
      run "find_ball" {},
      { "lining up", when = ball.is_known, because = "the ball is known" },
      { "searching", when = function() return called.hold_position.state == "standing" end, after = 1.0,
        because = "the robot is at its position" },
    },

    state "lining up" {
      run "line_up" {},
      run "find_ball" {},
      { "shooting", when = done "line_up", because = "the ball lies before a foot" },
      { "searching", when = function() return not ball.is_known() end, because = "the ball is lost" },
    },

    state "shooting" {
      run "shoot" {},
      run "find_ball" {},
      { "searching", when = done "shoot", because = "the robot has kicked" },
      { "searching", when = failed "shoot", because = "the robot could not kick" },
    },
  },
}
