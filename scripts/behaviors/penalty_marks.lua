--- Walks from one penalty mark to the other and back, always by the pose that the robot believes in. On the first visit
--- of a mark it turns round once if much of the room is not learned yet. After somebody has put the robot down it first
--- stands and looks about until it is sure of its pose, or its patience ends; then it goes to its own mark.

local walking = require "lib.walk"

local p = param {
  arrived     = { 0.15, range = { 0.05, 1 },              doc = "how near to a mark counts as there", unit = "m" },
  pause       = { 1.0,  range = { 0, 60 },    unit = "s", doc = "how long to stand on a mark" },
  turn_round  = { true,                                   doc = "turn round once on a mark while the room is being learned" },
  coverage    = { 0.8,  range = { 0, 1 },                 doc = "share of the wall from which on turning round is not needed" },
  turn_speed  = { 0.6,  range = { 0.1, 2 }, unit = "rad/s", doc = "how fast to turn round" },
  sure        = { 0.4,  range = { 0, 1 },                 doc = "how far the believed pose must be ahead for the robot to be sure of it" },
  sure_for    = { 2.0,  range = { 0, 20 },    unit = "s", doc = "how long it must be ahead" },
  patience    = { 25.0, range = { 1, 120 },   unit = "s", doc = "how long to look about at most after being put down" },
}

local memory = keep { side = -1 }   -- of the mark to go to: -1 is the robot's own half, 1 the opponent's

local function mark() return memory.side * field.penalty_mark_x end

local function is_sure() return confidence.current - confidence.opposite > p.sure end

local function go() return walking.walk_to(mark(), 0.0) end

local function is_there() return walking.is_near(mark(), 0.0, p.arrived) end

behavior "penalty_marks" {
  priority = 20,
  initial = "walking",
  always = {
    { "helpless", when = function() return robot.carried or robot.fallen or robot.penalized end, because = "the robot cannot walk now" },
  },

  state "walking" {
    update = go,
    { "turning round",
      when = function() return is_there() and p.turn_round and training.active and confidence.coverage < p.coverage end,
      because = "the robot is on the mark and does not know the whole room" },
    { "on the mark", when = is_there, because = "the robot is on the mark" },
  },

  state "turning round" {
    update = function() walking.turn(p.turn_speed) end,
    { "on the mark", after = function() return 2 * math.pi / p.turn_speed end, because = "it has turned round" },
  },

  state "on the mark" {
    update = function() walk.stand() end,
    exit = function() memory.side = -memory.side end,
    { "walking", after = "pause" },
  },

  state "helpless" {
    update = function() walk.stand() end,
    { "looking about",
      when = function() return not (robot.carried or robot.fallen or robot.penalized) end,
      lasting = 0.5, because = "the robot stands again" },
  },

  state "looking about" {
    enter = function() memory.side = -1 end,
    update = function() walk.stand() end,
    { "walking",
      when = function() return time_in_state() > 3.0 and is_sure() end,
      lasting = "sure_for", because = "the robot is sure of its pose" },
    { "walking", after = "patience", because = "its patience ended" },
  },
}
