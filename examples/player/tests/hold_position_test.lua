--- Tests of behaviors/hold_position.lua.

-- SPDX-License-Identifier: MIT

local function begin()
  load_behavior("hold_position", { x = -1.0, y = 1.0 })
end

local function stand_at(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

test("stands while the robot is near its position", function()
  begin()
  stand_at(-1.2, 1.0, 0)
  advance(1)
  expect.state("hold_position", "standing")
  expect.walk(0, 0, 0)
end)

test("returns to its position and looks at the center of the field", function()
  begin()
  stand_at(-3.0, 1.0, 0)
  advance(0.5)
  expect.state("hold_position", "returning")
  expect.walk(0.2, 0, 0)
  stand_at(-1.0, 1.0, 0)
  advance(0.5)
  expect.state("hold_position", "returning")
  stand_at(-1.0, 1.0, math.rad(-45))
  advance(0.5)
  expect.state("hold_position", "standing")
  expect.reason("hold_position", "the robot is at its position")
end)

test("returns again after it was moved away", function()
  begin()
  stand_at(-1.0, 1.0, math.rad(-45))
  advance(1)
  expect.state("hold_position", "standing")
  stand_at(-1.0, 0.3, 0)
  advance(0.1)
  expect.state("hold_position", "returning")
  expect.reason("hold_position", "the robot is away from its position")
end)

test("rests when it does not arrive, then tries again", function()
  begin()
  stand_at(-3.0, 1.0, 0)
  advance(60.2)
  expect.state("hold_position", "resting")
  expect.walk(0, 0, 0)
  advance(3.1)
  expect.state("hold_position", "returning")
end)
