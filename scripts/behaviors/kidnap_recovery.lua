--- Finds the pose of a robot that was lifted. Back on its feet, the robot stays at its position and turns, so that room
--- awareness and self-localization see all around it. Nothing is learned until the room has supported the believed pose for
--- long enough. If neither pose wins, the orientation is reset once. The behavior orientation decides on flips and purges.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"
local walking = require "lib.walk"

local p = param {
  lift_time      = { 0.5,  range = { 0, 5 },   unit = "s",     doc = "time for which the robot must be lifted" },
  share          = { 0.4,  range = { 0, 1 },                   doc = "smallest confidence in the believed pose for a recovery" },
  hold_time      = { 3.0,  range = { 0, 20 },  unit = "s",     doc = "time for which the room must support the believed pose" },
  cluster_weight = { 0.6,  range = { 0, 1 },                   doc = "fraction of the particles that must agree on the believed pose" },
  recovery_probability = { 0.1, range = { 0, 1 },              doc = "largest pose.recovery_probability (the position must fit, too)" },
  timeout        = { 25.0, range = { 1, 120 }, unit = "s",     doc = "longest search before a reset of the orientation, and after it" },
  no_goal_time   = { 3.0,  range = { 0, 20 },  unit = "s",     doc = "time without a goal in view before the reset (a goal may help)" },
  longest        = { 90.0, range = { 5, 600 }, unit = "s",     doc = "longest search with the believed pose, independent of the room" },
  turn           = { 0.4,  range = { 0, 2 },   unit = "rad/s", doc = "rotation speed on the spot during the search" },
}

local memory = keep { put_down_at = 0.0 }

local function is_pose_found()
  return pose.cluster_weight >= p.cluster_weight and pose.recovery_probability <= p.recovery_probability
end

local function room_supports_the_pose()
  local is_right_way_round = confidence.status == "usable" and decision.for_believed()
  return is_right_way_round and confidence.current > p.share and is_pose_found()
end

local function can_search() return robot.time_since_disturbance > 0.0 and robot.may_walk end

-- In a symmetric room, an orientation that was reset would be found again only at random.
local function is_stuck() return confidence.can_tell and not decision.for_either() and seen.goal_posts == 0 end

behavior "kidnap_recovery" {
  priority = 25,
  initial = "undisturbed",
  common = {
    { "lifted",
      when = function() return robot.posture == "lifted" end,
      lasting = "lift_time", because = "the robot is lifted" },
  },

  state "undisturbed" {},

  -- A robot that may not move (penalized, or before the game) cannot turn: its search starts when it may.
  state "lifted" {
    enter = function() command.pause_training() end,
    exit = function() memory.put_down_at = clock.time end,
    { "searching", when = function() return robot.time_since_disturbance > 0.0 end, because = "the robot stands at an unknown position" },
  },

  state "searching" {
    publishes = "pose_is_searched",
    initial = "with its belief",
    enter = function() command.pause_training() end,
    update = function() walking.turn(p.turn) end,
    { "recovered", when = room_supports_the_pose, lasting = "hold_time", because = "the room supports the believed pose" },
    { "interrupted", when = function() return not can_search() end, because = "the robot cannot search at present" },

    state "with its belief" {
      { "with any orientation", when = is_stuck, lasting = "no_goal_time", after = "timeout", because = "neither pose won" },
      { "lost", when = function() return not confidence.can_tell end, after = "timeout",
        because = "the room cannot distinguish the poses" },
      { "lost", after = "longest", because = "the room supports a pose, but the position does not fit" },
    },

    state "with any orientation" {
      enter = function() command.reset_orientation() end,
      { "lost", after = "timeout", because = "neither pose won again" },
    },
  },

  -- It fell, is penalized or waits for the kick-off: this time does not count as search.
  state "interrupted" {
    publishes = "pose_is_searched",
    enter = function() command.pause_training() end,
    { "recovered", when = room_supports_the_pose, lasting = "hold_time", because = "the room supports the believed pose" },
    { "searching", when = can_search, because = "the robot can search again" },
  },

  state "lost" {
    enter = function()
      command.pause_training()
      log.info("the pose is still unconfirmed; continues with it")
    end,
    { "recovered", when = room_supports_the_pose, lasting = "hold_time", because = "the room supports the believed pose" },
  },

  state "recovered" {
    enter = function() log.info(string.format("recovered %.1f s after it was placed", clock.time - memory.put_down_at)) end,
  },
}
