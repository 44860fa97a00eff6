--- When may the background model of the room be trained, and when is it trusted? With a known pose and no model the
--- room is learned first, and the evaluation waits until enough of it is known; until then somebody's word is all that
--- speaks against the reflected pose, so reflected beliefs are purged on it. From then on the model is trained only
--- while the believed pose clearly wins: training on a reflected belief would paint the room the wrong way round.
--- That nothing is trained while the robot lies or is carried is the business of training_pause; here it matters only
--- for what may be believed afterwards.

local p = param {
  least    = { 20.0, range = { 0, 600 }, unit = "s", doc = "how long to learn the room at least before it is trusted" },
  coverage = { 0.5,  range = { 0, 1 },               doc = "share of the wall that must be learned before it is trusted" },
  most     = { 35.0, range = { 0, 600 }, unit = "s", doc = "how long to learn at most, whatever the coverage" },
  doubt    = { 0.05, range = { 0, 1 },               doc = "share of reflected pose particles that is purged while the room is learned" },
  settle   = { 3.0,  range = { 0, 30 },  unit = "s", doc = "how long to wait after such a purge" },
  lead     = { 0.3,  range = { 0, 1 },               doc = "how far the believed pose must be ahead to train on" },
  proof    = { 1.0,  range = { 0, 10 },  unit = "s", doc = "how long that lead must last" },
  steady   = { 0.5,  range = { 0, 10 },  unit = "s", doc = "how long the robot must stand on the field before it learns on" },
  wary     = { 8.0,  range = { 0, 60 },  unit = "s", doc = "how long after a disturbance older confidences may still speak: no training" },
}

-- Once the robot was lifted while it learned, nobody vouches any more for the pose that it was started with.
local memory = keep { was_lifted = false, disturbed_at = -1000.0 }

local function is_disturbed() return robot.fallen or robot.carried or robot.penalized end

local function stands_for() return clock.time - memory.disturbed_at end

local function note_disturbance()
  if is_disturbed() then memory.disturbed_at = clock.time end
  if robot.carried and training.seconds > 0 then memory.was_lifted = true end
end

local function knows_the_room()
  if training.seconds >= p.most then return true end
  return training.seconds >= p.least and confidence.coverage >= p.coverage
end

local function is_vouched_for() return pose.known and not memory.was_lifted end

local function lead() return confidence.current - confidence.opposite end

-- The confidences are smoothed: just after the robot was put down they still speak of where it was before.
local function wins()
  return lead() > p.lead and not is_disturbed() and stands_for() > p.steady + p.wary
end

behavior "background_training" {
  priority = 40,
  initial = "waiting",
  update = note_disturbance,

  state "waiting" {
    enter = function()
      command.pause_training()
      command.pause_evaluation()
    end,
    { "trusting", when = knows_the_room, because = "the room is known" },
    { "learning",
      when = function() return is_vouched_for() and stands_for() > p.steady end,
      because = "the pose is known and the room is not" },
  },

  state "learning" {
    initial = "studying",
    enter = function() command.pause_evaluation() end,
    exit = function() memory.was_lifted = memory.was_lifted or robot.carried end,
    { "waiting", when = is_disturbed, because = "the robot does not stand on the field" },
    { "trusting", when = knows_the_room, because = "enough of the room was learned" },

    state "studying" {
      { "vouching",
        when = function() return pose.reflected_weight > p.doubt end,
        because = "the pose was told, so its reflection is wrong" },
    },

    state "vouching" {
      enter = function() command.purge_reflection() end,
      { "studying", after = "settle" },
    },
  },

  state "trusting" {
    initial = "watching",

    state "watching" {
      enter = function() command.pause_training() end,
      { "refining", when = wins, lasting = "proof", because = "the current pose wins" },
    },

    state "refining" {
      { "watching", when = is_disturbed, because = "the robot does not stand on the field" },
      { "watching", when = function() return lead() <= p.lead end, because = "the current pose does not win clearly" },
    },
  },
}
