local a = args { x = { 1, range = { 0, 2 }, doc = "x" } }
behavior "fuzzed" {
  initial = "a",
  common = { { "b", when = function() return robot.penalized end, because = "x" } },
  state "a" {
    initial = "x",
    history = true,
    run "called" { x = function() return a.x - 1 end, on = true },
    state "x" {
      run "inner" {},
      { "y", when = done "inner" },
    },
    state "y" {
      run "inner" { x = function() return 9 end },
      run "honest_one" {},
      { "x", when = function() return called.inner.outcome == "done" end, lasting = "x" },
    },
  },
  state "b" { { "a", when = function() return not robot.penalized end } },
}
ÿbehavior "fuzzed" {
  initial = "a",
  state "a" {
    initial = "y",
    run "called" { mode = "fast", n = 3 },
    state "y" { run "inner" { x = -1 }, { "z", after = 0.1 } },
    state "z" { { "y", when = failed "called" } },
  },
}
