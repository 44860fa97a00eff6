--- Tests of scenarios/fallen.lua and lib/ground_truth.lua.

-- SPDX-License-Identifier: MIT

local function set_pose(x, y, rotation)
  set_world { truth = { x = x, y = y, rotation = rotation }, pose = { x = x, y = y, rotation = rotation } }
end

--- Up to the moment when the robot lies.
local function fall()
  load_scenario "fallen"
  set_pose(1, 0.5, 0)
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  advance(60.1)
  expect.state("fallen", "pushed over/down")
  expect.reason("fallen", "the time to learn is over")
  expect.action("push_over")
  set_world { robot = { posture = "lying" }, truth = { fallen = true } }
  advance(3)
  expect.get_up(true)
end

local function get_up()
  set_world { robot = { posture = "upright" }, truth = { fallen = false } }
  advance(1)
  expect.command("reset_orientation", "granted")
end

test("succeeds when the robot got up and has confirmed a correct pose", function()
  fall()
  get_up()
  expect.state("fallen", "pushed over/up again")
  expect.reason("fallen", "the robot got up and reset its orientation")
  set_world { confidence = { evidence = -9 } }
  advance(9)
  expect.state("fallen", "pushed over/up again")
  advance(2)
  expect.verdict(true, "found it again")
end)

test("does not succeed with a correct but unconfirmed pose", function()
  fall()
  get_up()
  advance(30)
  expect.state("fallen", "pushed over/up again")
end)

test("does not succeed with a correct pose without a reset", function()
  fall()
  set_world { confidence = { evidence = -9 } }
  advance(30)
  expect.state("fallen", "pushed over/down")
end)

test("fails when the time is up, and reports the error of the belief", function()
  fall()
  get_up()
  set_world { confidence = { evidence = -9 }, pose = { x = -1, y = -0.5, rotation = math.pi } }
  advance(120)
  expect.verdict(false, "2.24 m and 180 degrees off")
end)

test("loads the behaviors that it needs", function()
  fall()
  expect.state("orientation", "fallen")
  expect.state("background_training", "disturbed")
  expect.state("goal_search", "disturbed")
  expect.state("penalty_marks", "disturbed")
  expect.state("kidnap_recovery", "undisturbed")
end)
