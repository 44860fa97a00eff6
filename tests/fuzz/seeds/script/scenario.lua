local p = param { wait = { 0.1, range = { 0, 1 }, unit = "s", doc = "x" } }
scenario "s" {
  behaviors = { "honest_one" },
  initial = "a",
  state "a" {
    enter = function()
      operator.put_down(0, 0, 0)
      operator.set_initial_pose(0, 0, 0)
    end,
    update = function() operator.set_exposure_compensation(p.wait) end,
    { "b", after = "wait" },
  },
  state "b" {
    enter = function() operator.push_over() end,
    { "c", when = function() return truth.x > 0 and behaviors.honest_one.time_in_state > 0.1 end },
  },
  state "c" { enter = function() verdict.succeed("x") end },
}
