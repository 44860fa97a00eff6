--- Tests of behaviors/approach_ball.lua.

-- SPDX-License-Identifier: MIT

local function begin()
  load_interface "ball"
  load_behavior "approach_ball"
  set_world { game = { state = "playing" }, pose = { x = 0, y = 0, rotation = 0, known = true } }
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

test("waits until the ball is known", function()
  begin()
  advance(2)
  expect.state("approach_ball", "waiting")
end)

test("walks at a point behind the ball", function()
  begin()
  show_ball(2.0, 0.0)
  advance(0.2)
  expect.state("approach_ball", "approaching")
  expect.walk(0.2, 0, -2 * math.atan(0.05, 1.78))
end)

test("turns toward a ball behind it before it walks", function()
  begin()
  show_ball(-2.0, 0.3)
  advance(0.2)
  expect.walk(0, 0, 0.8)
end)

test("stands when the ball lies before a foot in the direction of the goal", function()
  begin()
  show_ball(0.22, 0.05)
  advance(0.2)
  expect.state("approach_ball", "at the ball")
  expect.walk(0, 0, 0)
end)

test("steps around a ball that it meets from the wrong side", function()
  begin()
  set_world { pose = { x = 1.0, y = 0, rotation = math.pi } }
  show_ball(0.45, 0.0)
  advance(0.2)
  expect.state("approach_ball", "approaching")
  expect.walk(0, -0.12, 0)
end)

test("goes after a ball that rolls away", function()
  begin()
  show_ball(0.22, 0.05)
  advance(0.2)
  show_ball(0.8, 0.05)
  advance(1)
  expect.state("approach_ball", "approaching")
  expect.reason("approach_ball", "the ball has moved")
end)

test("sends its teammates its distance from the ball", function()
  begin()
  show_ball(2.0, 0.0)
  advance(0.6)
  expect.message("ball 2.00")
end)

test("leaves the ball to a teammate that is nearer, until the teammate sends no more messages", function()
  begin()
  show_ball(2.0, 0.0)
  hear(3, "ball 1.00")
  advance(0.7)
  expect.state("approach_ball", "supporting")
  expect.reason("approach_ball", "a teammate is nearer to the ball")
  show_ball(2.0, 0.0)
  advance(2.5)
  expect.state("approach_ball", "approaching")
end)

test("does not leave the ball to a teammate that is about as near, or whose message it does not understand", function()
  begin()
  show_ball(2.0, 0.0)
  hear(3, "ball 1.90")
  hear(4, "ball 0.1e")
  hear(5, "")
  advance(1.0)
  expect.state("approach_ball", "approaching")
end)

test("waits while the game does not run", function()
  begin()
  show_ball(2.0, 0.0)
  advance(0.2)
  set_world { game = { state = "ready" } }
  advance(0.2)
  expect.state("approach_ball", "waiting")
  expect.reason("approach_ball", "the robot may not walk")
end)
