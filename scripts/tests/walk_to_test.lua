--- Tests of behaviors/walk_to.lua.

-- SPDX-License-Identifier: MIT

local function stand_at(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

test("walks to its point and is done there", function()
  load_behavior("walk_to", { x = 2.0, y = 1.0 })
  stand_at(0, 1, 0)
  advance(1)
  expect.state("walk_to", "walking")
  expect.walk(0.2, 0, 0)
  stand_at(1.9, 1, 0)
  advance(0.3)
  expect.state("walk_to", "there")
  expect.reason("walk_to", "the robot has arrived")
end)

test("passes by without stopping if it was there only for a moment", function()
  load_behavior("walk_to", { x = 2.0 })
  stand_at(2, 0, 0)
  advance(0.1)
  stand_at(2.5, 0, 0)
  advance(1)
  expect.state("walk_to", "walking")
end)

test("turns at its point if that is wanted", function()
  load_behavior("walk_to", { x = 2.0, turns = true, rotation = math.rad(90) })
  stand_at(2, 0, 0)
  advance(1)
  expect.state("walk_to", "walking")
  expect.walk(0, 0, 0.6)
  stand_at(2, 0, math.rad(88))
  advance(0.3)
  expect.state("walk_to", "there")
end)

test("gives up after its time", function()
  load_behavior("walk_to", { x = 2.0, timeout = 5.0 })
  stand_at(0, 0, 0)
  advance(4.9)
  expect.state("walk_to", "walking")
  advance(0.2)
  expect.state("walk_to", "given up")
end)

test("fails with a body that cannot walk", function()
  load_behavior "walk_to"
  set_world { robot = { can_walk = false } }
  advance(0.1)
  expect.state("walk_to", "unable")
end)
