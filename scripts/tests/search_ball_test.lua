--- Tests of behaviors/search_ball.lua.

-- SPDX-License-Identifier: MIT

local function begin()
  load_interface "ball"
  load_behavior "search_ball"
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

test("turns the head from side to side while it has not seen the ball", function()
  begin()
  expect.state("search_ball", "searching/with the head")
  expect.head(1.0, 0.3)
  set_world { robot = { head_yaw = 0.95 } }
  advance(0.1)
  expect.head(-1.0, 0.3)
end)

test("turns the body if the head did not find the ball, and rests after a rotation", function()
  begin()
  advance(4.1)
  expect.reason("search_ball", "the head did not find the ball")
  expect.walk(0, 0, 0.6)
  advance(12.1)
  expect.state("search_ball", "searching/with the head")
end)

test("begins the search on the side where it saw the ball last", function()
  begin()
  show_ball(1.0, -0.5)
  advance(0.2)
  set_input { ball = { seen = false } }
  advance(1.6)
  expect.state("search_ball", "searching/with the head")
  expect.head(-1.0, 0.3)
  advance(4.1)
  expect.state("search_ball", "searching/with the body")
  expect.walk(0, 0, -0.6)
end)

test("turns only the head while the referee does not permit walking", function()
  begin()
  set_world { robot = { may_walk = false } }
  advance(6)
  expect.state("search_ball", "searching/with the head")
end)

test("follows the ball with the head", function()
  begin()
  show_ball(1.0, 0.5)
  advance(0.2)
  expect.state("search_ball", "following")
  expect.head(math.atan(0.5, 1.0), math.atan(0.5, math.sqrt(1.25)) - 0.1)
end)

test("searches again when the ball was not seen for some time", function()
  begin()
  show_ball(1.0, 0.5)
  advance(0.2)
  set_input { ball = { seen = false } }
  advance(1.0)
  expect.state("search_ball", "following")
  advance(1.0)
  expect.reason("search_ball", "the ball is not seen")
end)

test("searches when the detector sets no more values", function()
  begin()
  show_ball(1.0, 0.5)
  advance(0.2)
  advance(2.5)
  expect.state("search_ball", "searching/with the head")
end)
