--- Which of the two look-alike poses is the robot really in? When the reflection of the believed pose wins, the belief
--- is flipped; when the believed pose then wins, or wins while wrong beliefs linger, those are purged; after a fall that
--- the robot got up from, the orientation is reset. Nothing is decided before enough of the room was learned, nor in a
--- room that looks the same after half a turn, nor while the pose filter is lost: then both poses may be wrong.

local posture = require "lib.posture"

local p = param {
  lead        = { 0.5,  range = { 0, 1 },              doc = "how far one pose must be ahead of the other" },
  proof       = { 0.5,  range = { 0, 10 }, unit = "s", doc = "how long the lead must last" },
  settle      = { 3.0,  range = { 0, 30 }, unit = "s", doc = "how long to wait after acting" },
  coverage    = { 0.3,  range = { 0, 1 },              doc = "share of the wall that must be learned before a decision" },
  informative = { 0.05, range = { 0, 1 },              doc = "how much the room must differ from itself after half a turn" },
  upright     = { 0.3,  range = { 0, 5 },  unit = "s", doc = "how long it must stand after a fall before the orientation is reset" },
  lost        = { 0.3,  range = { 0, 1 },              doc = "how lost the pose filter may be for a decision" },
  lingering   = { 0.1,  range = { 0, 1 },              doc = "share of reflected pose particles that is worth a purge" },
}

local memory = keep { flips = 0, purges = 0, resets = 0, confirm = false }

-- A flip turns every belief round, right ones as well, and a reset spreads them: once the current pose has proved right
-- after either, what is wrong is purged. The purge also says that the pose is known again, so that training may go on.
local function is_purge_due() return memory.confirm or pose.reflected_weight > p.lingering end

local function may_decide()
  return confidence.coverage >= p.coverage and confidence.distinctiveness >= p.informative and pose.recovery_probability <= p.lost
end

-- The confidences are smoothed. If the pose filter has changed its mind meanwhile, this frame's already say so, and a
-- flip would turn the right belief round.
local function opposite_leads()
  return confidence.opposite - confidence.current > p.lead and confidence.raw_opposite >= confidence.raw_current
end

local function current_leads()
  return confidence.current - confidence.opposite > p.lead and confidence.raw_current >= confidence.raw_opposite
end

local function is_lifted_or_down() return robot.fallen or robot.carried end

behavior "orientation" {
  priority = 50,
  initial = "watching",
  update = posture.watch,
  common = {
    { "fallen", when = function() return robot.fallen end, because = "the robot fell" },
    { "carried", when = posture.is_lifted, because = "the robot is being carried" },
  },

  state "watching" {
    { "correcting",
      when = function() return may_decide() and opposite_leads() end,
      lasting = "proof", because = "the opposite pose won" },
    { "purging",
      when = function() return may_decide() and current_leads() and is_purge_due() end,
      lasting = "proof", because = "the current pose won while reflected beliefs may linger" },
  },

  state "correcting" {
    enter = function()
      memory.flips = memory.flips + 1
      memory.confirm = true
      command.flip_pose()
    end,
    { "purging", when = function() return pose.reflected_weight > p.lingering end, because = "the flip turned right beliefs round too" },
    { "watching", after = "settle" },
  },

  state "purging" {
    enter = function()
      memory.purges = memory.purges + 1
      memory.confirm = false
      command.purge_reflection()
    end,
    { "watching", after = "settle" },
  },

  state "fallen" {
    { "resetting", when = function() return not is_lifted_or_down() end, lasting = "upright", because = "the robot got up again" },
  },

  state "resetting" {
    enter = function()
      memory.resets = memory.resets + 1
      memory.confirm = true
      command.reset_orientation()
    end,
    { "watching", after = "settle" },
  },

  state "carried" {
    { "watching", when = function() return not is_lifted_or_down() end, lasting = "settle", because = "the robot stands again" },
  },
}
