--- Where are the goals? A robot that is unsure of its orientation stands still and looks in turn to both places where
--- the goals should be by its belief: there the wall tells the two ends of the field apart and the posts tell the place.
--- It decides nothing; it only brings the evidence before the eyes of those who do. Where no goal post is in view at
--- either place, the belief is worth nothing, and neither is looking where it says.

local gaze = require "lib.gaze"

local p = param {
  lead        = { 0.4,  range = { 0, 1 },                doc = "how far one pose must be ahead of the other for the robot to be sure" },
  proof       = { 1.0,  range = { 0, 10 },   unit = "s", doc = "how long that lead must last to end the search" },
  doubt       = { 10.0, range = { 0, 60 },   unit = "s", doc = "how long neither pose may lead before the search begins" },
  catch_up    = { 6.0,  range = { 0, 30 },   unit = "s", doc = "how long after a disturbance the head scans as usual first" },
  patience    = { 20.0, range = { 1, 120 },  unit = "s", doc = "how long to search at most" },
  dwell       = { 1.0,  range = { 0, 10 },   unit = "s", doc = "how long to look at one goal" },
  informative = { 0.05, range = { 0, 1 },                doc = "how much the room must differ from itself after half a turn" },
  out_of_view = { 8.0,  range = { 0.5, 60 }, unit = "s", doc = "after which time to try the other goal if one cannot be looked at" },
}

local memory = keep { looks = 0, saw_posts = false }   -- of this search

local OPPONENT, OWN = 1, -1

local function goal_line(side) return side * field.length / 2 end

local function is_helpless() return robot.fallen or robot.carried or robot.penalized end

-- Before the room is known, or where both of its ends look the same, looking at the goals would not help either.
local function can_room_tell() return evaluation.active and confidence.distinctiveness >= p.informative end

local function is_unsure() return can_room_tell() and math.abs(confidence.current - confidence.opposite) < p.lead end

local function is_sure() return not is_unsure() end

local function is_opponent_goal_nearer()
  return gaze.angle_to(goal_line(OPPONENT), 0.0) <= gaze.angle_to(goal_line(OWN), 0.0)
end

local function begin_search() memory.looks, memory.saw_posts = 0, false end

local function is_belief_worthless() return memory.looks >= 2 and not memory.saw_posts end

local function looking_at(side, other_goal)
  return {
    update = function()
      gaze.at(goal_line(side), 0.0)
      if seen.goal_posts > 0 and gaze.is_at(goal_line(side), 0.0) then memory.saw_posts = true end
    end,
    exit = function() memory.looks = memory.looks + 1 end,
    { other_goal,
      when = function() return gaze.is_at(goal_line(side), 0.0) end,
      lasting = "dwell", because = "the goal was looked at" },
    { other_goal, after = "out_of_view", because = "the goal cannot be looked at" },
  }
end

behavior "goal_search" {
  priority = 30,
  initial = "resting",
  common = {
    { "helpless", when = is_helpless, because = "the robot lies, is carried or is penalized" },
  },

  state "resting" {
    { "searching", when = is_unsure, lasting = "doubt", because = "neither pose leads" },
  },

  state "helpless" {
    { "catching up", when = function() return not is_helpless() end, because = "the robot may stand elsewhere than before" },
  },

  -- The confidences are smoothed and still speak of before, and the usual scan of the head is often enough for them.
  state "catching up" {
    { "searching", when = is_unsure, after = "catch_up", because = "neither pose leads since then" },
    { "resting", when = is_sure, after = "catch_up", because = "one pose leads, or the room cannot tell" },
  },

  state "searching" {
    initial = "choosing",
    enter = begin_search,
    { "resting", when = is_belief_worthless, because = "no goal stands where the belief says" },
    { "resting", when = is_sure, lasting = "proof", because = "one pose leads" },
    { "resting", after = "patience", because = "its patience ended" },

    state "choosing" {
      update = function() walk.stand() end,
      { "opponent goal", when = is_opponent_goal_nearer, because = "the opponent goal is nearer to the view" },
      { "own goal", when = function() return not is_opponent_goal_nearer() end, because = "the own goal is nearer to the view" },
    },

    state "opponent goal" (looking_at(OPPONENT, "own goal")),
    state "own goal" (looking_at(OWN, "opponent goal")),
  },
}
