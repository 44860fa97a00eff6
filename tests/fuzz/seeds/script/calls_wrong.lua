behavior "b" {
  initial = "a",
  state "a" {
    run "called" {
      x = function() return 0 / 0 end,
      n = function() return 1.5 end,
      on = function() return nil end,
      mode = function() return ("x"):rep(1000) end,
    },
    run "inner" { x = function() error("no") end },
    { "b", after = 0.1 },
  },
  state "b" {
    run "inner" { x = function() while true do end end },
    update = function() return called.absent.state end,
    { "a", when = failed "inner" },
  },
}
ÿbehavior "b" {
  initial = "a",
  state "a" { run "called" { x = 2 }, run "b" {}, run "missing" { y = 1 }, { "a", when = done "inner" } },
}
