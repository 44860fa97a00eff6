--- Decides which of the two symmetric poses is correct. If the evidence supports the mirrored pose, the
--- belief is flipped. If it supports the believed pose while wrong particles remain, those are purged. After a fall from
--- which the robot got up, the orientation is reset. lib.side adds up the evidence: that of the room while confidence.status
--- is usable, and with the behavior team_side also that of the team, the rules and the time. lib.decision sets the threshold:
--- lower for an unconfirmed pose, so that the belief of a placed robot is soon correct, and higher for a confirmed pose,
--- which is evaluated repeatedly for hours. Evidence of the room that rises first and then falls causes no flip.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"
local side = require "lib.side"

local p = param {
  hold_time  = { 0.2,  range = { 0, 10 }, unit = "s", doc = "time for which the evidence must exceed the threshold" },
  min_time   = { 3.0,  range = { 0, 30 }, unit = "s", doc = "waiting time after a command until its effect shows" },
  lingering  = { 0.1,  range = { 0, 1 },              doc = "fraction of particles near the mirrored pose that causes a purge" },
  settling   = { 5.0,  range = { 0, 60 }, unit = "s", doc = "time after the first known tiles in which lines may correct the belief" },
  taken_back = { 0.05, range = { 0, 1 },              doc = "largest relative decrease of the evidence during settling" },
}

local memory = keep { flips = 0, purges = 0, resets = 0, confirm = false, age_when_confirmed = 0.0, age = 0.0, began = 0.0,
  most_evidence = 0.0 }

-- A flip mirrors every particle, correct ones as well, and a reset spreads them: once the believed pose is confirmed
-- after either, wrong particles are purged. The purge also makes the pose known again, so that training can continue.
local function is_purge_due() return memory.confirm or pose.reflected_weight > p.lingering end

local function watch_evidence()
  side.update()
  if confidence.age < memory.age or confidence.age == 0.0 then
    memory.most_evidence = 0.0
    memory.began = clock.time
  end
  memory.age = confidence.age
  memory.most_evidence = math.max(memory.most_evidence, confidence.evidence)
end

-- A robot that was placed slightly rotated sees everything beside the learned position, until lines and posts have
-- corrected its belief. Evidence for the reflection then decreases, tile by tile; if the belief is the reflection,
-- more and more tiles support it.
local function is_taking_back()
  return confidence.status == "usable" and clock.time - memory.began < p.settling and
    confidence.evidence < (1.0 - p.taken_back) * memory.most_evidence
end

local function believed_pose_won() return side.evidence() < -decision.unconfirmed_threshold() end

local function reflected_pose_won()
  return side.evidence() > decision.unconfirmed_threshold() and not is_taking_back()
end

local function is_upright() return robot.posture == "upright" end

behavior "orientation" {
  priority = 50,
  initial = "watching",
  update = watch_evidence,
  common = {
    { "lifted", when = function() return robot.posture == "lifted" end, because = "the robot is lifted" },
    { "fallen", when = function() return robot.posture == "lying" end, because = "the robot fell" },
  },

  state "watching" {
    initial = "unconfirmed",
    { "purging",
      when = function() return believed_pose_won() and is_purge_due() end,
      lasting = "hold_time", because = "the believed pose won while mirrored beliefs may linger" },

    state "unconfirmed" {
      { "correcting",
        when = reflected_pose_won,
        lasting = "hold_time", because = "the mirrored pose won" },
      { "confirmed", when = believed_pose_won, lasting = "hold_time", because = "the believed pose won" },
    },

    state "confirmed" {
      enter = function() memory.age_when_confirmed = confidence.age end,
      { "correcting",
        when = function() return side.evidence() > decision.confirmed_threshold() end,
        lasting = "hold_time", because = "the mirrored pose won" },
      { "unconfirmed",
        when = function() return confidence.age < memory.age_when_confirmed end,
        because = "earlier views are not valid any more" },
    },
  },

  state "correcting" {
    enter = function()
      memory.flips = memory.flips + 1
      memory.confirm = true
      command.flip_pose()
    end,
    -- A refused flip has mirrored nothing, and a purge would remove the particles that the room supports.
    { "purging",
      when = function() return confidence.evidence + side.evidence_beside_room() < 0 and pose.reflected_weight > p.lingering end,
      because = "the flip also mirrored correct particles" },
    { "watching", after = "min_time" },
  },

  state "purging" {
    enter = function()
      memory.purges = memory.purges + 1
      memory.confirm = false
      command.purge_reflection()
    end,
    -- The evidence may change: a purge on the first views must not delay a flip.
    { "correcting",
      when = reflected_pose_won,
      lasting = "hold_time", because = "the mirrored pose won after a purge" },
    { "watching", after = "min_time" },
  },

  state "fallen" {
    { "resetting", when = is_upright, because = "the robot got up again" },
  },

  state "resetting" {
    enter = function()
      memory.resets = memory.resets + 1
      memory.confirm = true
      command.reset_orientation()
    end,
    { "watching", after = "min_time" },
  },

  state "lifted" {
    { "watching", when = is_upright, because = "the robot stands again" },
  },
}
