--- Tests of scenarios/patrol.lua and lib/ground_truth.lua.

-- SPDX-License-Identifier: MIT

local function set_truth(x, y, rotation) set_world { truth = { x = x, y = y, rotation = rotation } } end

local function start()
  load_scenario "patrol"
  set_world { pose = { x = -3.2, y = -3.5, rotation = math.rad(90) } }
  set_truth(-3.2, -3.5, math.rad(90))
  advance(0.2)
  expect.action("put_down")
  expect.action("set_initial_pose")
  expect.state("patrol", "walking/on its way")
end

test("succeeds when the belief is right after the whole time", function()
  start()
  advance(599)
  expect.state("patrol", "walking/on its way")
  advance(2)
  expect.verdict(true, "right in the end; it was wrong for 0.0 s")
end)

test("reports for how long the belief was wrong", function()
  start()
  set_truth(-3.2, -2.9, math.rad(90))
  advance(10)
  set_truth(-3.2, -3.2, math.rad(90))
  advance(591)
  expect.verdict(true, "wrong for 10.0 s")
end)

test("fails when the belief is wrong in the end", function()
  start()
  advance(590)
  set_truth(3.2, 3.5, math.rad(-90))
  advance(11)
  expect.verdict(false, "9.48 m and 180 degrees off")
end)

test("a wrong direction is wrong, too", function()
  start()
  advance(590)
  set_truth(-3.2, -3.5, math.rad(130))
  advance(11)
  expect.verdict(false, "0.00 m and 40 degrees off")
end)

test("reports on its way", function()
  start()
  advance(60)
  expect.log("wrong for 0.0 s so far: truth (-3.20, -3.50, 90 deg)")
end)

test("the duration can be set", function()
  set_param("patrol.duration", "20")
  start()
  advance(20)
  expect.verdict(true, "right in the end")
end)

test("loads the behaviors that it needs", function()
  start()
  expect.state("orientation", "watching/unconfirmed")
  expect.state("background_training", "waiting")
  expect.state("penalty_marks", "walking")
end)
