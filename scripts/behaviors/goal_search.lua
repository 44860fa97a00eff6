--- Looks for the goals. A robot with an unconfirmed orientation stands still and looks in turn at the believed positions of
--- both goals: the wall there distinguishes the ends of the field, and the posts show the position. It decides nothing; it
--- only provides views for the behaviors that decide. If no goal post is in view at either position, the belief is wrong,
--- so the search ends.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"
local gaze = require "lib.gaze"

param {
  hold_time = { 1.0,  range = { 0, 10 },   unit = "s", doc = "time for which the room must support one pose to end the search" },
  unsure_time = { 10.0, range = { 0, 60 }, unit = "s", doc = "time for which the room may support neither pose before the search starts" },
  unsure_time_after_disturbance = { 4.0, range = { 0, 60 }, unit = "s",
                doc = "the same time directly after a disturbance; the normal scan of the head is often enough then" },
  timeout   = { 20.0, range = { 1, 120 },  unit = "s", doc = "longest time of a search" },
  dwell     = { 1.0,  range = { 0, 10 },   unit = "s", doc = "time to look at one goal" },
  reach_timeout = { 8.0, range = { 0.5, 60 }, unit = "s", doc = "time after which to try the other goal if the head cannot reach it" },
}

local memory = keep { looks = 0, is_there = false, saw_posts = false }   -- of this search; is_there: the head, now

local function opponent_goal() return field.length / 2, 0.0 end

local function own_goal() return -field.length / 2, 0.0 end

-- Looking at the goals does not help in an unknown or symmetric room. After a
-- disturbance the head scans as usual until the confidences are valid.
local function is_unsure()
  return confidence.can_tell and confidence.status ~= "fresh" and not decision.for_either()
end

local function is_sure() return not is_unsure() end

local function is_disturbed() return robot.time_since_disturbance == 0.0 end

local function is_opponent_goal_nearer() return gaze.angle_to(opponent_goal()) <= gaze.angle_to(own_goal()) end

local function look_for_posts(x, y)
  gaze.at(x, y)
  memory.is_there = gaze.is_at(x, y)
  if seen.goal_posts > 0 and memory.is_there then memory.saw_posts = true end
end

-- A goal that the head cannot reach gives no information about the belief.
local function note_look()
  if memory.is_there then memory.looks = memory.looks + 1 end
end

local function is_belief_worthless() return memory.looks >= 2 and not memory.saw_posts end

behavior "goal_search" {
  priority = 30,
  initial = "resting",
  common = {
    { "disturbed", when = is_disturbed, because = "the robot is not upright on the field, or is penalized" },
  },

  state "resting" {
    { "searching", when = is_unsure, lasting = "unsure_time", because = "the room supports neither pose" },
  },

  state "disturbed" {
    { "put down", when = function() return not is_disturbed() end, because = "the robot may stand elsewhere than before" },
  },

  state "put down" {
    { "searching", when = is_unsure, lasting = "unsure_time_after_disturbance", because = "no pose is supported since the disturbance" },
    { "resting",
      when = function() return is_sure() and confidence.status ~= "fresh" end,
      lasting = "unsure_time_after_disturbance", because = "the room supports one pose, or cannot distinguish them" },
  },

  state "searching" {
    publishes = "pose_is_searched",
    initial = "choosing",
    enter = function() memory.looks, memory.is_there, memory.saw_posts = 0, false, false end,
    { "resting", when = is_belief_worthless, because = "no goal is at the believed position" },
    { "resting", when = is_sure, lasting = "hold_time", because = "the room supports one pose" },
    { "resting", after = "timeout", because = "the search took too long" },

    state "choosing" {
      update = function() walk.stand() end,
      { "opponent goal", when = is_opponent_goal_nearer, because = "the opponent goal is nearer to the view" },
      { "own goal", when = function() return not is_opponent_goal_nearer() end, because = "the own goal is nearer to the view" },
    },

    state "opponent goal" {
      update = function() look_for_posts(opponent_goal()) end,
      exit = note_look,
      { "own goal",
        when = function() return gaze.is_at(opponent_goal()) end,
        lasting = "dwell", because = "the goal was in view long enough" },
      { "own goal", after = "reach_timeout", because = "the head cannot reach the goal" },
    },

    state "own goal" {
      update = function() look_for_posts(own_goal()) end,
      exit = note_look,
      { "opponent goal",
        when = function() return gaze.is_at(own_goal()) end,
        lasting = "dwell", because = "the goal was in view long enough" },
      { "opponent goal", after = "reach_timeout", because = "the head cannot reach the goal" },
    },
  },
}
