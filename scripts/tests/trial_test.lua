--- Tests of scenarios/trial.lua.

-- SPDX-License-Identifier: MIT

local function set_truth(x, y, rotation) set_world { truth = { x = x, y = y, rotation = rotation } } end
local function set_belief(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

--- Advances to half a second before the event.
local function learn(event)
  set_param("trial.event", event)
  set_param("trial.wait_least", "0.5")
  set_truth(-3.2, -3.5, math.rad(90))
  load_scenario "trial"
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  set_belief(-3.2, -3.5, math.rad(90))
  advance(40.2)
  expect.state("trial", "waiting")
end

--- On the ground again, and observed.
local function stand_at(x, y, rotation)
  set_truth(x, y, rotation)
  advance(0.1)
  expect.state("trial", "measured")
end

test("places the robot at the reflection of its belief", function()
  learn("mirrored_placement")
  advance(0.5)
  expect.state("trial", "carried")
  expect.action("pick_up")
  advance(1.6)
  expect.state("trial", "measured")
  expect.action("put_down")
  stand_at(3.2, 3.5, math.rad(-90))
  set_belief(3.2, 3.5, math.rad(-90))
  advance(60)
  expect.verdict(true, "0.00 m and 0 degrees off")
end)

test("a belief that stays reflected is wrong in the end", function()
  learn("mirrored_placement")
  advance(2.1)
  stand_at(3.2, 3.5, math.rad(-90))
  advance(60)
  expect.verdict(false, "180 degrees off")
end)

test("does nothing to the robot without an event", function()
  learn("none")
  advance(0.5)
  stand_at(-3.2, -3.5, math.rad(90))
  expect.state("penalty_marks", "walking")
  advance(60)
  expect.verdict(true, "0.00 m")
end)

test("sets the reflection of the true pose as initial pose", function()
  learn("misled")
  advance(0.5)
  expect.state("trial", "measured")
  expect.action("put_down")
  expect.action("set_initial_pose")
end)

test("rotates the field's axes at half-time", function()
  learn("half_time")
  advance(0.5)
  expect.action("half_time")
end)

test("pushes the robot over", function()
  learn("fallen")
  advance(0.5)
  expect.action("push_over")
end)

test("removes a penalized robot from the game and returns it", function()
  learn("penalized")
  advance(0.5)
  expect.state("trial", "out of the game")
  expect.action("penalize")
  expect.action("pick_up")
  advance(10.1)
  expect.state("trial", "measured")
  expect.action("put_down")
  expect.action("penalize")
end)

test("waits for the random time", function()
  set_param("trial.wait_most", "20")
  learn("none")
  expect.state("trial", "waiting")
  advance(20)
  expect.state("trial", "measured")
end)

test("starts on the opponents' side if the parameter requests it", function()
  set_param("trial.side", "opponent")
  set_param("trial.event", "none")
  load_scenario "trial"
  set_truth(3.2, 3.5, math.rad(-90))
  advance(0.1)
  expect.action("put_down")
  set_belief(3.2, 3.5, math.rad(-90))
  advance(40.2)
  advance(60)
  expect.verdict(true, "0.00 m")
end)
