--- Tests of the behavior NAME, in a fake world with a fake clock: reorient test scripts/tests/NAME_test.lua

test("rests while the robot is sure of its pose", function()
  set_world { confidence = { current = 0.9, opposite = 0.0 } }
  load_behavior "NAME"
  advance(5.0)
  expect.state("NAME", "sure")
end)

test("looks to both sides while it is not", function()
  set_world { confidence = { current = 0.4, opposite = 0.4 } }
  load_behavior "NAME"
  advance(1.0)
  expect.state("NAME", "looking/left")
  expect.reason("NAME", "the robot is not sure of its pose")
  expect.head(0.8, 0)
  advance(1.0)
  expect.state("NAME", "looking/right")
  expect.head(-0.8, 0)
  advance(1.0)
  expect.state("NAME", "looking/left")
end)

test("rests again as soon as it is sure", function()
  load_behavior "NAME"
  advance(1.0)
  set_world { confidence = { current = 0.9, opposite = 0.0 } }
  advance(0.1)
  expect.state("NAME", "sure")
end)

test("keeps its state when the script is edited", function()
  load_behavior "NAME"
  advance(1.0)
  reload { from = "0.8, range", to = "0.5, range" }
  expect.state("NAME", "looking/left")
  advance(0.1)
  expect.head(0.5, 0)
end)
