--- Decides when the model of the room is trained, when the room is compared with it, and when the result is used. With a
--- known pose and an unknown room, the room is learned first. The evaluation waits until enough of it is known on both
--- sides, because only tiles that are known together with their reflections show whether the room is symmetric. It waits
--- longer if the room seems symmetric, because a room that is wrongly called symmetric would not be learned further. Until
--- then only the initial pose contradicts the mirrored pose, so mirrored particles are purged. After that, the model is
--- trained only while the room supports the believed pose, because training on a mirrored belief would learn the room
--- mirrored. If a room that was not symmetric starts to seem symmetric without a disturbance, it is learned further, since
--- more of it may show a difference. While the robot is disturbed, the camera's pose is unknown, so both pause. While what
--- the robot sees no longer fits its pose, it does not learn.

-- SPDX-License-Identifier: MIT

local p = param {
  undisturbed_time = { 0.5, range = { 0, 10 }, unit = "s", doc = "time after standing up before views count" },
  min_time      = { 10.0, range = { 0, 600 }, unit = "s", doc = "shortest learning time before the model of the room is used" },
  max_time      = { 35.0, range = { 0, 600 }, unit = "s", doc = "longest learning time, however much of the wall is known" },
  paired        = { 0.4,  range = { 0, 1 },               doc = "fraction of the wall known on both sides at which learning ends sooner" },
  patience      = { 14.0, range = { 0, 600 }, unit = "s", doc = "learning time after which least_paired is enough" },
  least_paired  = { 0.25, range = { 0, 1 },               doc = "fraction of the wall known on both sides that is enough after patience" },
  separability  = { 0.7,  range = { 0, 1 },               doc = "smallest confidence.separability at which learning ends sooner" },
  lingering     = { 0.05, range = { 0, 1 },               doc = "fraction of mirrored particles that is purged while learning" },
  purge_pause   = { 3.0,  range = { 0, 30 },  unit = "s", doc = "waiting time after such a purge" },
  proof         = { 4.6,  range = { -50, 50 },             doc = "smallest log-odds of the believed pose for further training" },
  hold_time     = { 1.0,  range = { 0, 10 },  unit = "s", doc = "time for which the log-odds must reach proof" },
}

-- After a lift during learning, the initial pose is not reliable any more. A robot that has never seen lines where its pose
-- expects them, for example in a room without a field, trusts the pose that was set.
local memory = keep { has_begun = false, was_lifted = false, was_tracked = false, knew_the_room = false }

local function stands_on_the_field() return robot.time_since_disturbance > p.undisturbed_time end

local function has_learned_enough()
  if training.seconds >= p.max_time then return true end
  local enough = training.seconds >= p.patience and p.least_paired or p.paired
  return training.seconds >= p.min_time and confidence.paired >= enough and confidence.separability >= p.separability
end

local function is_known_no_more() return training.seconds < p.min_time and not has_learned_enough() end

-- A room stays known if its separability falls later, because the pose after a disturbance may be mirrored and must not be
-- learned with. For the same reason a lifted robot uses what it has learned.
local function knows_the_room()
  return has_learned_enough() or (memory.knew_the_room or memory.was_lifted) and training.seconds >= p.min_time
end

local function is_lost() return memory.was_tracked and not pose.tracked end

local function is_vouched_for() return pose.known and not memory.was_lifted end

local function wins()
  return confidence.status == "usable" and confidence.evidence < -p.proof
end

local function still_wins()
  return wins() or confidence.status == "symmetric" and confidence.evidence < -p.proof
end

behavior "background_training" {
  priority = 40,
  initial = "waiting",
  common = {
    { "disturbed", when = function() return robot.posture == "lifted" end, because = "the robot is lifted" },
    { "disturbed", when = function() return robot.posture ~= "upright" end, because = "the robot falls, lies or gets up" },
    { "disturbed", when = function() return robot.penalized end, because = "the robot is penalized" },
  },

  state "disturbed" {
    enter = function()
      command.pause_training()
      command.pause_evaluation()
    end,
    update = function()
      if robot.posture == "lifted" and memory.has_begun then memory.was_lifted = true end
    end,
    { "waiting", when = stands_on_the_field, because = "the robot has stood on the field for a moment" },
  },

  state "waiting" {
    enter = function()
      memory.knew_the_room = memory.knew_the_room and not is_known_no_more()
      command.pause_training()
      command.pause_evaluation()
    end,
    { "trusting", when = knows_the_room, because = "the room is known" },
    { "learning",
      when = function() return is_vouched_for() and stands_on_the_field() end,
      because = "the pose is known, the room is unknown" },
  },

  state "learning" {
    initial = "studying",
    enter = function()
      memory.has_begun = true
      command.pause_evaluation()
    end,
    update = function() memory.was_tracked = memory.was_tracked or pose.tracked end,
    { "trusting", when = has_learned_enough, because = "enough of the room was learned" },

    state "studying" {
      { "doubting", when = is_lost, because = "what the robot sees no longer fits its pose" },
      { "purging",
        when = function() return pose.reflected_weight > p.lingering end,
        because = "the initial pose was set, so the mirrored pose is wrong" },
    },

    state "purging" {
      enter = function() command.purge_reflection() end,
      { "doubting", when = is_lost, because = "what the robot sees no longer fits its pose" },
      { "studying", after = "purge_pause" },
    },

    state "doubting" {
      enter = command.pause_training,
      { "studying", when = function() return pose.tracked end, because = "what the robot sees fits its pose again" },
    },
  },

  state "trusting" {
    initial = "watching",
    enter = function() memory.has_begun, memory.knew_the_room = true, true end,
    { "waiting", when = is_known_no_more, because = "the model was discarded: parameters of the wall or the colors have changed" },

    state "watching" {
      enter = function() command.pause_training() end,
      { "refining", when = wins, lasting = "hold_time", because = "the room supports the believed pose" },
    },

    state "refining" {
      { "watching", when = function() return not still_wins() end, because = "the room does not clearly support the believed pose" },
    },
  },
}
