--- Where am I, after somebody has carried me? A robot that was lifted distrusts its pose. Back on its feet it stays
--- where it is and turns, so that room awareness and self-localization see all around it, and nothing is learned, until
--- the room has supported the believed pose long enough. If neither pose wins, the orientation is forgotten, once.
--- Flips and purges are the business of orientation: a reflected pose wins or loses there.

local posture = require "lib.posture"
local walking = require "lib.walk"

local p = param {
  lift        = { 0.8,  range = { 0, 5 },   unit = "s",     doc = "how long it must be in the air; a robot that trips is so for a moment" },
  lead        = { 0.4,  range = { 0, 1 },                   doc = "how far the believed pose must be ahead of its reflection" },
  proof       = { 3.0,  range = { 0, 20 },  unit = "s",     doc = "how long that lead must last" },
  share       = { 0.6,  range = { 0, 1 },                   doc = "share of the pose particles that must agree on the believed pose" },
  lost        = { 0.1,  range = { 0, 1 },                   doc = "how lost the pose filter may be: the place must fit, too" },
  stale       = { 3.0,  range = { 0, 30 },  unit = "s",     doc = "how long confidences still speak of the place where it was lifted" },
  patience    = { 25.0, range = { 1, 120 }, unit = "s",     doc = "how long to search until the orientation is forgotten, and after that" },
  quiet       = { 3.0,  range = { 0, 20 },  unit = "s",     doc = "how long no goal may have been in view then: it might help" },
  informative = { 0.05, range = { 0, 1 },                   doc = "how much the room must differ from itself after half a turn" },
  turn        = { 0.4,  range = { 0, 2 },   unit = "rad/s", doc = "how fast to turn on the spot meanwhile" },
}

local memory = keep { put_down_at = 0.0 }

-- A penalized robot may not move, and nothing is compared: its search begins when it may play again.
local function is_helpless() return robot.carried or robot.fallen or robot.penalized end

local function lead() return confidence.current - confidence.opposite end

local function supports_the_pose()
  local is_found = pose.cluster_weight >= p.share and pose.recovery_probability <= p.lost
  return not is_helpless() and is_found and lead() > p.lead and clock.time - memory.put_down_at > p.stale
end

-- In a room that cannot tell the two ends apart a forgotten orientation would be found again by the toss of a coin.
local function can_room_tell() return evaluation.active and confidence.distinctiveness >= p.informative end

local function is_stuck() return can_room_tell() and math.abs(lead()) < p.lead and seen.goal_posts == 0 end

behavior "kidnap_recovery" {
  priority = 25,
  initial = "undisturbed",
  update = posture.watch,
  common = {
    { "lifted", when = posture.is_lifted, lasting = "lift", because = "somebody carries the robot" },
  },

  state "undisturbed" {},

  state "lifted" {
    enter = function() command.pause_training() end,
    exit = function() memory.put_down_at = clock.time end,
    { "searching", when = function() return not is_helpless() end, lasting = 0.3, because = "the robot stands, who knows where" },
  },

  state "searching" {
    initial = "with its belief",
    enter = function() command.pause_training() end,
    update = function() walking.turn(p.turn) end,
    { "recovered", when = supports_the_pose, lasting = "proof", because = "the room supports the believed pose" },

    state "with its belief" {
      { "with any orientation", when = is_stuck, lasting = "quiet", after = "patience", because = "neither pose won" },
      { "lost", when = function() return not can_room_tell() end, after = "patience", because = "the room cannot tell" },
    },

    state "with any orientation" {
      enter = function() command.reset_orientation() end,
      { "lost", after = "patience", because = "neither pose won again" },
    },
  },

  state "lost" {
    enter = function()
      command.pause_training()
      log.info("still unsure of the pose, goes on with it")
    end,
    { "recovered", when = supports_the_pose, lasting = "proof", because = "the room supports the believed pose" },
  },

  state "recovered" {
    enter = function() log.info(string.format("recovered %.1f s after it was put down", clock.time - memory.put_down_at)) end,
  },
}
