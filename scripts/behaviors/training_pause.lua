--- When must the room be neither learned nor compared? While the robot lies, is carried or is penalized its camera is
--- not where the pose says, so what it sees would spoil the background model and the confidences; and for a moment
--- after that, until the body has stopped swaying.

local posture = require "lib.posture"

param {
  settle = { 0.5, range = { 0, 10 }, unit = "s", doc = "how long the robot must stand on the field before its eyes count again" },
}

local function pause_both()
  command.pause_training()
  command.pause_evaluation()
end

local function is_disturbed() return robot.fallen or robot.carried or robot.penalized end

--- A reason to pause: it ends when the robot stands on the field, whatever became of it meanwhile.
local function pause()
  return {
    enter = pause_both,
    { "settling", when = function() return not is_disturbed() end, because = "the robot stands on the field again" },
  }
end

behavior "training_pause" {
  priority = 60,
  initial = "allowing",
  update = posture.watch,
  common = {
    { "fallen", when = posture.is_down, because = "the robot lies or gets up" },
    { "carried", when = posture.is_lifted, because = "the robot is carried" },
    { "penalized",
      when = function() return robot.penalized and not robot.fallen and not robot.carried end,
      because = "the robot is penalized" },
  },

  state "allowing" {},
  state "fallen" (pause()),
  state "carried" (pause()),
  state "penalized" (pause()),

  state "settling" {
    enter = pause_both,
    { "allowing", after = "settle", because = "the robot has stood for a moment" },
  },
}
