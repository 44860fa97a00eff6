--- Tests of scenarios/learned_mirrored.lua.

-- SPDX-License-Identifier: MIT

local function learn(remedy)
  set_param("learned_mirrored.learn", "5")
  set_param("learned_mirrored.timeout", "10")
  set_param("learned_mirrored.remedy", remedy)
  load_scenario "learned_mirrored"
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  set_world {
    truth = { x = 1, y = 0.5, rotation = 0.3 },
    pose = { x = -1, y = -0.5, rotation = 0.3 - math.pi },
  }
  advance(5.1)
  expect.state("learned_mirrored", "measured")
end

local function believe_truth() set_world { pose = { x = 1, y = 0.5, rotation = 0.3 } } end

local function expect_success()
  believe_truth()
  advance(10.1)
  expect.verdict(true, "0.00 m and 0 degrees off")
end

test("fails without a remedy if the belief stays mirrored", function()
  learn("none")
  advance(10.1)
  expect.verdict(false, "2.24 m and 180 degrees off")
end)

test("sets the true pose as a remedy, and succeeds when the belief stays right", function()
  learn("set")
  expect.action("set_initial_pose")
  expect_success()
end)

test("sets the true pose again once the robot has flipped it", function()
  learn("set_again")
  expect.action("set_initial_pose")
  believe_truth()
  advance(1.0)
  set_world { pose = { x = -1, y = -0.5, rotation = 0.3 - math.pi } }
  advance(0.9)
  expect.state("learned_mirrored", "measured")
  advance(0.2)
  expect.state("learned_mirrored", "set again")
  expect.action("set_initial_pose")
  expect_success()
end)

test("does not set the pose again if the robot does not flip it", function()
  learn("set_again")
  believe_truth()
  advance(9.9)
  expect.state("learned_mirrored", "measured")
end)
