--- Tests of scenarios/half_time.lua.

-- SPDX-License-Identifier: MIT

local function set_truth(x, y, rotation) set_world { truth = { x = x, y = y, rotation = rotation } } end
local function set_belief(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

--- Advances to the frame in which the robot receives the change of sides.
local function change_sides()
  set_truth(-1, 0.5, 0)
  set_belief(-1, 0.5, 0)
  load_scenario "half_time"
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  advance(40.1)
  expect.action("half_time")
  expect.state("half_time", "second half/knowing")
  set_world { game = { sides_changed = true } }
  set_truth(1, -0.5, math.pi)
  set_belief(1, -0.5, math.pi)
end

test("succeeds when the belief was rotated with the axes", function()
  change_sides()
  advance(59)
  expect.state("half_time", "second half/knowing")
  advance(2)
  expect.verdict(true, "knows its position after the change of sides")
end)

test("fails when the belief stays unchanged", function()
  change_sides()
  set_belief(-1, 0.5, 0)
  advance(1.5)
  expect.state("half_time", "second half/knowing")
  advance(1)
  expect.verdict(false, "2.24 m and 180 degrees off")
end)

test("fails when the robot flips its belief", function()
  change_sides()
  set_world { confidence = { evidence = 9, coverage = 1, distinctiveness = 0.5, status = "usable" } }
  advance(10)
  expect.verdict(false, "flipped its belief after half-time")
end)

test("loads the behaviors that it needs", function()
  change_sides()
  advance(0.1)
  expect.state("orientation", "watching/unconfirmed")
  expect.state("penalty_marks", "walking")
end)
