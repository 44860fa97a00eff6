--- Tests of behaviors/goalkeeper.lua and lib/ball.lua.

-- SPDX-License-Identifier: MIT

local function begin(x, y)
  load_interface "ball"
  load_behavior "goalkeeper"
  set_world { game = { state = "playing" }, pose = { x = x, y = y, rotation = 0.0 } }
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

test("stands before the middle of its goal while it does not know the ball", function()
  begin(-3.7, 0)
  advance(2)
  expect.state("goalkeeper", "guarding/standing")
  expect.walk(0, 0, 0)
end)

test("moves between the ball and the goal, and follows the ball on the way", function()
  begin(-3.7, 0)
  show_ball(1.5, 3.0)
  advance(0.5)
  expect.state("goalkeeper", "guarding/moving")
  expect.state("goalkeeper/walk_to", "walking")
  show_ball(3.0, 0)
  advance(0.5)
  expect.state("goalkeeper", "guarding/standing")
  expect.reason("goalkeeper", "it stands before the goal")
end)

test("clears a ball that comes near and returns", function()
  begin(-3.7, 0)
  show_ball(0.9, 0.1)
  advance(0.6)
  expect.state("goalkeeper", "clearing")
  expect.state("goalkeeper/approach_ball", "approaching")
  show_ball(3.0, 0.0)
  advance(0.7)
  expect.state("goalkeeper", "guarding/standing")
end)

test("does not leave its goal while the game is not running", function()
  begin(-3.7, 0)
  set_world { game = { state = "set" } }
  show_ball(0.9, 0.1)
  advance(1)
  expect.state("goalkeeper", "guarding/standing")
end)
