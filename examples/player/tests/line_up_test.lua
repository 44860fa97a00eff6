--- Tests of behaviors/line_up.lua and lib/aim.lua.

-- SPDX-License-Identifier: MIT

local function begin(x, y, rotation)
  load_interface "ball"
  load_behavior "line_up"
  set_world { game = { state = "playing" }, pose = { x = x, y = y, rotation = rotation } }
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
  advance(0.1)
end

test("stands while the ball is unknown", function()
  begin(0, 0, 0)
  advance(1)
  expect.state("line_up", "far")
  expect.walk(0, 0, 0)
end)

test("walks straight at a ball that lies between it and the goal", function()
  begin(0, 0, 0)
  show_ball(2.0, 0.0)
  expect.state("line_up", "far")
  expect.walk(0.25, 0, 0)
end)

test("turns before it walks to a ball behind it", function()
  begin(0, 0, 0)
  show_ball(-2.0, 0.1)
  expect.walk(0, 0, 0.8)
end)

test("walks sideways around a near ball that lies on its own side", function()
  begin(2.0, 0, math.pi)
  show_ball(0.35, 0.0)
  advance(0.1)
  expect.state("line_up", "around")
  show_ball(1.5, 0.0)
  expect.state("line_up", "far")
  expect.reason("line_up", "the ball is far again")
end)

test("is done when the ball lies before a foot and the goal is ahead", function()
  begin(0, 0, 0)
  show_ball(0.4, 0.0)
  advance(0.2)
  expect.state("line_up", "closing in")
  show_ball(0.2, 0.05)
  expect.state("line_up", "at the ball")
  expect.reason("line_up", "the ball lies before a foot, and the goal is ahead")
end)

test("is not done before a ball that it would kick beside the goal", function()
  begin(0, 0, math.rad(60))
  show_ball(0.2, 0.05)
  advance(0.2)
  expect.state("line_up", "around")
end)

test("walks around again when the goal is not behind the ball any more", function()
  begin(0, 0, 0)
  show_ball(0.4, 0.0)
  advance(0.2)
  set_world { pose = { rotation = math.rad(80) } }
  show_ball(0.4, 0.0)
  expect.state("line_up", "around")
  expect.reason("line_up", "the robot is not behind the ball any more")
  set_world { pose = { rotation = 0.0 } }
  advance(0.1)
  show_ball(1.5, 0.0)
  expect.state("line_up", "far")
end)

test("leaves its goal before it walks along the goal line", function()
  begin(-4.6, 0.7, math.rad(90))
  show_ball(1.5, 0.0)
  expect.state("line_up", "leaving the goal")
  expect.walk(0, -0.2, 0)
  set_world { pose = { x = -3.7 } }
  advance(0.1)
  expect.state("line_up", "far")
  expect.reason("line_up", "the goal is free")
end)

test("walks around a ball that comes near while it leaves the goal", function()
  begin(-4.6, 0.7, math.rad(90))
  show_ball(1.5, 0.0)
  show_ball(0.5, 0.0)
  expect.state("line_up", "around")
end)
