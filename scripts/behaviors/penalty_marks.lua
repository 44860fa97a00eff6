--- Walks from one penalty mark to the other and back by the believed pose. If it learns an unknown room, it makes a full
--- rotation before it walks, and another one on the first visit of a mark if much of the room is still unknown. After a
--- disturbance it goes to its own mark first. Other behaviors decide whether the belief is good enough: while they search
--- for the pose it waits. While the lines do not fit the pose it rotates on the spot, because with a wrong position it
--- would walk to a wrong place.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local p = param {
  arrived     = { 0.15, range = { 0.05, 1 },              doc = "distance at which the robot counts as on the mark", unit = "m" },
  pause       = { 1.0,  range = { 0, 60 },    unit = "s", doc = "time to stand on a mark" },
  turn_round  = { true,                                   doc = "rotate once at the start and on a mark while the room is being learned" },
  coverage    = { 0.8,  range = { 0, 1 },                 doc = "learned fraction of the wall at which no rotation is needed" },
  turn_speed  = { 0.6,  range = { 0.1, 2 }, unit = "rad/s", doc = "rotation speed" },
  lost_time   = { 2.0,  range = { 0, 60 },    unit = "s", doc = "time without a tracked pose before the robot rotates on the spot" },
  longest_look = { 30.0, range = { 0, 600 },  unit = "s", doc = "longest rotation on the spot before the robot walks by its belief" },
  undisturbed_time = { 0.5, range = { 0, 10 }, unit = "s", doc = "time to stand after a disturbance before the robot walks" },
}

-- `side` of the target mark: -1 is the robot's own half, 1 the opponents' half.
local memory = keep { side = -1, has_turned = false }

local function mark() return memory.side * field.penalty_mark_x end

local function go() return walking.walk_to(mark(), 0.0) end

local function is_there() return walking.is_near(mark(), 0.0, p.arrived) end

local function does_not_know_the_room() return p.turn_round and training.active and confidence.coverage < p.coverage end

local function is_disturbed() return robot.time_since_disturbance == 0.0 end

local function one_turn() return 2 * math.pi / p.turn_speed end   -- s

local function may_not_walk() return not robot.may_walk and not is_disturbed() end

local function must_wait() return published.pose_is_searched and robot.may_walk and not is_disturbed() end

local function is_lost() return not pose.tracked and robot.may_walk and not published.pose_is_searched end

local function is_found() return not is_lost() end

behavior "penalty_marks" {
  priority = 20,
  initial = "walking",
  common = {
    { "disturbed", when = is_disturbed, because = "the robot cannot walk now" },
    { "held", when = function() return not robot.can_walk end, because = "this body cannot walk" },
    { "held", when = may_not_walk, because = "the referee does not permit walking" },
    { "waiting", when = must_wait, because = "another behavior searches for the pose" },
  },

  state "walking" {
    update = go,
    { "looking round", when = is_lost, lasting = "lost_time", because = "the lines do not fit the pose" },
    { "turning round",
      when = function() return not memory.has_turned and does_not_know_the_room() end,
      because = "the robot starts to learn the room" },
    { "turning round",
      when = function() return is_there() and does_not_know_the_room() end,
      because = "the robot is on the mark, and part of the room is unknown" },
    { "on the mark", when = is_there, because = "the robot is on the mark" },
  },

  state "turning round" {
    enter = function() memory.has_turned = true end,
    update = function() walking.turn(p.turn_speed) end,
    { "on the mark", when = is_there, after = one_turn, because = "the robot has made a full rotation" },
    { "walking", after = one_turn, because = "the robot has made a full rotation" },
  },

  state "looking round" {
    update = function() walking.turn(p.turn_speed) end,
    { "walking", when = is_found, because = "the pose is known, or another behavior searches for it" },
    { "walking", after = "longest_look", because = "the pose was not found in time" },
  },

  state "on the mark" {
    update = function() walk.stand() end,
    exit = function() memory.side = -memory.side end,
    { "walking", after = "pause" },
  },

  state "disturbed" {
    update = function() walk.stand() end,
    exit = function() memory.side = -1 end,
    { "walking", when = function() return robot.time_since_disturbance > p.undisturbed_time end, because = "the robot stands again" },
  },

  state "waiting" {
    update = function() walk.stand() end,
    { "walking", when = function() return not published.pose_is_searched end, because = "the search has ended" },
  },

  state "held" {
    update = function() walk.stand() end,
    { "walking", when = function() return robot.may_walk and robot.can_walk end, because = "the game continues" },
  },
}
