--- Tests of scenarios/mirrored_placement.lua.

-- SPDX-License-Identifier: MIT

local function set_truth(x, y, rotation) set_world { truth = { x = x, y = y, rotation = rotation } } end
local function set_belief(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

--- Advances until the robot stands at the reflection of its belief.
local function put_down()
  set_truth(-3.2, -3.5, math.rad(90))
  load_scenario "mirrored_placement"
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  set_belief(1, 0.5, 0)
  advance(40.1)
  expect.state("mirrored_placement", "carrying")
  expect.action("pick_up")
  set_world { robot = { posture = "lifted" } }
  advance(1.6)
  expect.state("mirrored_placement", "mirrored/lost")
  expect.action("put_down")
  set_world { robot = { posture = "upright" } }
  set_truth(-1, -0.5, math.pi)
  advance(0.1)
end

test("succeeds when the robot stands on the right mark", function()
  put_down()
  advance(30)
  set_truth(-3.1, 0.1, 0)
  set_belief(-3.2, 0, 0)
  advance(1)
  expect.verdict(true, "walked to the right mark")
  advance(200)   -- a run that a viewer watches continues
  expect.state("mirrored_placement", "right")
end)

test("fails when the robot stands on the wrong mark", function()
  put_down()
  advance(30)
  set_truth(3.1, 0.1, 0)
  set_belief(-3.2, 0, 0)
  advance(1)
  expect.verdict(false, "wrong mark")
end)

test("fails when the time is up", function()
  put_down()
  advance(121)
  expect.verdict(false, "in time")
end)

test("loads the behaviors that it needs", function()
  put_down()
  expect.state("orientation", "watching/unconfirmed")
  expect.state("get_up", "idle")
  expect.state("background_training", "disturbed")
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.state("goal_search", "put down")
  expect.state("penalty_marks", "waiting")
  expect.head(1.1, 0.25)
end)

test("succeeds with a robot that cannot walk when its belief stays correct", function()
  put_down()
  set_world { robot = { can_walk = false } }
  advance(30)
  set_truth(-1, -0.5, math.pi)
  set_belief(-1, -0.5, math.pi)
  advance(1)
  expect.state("mirrored_placement", "mirrored/lost")
  advance(1.5)
  expect.verdict(true, "noticed")
end)
