--- Tests of behaviors/find_ball.lua.

-- SPDX-License-Identifier: MIT

local function begin()
  load_interface "ball"
  load_behavior "find_ball"
  set_world { game = { state = "playing" }, pose = { x = -2.0, y = 0.0, rotation = 0.5 } }
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
  advance(0.1)
end

test("looks at the center mark first, then all around, then at the center mark again", function()
  begin()
  expect.state("find_ball", "looking at the center")
  expect.head(-0.5, 0.0)
  advance(4.1)
  expect.state("find_ball", "looking around")
  expect.state("find_ball/search_ball", "searching/with the head")
  advance(20.1)
  expect.state("find_ball", "looking at the center")
  expect.reason("find_ball", "the ball was not found")
end)

test("follows the ball when it sees it at the center", function()
  begin()
  show_ball(2.0, 0.5)
  advance(0.1)
  expect.state("find_ball", "following")
  expect.state("find_ball/search_ball", "following")
end)

test("follows the ball when it sees it elsewhere, until it is lost", function()
  begin()
  advance(5)
  show_ball(1.0, 1.0)
  expect.state("find_ball", "following")
  expect.reason("find_ball", "the ball is seen")
  advance(3.2)
  expect.state("find_ball", "looking at the center")
  expect.reason("find_ball", "the ball is lost")
end)
