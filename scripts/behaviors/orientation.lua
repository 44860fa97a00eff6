--- Which of the two look-alike poses is the robot really in? When the room speaks for the reflection of the believed pose,
--- the belief is flipped; when it speaks for the believed pose while wrong beliefs linger, those are purged; after a fall
--- that the robot got up from, the orientation is reset. Whether the room may speak at all, the core says:
--- confidence.status. How much it must say is asked of lib.decision: less while the pose is in doubt, so that a robot that
--- was put down is soon right, and more in peace, where it would have to be wrong again and again for hours. What the room
--- says first, and then takes back, is not acted upon.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"

local p = param {
  hold_time  = { 0.2,  range = { 0, 10 }, unit = "s", doc = "time for which the evidence must exceed the threshold" },
  min_time   = { 3.0,  range = { 0, 30 }, unit = "s", doc = "waiting time after a command until its effect shows" },
  lingering  = { 0.1,  range = { 0, 1 },              doc = "fraction of reflected pose particles that causes a purge" },
  settling   = { 5.0,  range = { 0, 60 }, unit = "s", doc = "time after the first known tiles during which lines and posts may still correct the belief" },
  taken_back = { 0.05, range = { 0, 1 },              doc = "largest relative decrease of the evidence during settling" },
}

local memory = keep { flips = 0, purges = 0, resets = 0, confirm = false, age_in_peace = 0.0, age = 0.0, began = 0.0,
  most_evidence = 0.0 }

-- A flip turns every belief round, right ones as well, and a reset spreads them: once the believed pose has proved right
-- after either, what is wrong is purged. The purge also says that the pose is known again, so that training may go on.
local function is_purge_due() return memory.confirm or pose.reflected_weight > p.lingering end

local function may_decide() return confidence.status == "usable" end

local function watch_evidence()
  if confidence.age < memory.age or confidence.age == 0.0 then
    memory.most_evidence = 0.0
    memory.began = clock.time
  end
  memory.age = confidence.age
  memory.most_evidence = math.max(memory.most_evidence, confidence.evidence)
end

-- A robot that was put down a little turned sees everything beside the place where it knows it, until lines and posts have
-- turned its belief into place. What spoke for the reflection till then is taken back, tile by tile; of a belief that is the
-- reflection, more and more tiles say so.
local function is_taking_back()
  return clock.time - memory.began < p.settling and confidence.evidence < (1.0 - p.taken_back) * memory.most_evidence
end

local function believed_pose_won() return may_decide() and decision.for_believed() end

local function reflected_pose_won()
  return may_decide() and confidence.evidence > decision.in_doubt() and not is_taking_back()
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
    initial = "in doubt",
    { "purging",
      when = function() return believed_pose_won() and is_purge_due() end,
      lasting = "hold_time", because = "the believed pose won while reflected beliefs may linger" },

    state "in doubt" {
      { "correcting",
        when = reflected_pose_won,
        lasting = "hold_time", because = "the reflected pose won" },
      { "in peace", when = believed_pose_won, lasting = "hold_time", because = "the believed pose won" },
    },

    state "in peace" {
      enter = function() memory.age_in_peace = confidence.age end,
      { "correcting",
        when = function() return may_decide() and confidence.evidence > decision.in_peace() end,
        lasting = "hold_time", because = "the reflected pose won" },
      { "in doubt",
        when = function() return confidence.age < memory.age_in_peace end,
        because = "earlier views are not valid any more" },
    },
  },

  state "correcting" {
    enter = function()
      memory.flips = memory.flips + 1
      memory.confirm = true
      command.flip_pose()
    end,
    -- A flip that was refused has turned nothing, and a purge would take away what the room has just spoken for.
    { "purging",
      when = function() return confidence.evidence < 0 and pose.reflected_weight > p.lingering end,
      because = "the flip also mirrored correct particles" },
    { "watching", after = "min_time" },
  },

  state "purging" {
    enter = function()
      memory.purges = memory.purges + 1
      memory.confirm = false
      command.purge_reflection()
    end,
    -- The room may change its mind: what was purged on the first views must not delay a flip.
    { "correcting",
      when = reflected_pose_won,
      lasting = "hold_time", because = "the reflected pose won after a purge" },
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
