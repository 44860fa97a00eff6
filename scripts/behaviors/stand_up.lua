--- Gets up after a fall, once the robot has come to rest.

param {
  rest = { 1.0, range = { 0, 10 }, unit = "s", doc = "how long to lie still before getting up" },
}

behavior "stand_up" {
  priority = 90,
  initial = "upright",

  state "upright" {
    { "lying", when = function() return robot.fallen and not robot.carried end, because = "the robot fell" },
  },

  state "lying" {
    update = function() walk.stand() end,
    { "upright", when = function() return not robot.fallen or robot.carried end, because = "the robot was helped up" },
    { "getting up", after = "rest" },
  },

  state "getting up" {
    update = function()
      walk.stand()
      motion.get_up()
    end,
    { "upright", when = function() return not robot.fallen end, because = "the robot stands again" },
  },
}
