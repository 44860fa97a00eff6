--- Which of the two look-alike poses is the robot really in? When the reflection of the believed pose wins, the belief
--- is flipped; when the believed pose wins while wrong beliefs linger, they are purged; after a fall that the robot got
--- up from, the orientation is reset. Nothing is decided before enough of the room was learned, nor in a room that
--- looks the same after half a turn.

local p = param {
  lead        = { 0.5,  range = { 0, 1 },              doc = "how far one pose must be ahead of the other" },
  proof       = { 0.5,  range = { 0, 10 }, unit = "s", doc = "how long the lead must last" },
  settle      = { 3.0,  range = { 0, 30 }, unit = "s", doc = "how long to wait after acting" },
  coverage    = { 0.3,  range = { 0, 1 },              doc = "share of the wall that must be learned before a decision" },
  informative = { 0.05, range = { 0, 1 },              doc = "how much the room must differ from itself after half a turn" },
  lingering   = { 0.1,  range = { 0, 1 },              doc = "share of reflected pose particles that is worth a purge" },
}

local memory = keep { flips = 0, purges = 0, resets = 0 }

local function may_decide()
  return confidence.coverage >= p.coverage and confidence.informative >= p.informative
end

local function is_lifted_or_down() return robot.fallen or robot.carried end

behavior "orientation" {
  priority = 50,
  initial = "watching",
  always = {
    { "fallen", when = function() return robot.fallen end, because = "the robot fell" },
    { "carried", when = function() return robot.carried and not robot.fallen end, because = "the robot is being carried" },
  },

  state "watching" {
    { "correcting",
      when = function() return may_decide() and confidence.opposite - confidence.current > p.lead end,
      lasting = "proof", because = "the opposite pose won" },
    { "purging",
      when = function()
        return may_decide() and confidence.current - confidence.opposite > p.lead and pose.reflected_share > p.lingering
      end,
      lasting = "proof", because = "the current pose won while reflected beliefs linger" },
  },

  state "correcting" {
    enter = function()
      memory.flips = memory.flips + 1
      command.flip_pose()
    end,
    { "watching", after = "settle" },
  },

  state "purging" {
    enter = function()
      memory.purges = memory.purges + 1
      command.purge_reflection()
    end,
    { "watching", after = "settle" },
  },

  state "fallen" {
    { "resetting", when = function() return not is_lifted_or_down() end, lasting = 0.2, because = "the robot got up again" },
  },

  state "resetting" {
    enter = function()
      memory.resets = memory.resets + 1
      command.reset_orientation()
    end,
    { "watching", after = "settle" },
  },

  state "carried" {
    { "watching", when = function() return not is_lifted_or_down() end, lasting = 0.2, because = "the robot stands again" },
  },
}
