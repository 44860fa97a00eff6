behavior "b" {
  priority = 2,
  initial = "a",
  state "a" {
    run "called" {
      x = function() return pose.x end,
      n = function() return 1 + (clock.frame or 0) % 3 end,
      on = function() return robot.posture == "upright" end,
      mode = "slow",
    },
    run "inner" { x = 0.5 },
    { "b", when = done "called", because = "done" },
    { "c", when = failed "called", because = "failed" },
    { "a", after = 0.5 },
  },
  state "b" {
    enter = function() log.info(called.called.outcome .. called.called.reason) end,
    run "called" { mode = function() return confidence.current > 0.5 and "fast" or "slow" end },
    { "a", when = function() return called.called.outcome == "failed" end, lasting = 0.03 },
    { "c", when = function() return called.called.time_in_state > 1 end },
  },
  state "c" {
    exit = function() print(called.called.state, called.inner.state) end,
    { "a", after = 0 },
  },
}
