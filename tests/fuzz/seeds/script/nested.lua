behavior "b" {
  initial = "a",
  common = {
    { "down", when = function() return robot.posture == "lying" end, because = "it fell" },
  },
  state "a" {
    initial = "x",
    history = true,
    enter = function() command.pause_training() end,
    state "x" {
      { "y", after = 0.03 },
    },
    state "y" {
      exit = function() log.info("left") end,
      { "x", when = function() return confidence.current > 0.5 end, lasting = 0.03 },
      { "a", after = function() return 0.2 end },
    },
  },
  state "down" {
    enter = function() command.flip_pose() end,
    { "a/y", when = function() return robot.posture ~= "lying" end },
  },
}
