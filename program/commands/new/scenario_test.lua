--- Tests of the scenario NAME.

test("judges by the pose", function()
  load_scenario "NAME"
  set_world { pose = { x = -1.0, y = 0.5 }, truth = { x = -1.0, y = 0.5 } }
  advance(21.0)
  expect.verdict(true, "knows its place")
end)

test("fails a robot that is elsewhere", function()
  load_scenario "NAME"
  set_world { pose = { x = -1.0, y = 0.5 }, truth = { x = 1.0, y = -0.5 } }
  advance(21.0)
  expect.verdict(false, "lost its place")
end)

test("ends right on the simulator", function()
  simulate { scenario = "NAME", seed = 1, width = 160 }
  expect.verdict(true, "knows its place")
end)
