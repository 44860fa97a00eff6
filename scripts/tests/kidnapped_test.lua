--- Tests of scenarios/kidnapped.lua and lib/ground_truth.lua.

-- SPDX-License-Identifier: MIT

local function set_truth(x, y, rotation) set_world { truth = { x = x, y = y, rotation = rotation } } end
local function set_belief(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

--- Up to the moment when the robot stands elsewhere.
local function put_down()
  load_scenario "kidnapped"
  set_belief(1, 0.5, 0)
  set_truth(1, 0.5, 0)
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  advance(60.1)
  expect.state("kidnapped", "carrying")
  expect.action("pick_up")
  expect.log("lifted")
  set_world { robot = { posture = "lifted" } }
  advance(2.1)
  expect.state("kidnapped", "elsewhere/lost")
  expect.reason("kidnapped", "the robot is placed elsewhere")
  expect.action("put_down")
  set_world { robot = { posture = "upright" } }
  set_truth(1.6, 2.0, -2.0)
  advance(1)
end

--- The room supports the belief, right or wrong.
local function become_sure()
  set_world { confidence = { evidence = -9, current = 0.9, status = "usable", age = 60 }, pose = { cluster_weight = 0.9 } }
  advance(6)
  expect.state("kidnap_recovery", "recovered")
end

test("succeeds when the robot stands on the right mark", function()
  put_down()
  become_sure()
  set_truth(-3.1, 0.1, 0)
  set_belief(-3.2, 0, 0)
  advance(1)
  expect.verdict(true, "walked to the correct mark")
end)

test("fails when the robot believes that it stands on a mark, and reports the error of the belief", function()
  put_down()
  become_sure()
  set_truth(-2.2, 1, math.rad(30))
  set_belief(-3.2, 0, 0)
  advance(1)
  expect.verdict(false, "1.41 m and 30 degrees off")
end)

test("fails on the reflected mark", function()
  put_down()
  become_sure()
  set_truth(3.2, 0, math.pi)
  set_belief(-3.2, 0, 0)
  advance(1)
  expect.verdict(false, "6.40 m and 180 degrees off")
end)

test("does not fail while the robot believes that it stands on a mark but still searches", function()
  put_down()
  set_belief(-3.2, 0, 0)
  advance(10)
  expect.state("kidnapped", "elsewhere/lost")
end)

test("fails when the time is up, and reports the error of the belief", function()
  put_down()
  set_belief(-1, 0, -2)
  advance(181)
  expect.verdict(false, "did not reach its mark in time; its belief is 3.28 m and 0 degrees off")
end)

test("loads the behaviors that it needs", function()
  put_down()
  expect.state("orientation", "watching/unconfirmed")
  expect.state("get_up", "idle")
  expect.state("background_training", "waiting")
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.state("penalty_marks", "waiting")
end)

test("the time to learn can be set", function()
  set_param("kidnapped.learn", "1")
  set_truth(0, 0, 0)
  load_scenario "kidnapped"
  advance(1.2)
  expect.state("kidnapped", "carrying")
end)
