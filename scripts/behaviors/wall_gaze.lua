--- Turns the head to the view with the most information while the orientation is unconfirmed: where the room differs most
--- from its reflection, is near, and was not seen recently. While the room is learned, it looks where most of it is
--- unknown. The engine computes the directions; this script decides when to use them. Otherwise it does not move the head.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"

local p = param {
  pitch = { -0.1,  range = { -0.6, 0.5 }, unit = "rad",   doc = "pitch of the head, positive downward" },
  speed = { 2.0,   range = { 0.1, 5.0 },  unit = "rad/s", doc = "rotation speed of the head" },
  dwell = { 0.2,   range = { 0, 5.0 },    unit = "s",     doc = "time to look in one direction" },
  timeout = { 2.0, range = { 0.2, 20.0 }, unit = "s",     doc = "time after which the head turns to the next view anyway" },
  study = { 0.4,   range = { 0, 5.0 },    unit = "s",     doc = "time to look in one direction while the room is learned" },
  least = { 0.05,  range = { 0, 10 },     unit = "tiles", doc = "smallest score of a view at which the head turns to it" },
  unknown = { 3.0, range = { 0, 100 },    unit = "tiles", doc = "smallest number of unknown tiles at which the head turns to a view" },
}

local NEAR = 0.08   -- rad

local memory = keep { yaw = 0.0 }   -- direction of the head, rad

-- If the pose filter is lost, the believed directions of the walls, and so of the best view, are wrong.
local function is_unconfirmed()
  return confidence.can_tell and confidence.status ~= "lost" and not decision.for_either() and views.best_score > p.least
end

local function is_learning() return training.active and views.unknown_score > p.unknown end

local function is_there() return math.abs(robot.head_yaw - memory.yaw) < NEAR end

-- The head stays until a view is learned, even the last one; otherwise it would alternate between this view and the scan.
local function is_known_there() return is_there() and not is_learning() end

behavior "wall_gaze" {
  priority = 15,
  initial = "resting",

  state "resting" {
    { "looking", when = is_unconfirmed, because = "the orientation is unconfirmed" },
    { "studying", when = is_learning, because = "the room is being learned, and some tiles are unknown" },
  },

  state "looking" {
    enter = function() memory.yaw = views.best_yaw end,
    update = function() head.look(memory.yaw, p.pitch, p.speed) end,
    { "resting", when = function() return not is_unconfirmed() end, because = "the orientation is confirmed, or the room has no evidence" },
    { "looking", when = is_there, lasting = "dwell", because = "the view was held long enough" },
    { "looking", after = "timeout", because = "the head cannot reach the view" },
  },

  state "studying" {
    enter = function() memory.yaw = views.unknown_yaw end,
    update = function() head.look(memory.yaw, p.pitch, p.speed) end,
    { "resting", when = function() return not training.active end, because = "the training has ended" },
    { "resting", when = is_known_there, lasting = "study", because = "the visible tiles are known" },
    { "studying", when = is_there, lasting = "study", because = "the view was learned" },
    { "studying", after = "timeout", because = "the head cannot reach the view" },
  },
}
