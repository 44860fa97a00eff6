--- Tests of behaviors/kick_off.lua.

-- SPDX-License-Identifier: MIT

local FAR = { x = -3.0, y = 1.0, rotation = 0.0 }

local function begin(state, kick_off, arguments)
  load_interface "ball"
  load_behavior("kick_off", arguments or {})
  set_world { game = { state = state, kick_off = kick_off }, pose = FAR }
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

-- Stands at its place until the game is set, with the ball 1.2 m ahead.
local function be_set(kick_off)
  begin("ready", kick_off)
  set_world { pose = { x = -1.2, y = 0.0, rotation = 0.0 }, game = { state = "set", kick_off = kick_off } }
  show_ball(1.2, 0.0)
  advance(1)
  expect.state("kick_off", "set")
end

test("stands still in initial, set and finished, and while it is penalized", function()
  begin("initial", "ours")
  for _, state in ipairs { "initial", "set", "finished" } do
    set_world { game = { state = state } }
    advance(0.5)
    expect.walk(0, 0, 0)
    expect.state("kick_off/walk_to", "")
  end
  for _, state in ipairs { "ready", "set", "playing" } do
    set_world { game = { state = state }, robot = { penalized = true } }
    advance(0.5)
    expect.state("kick_off", "standing")
    expect.walk(0, 0, 0)
  end
end)

test("walks to its place in ready, turns to the ball and stays", function()
  begin("ready", "theirs", { x = -2.0, y = -1.0 })
  expect.state("kick_off", "positioning/walking")
  expect.walk(0.0, 0.0, -0.6)   -- first it turns
  set_world { pose = { x = -2.0, y = -1.0, rotation = 0.0 } }
  show_ball(2.0, 1.0)
  advance(0.5)
  expect.state("kick_off", "positioning/walking")   -- it looks past the ball
  set_world { pose = { x = -2.0, y = -1.0, rotation = 0.46 } }
  show_ball(2.2, 0.0)
  advance(0.5)
  expect.state("kick_off", "positioning/there")
  expect.walk(0, 0, 0)
end)

test("walks again if it is moved away from its place", function()
  begin("ready", "theirs")
  set_world { pose = { x = -1.2, y = 0.0, rotation = 0.0 } }
  advance(0.5)
  expect.state("kick_off", "positioning/there")
  set_world { pose = { x = -2.0, y = 0.0, rotation = 0.0 } }
  advance(0.7)
  expect.state("kick_off", "positioning/walking")
  expect.walk(0.2, 0, 0)
end)

test("waits behind the ball if it takes the own kick-off", function()
  begin("ready", "ours")
  set_world { pose = { x = -0.35, y = 0.0, rotation = 0.0 } }
  advance(0.5)
  expect.state("kick_off", "positioning/there")
end)

local function expect_outside_of_the_circle(kick_off, takes)
  begin("ready", kick_off, { x = 0.0, y = 0.0, takes = takes })
  set_world { pose = { x = -0.35, y = 0.0, rotation = 0.0 } }
  advance(0.5)
  expect.state("kick_off", "positioning/walking")
  set_world { pose = { x = -1.0, y = 0.0, rotation = 0.0 } }
  advance(0.5)
  expect.state("kick_off", "positioning/there")
end

test("stays out of the center circle if the others kick off, wherever its place is",
  function() expect_outside_of_the_circle("theirs", true) end)

test("stays out of the center circle if it is unknown who kicks off",
  function() expect_outside_of_the_circle(nil, true) end)

test("stays out of the center circle if a teammate kicks off",
  function() expect_outside_of_the_circle("ours", false) end)

test("goes for the ball at once at the own kick-off", function()
  be_set("ours")
  set_world { game = { state = "playing" } }
  advance(0.1)
  expect.state("kick_off", "over")
  expect.reason("kick_off", "it is the own kick-off")
end)

test("waits at the others' kick-off until the ball has moved", function()
  be_set("theirs")
  set_world { game = { state = "playing" } }
  advance(3)
  expect.state("kick_off", "waiting")
  expect.walk(0, 0, 0)
  show_ball(1.4, 0.2)   -- an error of the detector
  advance(2)
  expect.state("kick_off", "waiting")
  show_ball(0.6, 0.4)
  advance(0.5)
  expect.state("kick_off", "over")
  expect.reason("kick_off", "the ball has moved")
end)

test("a ball that was measured wrongly once has not moved", function()
  be_set("theirs")
  set_world { game = { state = "playing" } }
  show_ball(2.4, 0.2)
  advance(0.1)
  show_ball(1.2, 0.0)
  advance(1)
  expect.state("kick_off", "waiting")
end)

test("goes for the ball 10 s after the others' kick-off", function()
  be_set("theirs")
  set_world { game = { state = "playing" } }
  advance(9.5)
  expect.state("kick_off", "waiting")
  advance(1)
  expect.state("kick_off", "over")
  expect.reason("kick_off", "the ball is free")
end)

test("waits for the time that wait_time sets", function()
  set_param("kick_off.wait_time", 2)
  be_set("theirs")
  set_world { game = { state = "playing" } }
  advance(1.5)
  expect.state("kick_off", "waiting")
  advance(1)
  expect.state("kick_off", "over")
end)

test("learns where the ball lies while it waits if it did not see it before", function()
  begin("set", "theirs")
  set_world { game = { state = "playing" } }
  advance(0.5)
  show_ball(2.0, 0.0)
  advance(1)
  expect.state("kick_off", "waiting")
  show_ball(1.0, 0.0)
  advance(0.5)
  expect.state("kick_off", "over")
end)

test("goes for the ball if it is started in the game", function()
  begin("playing", "theirs")
  expect.state("kick_off", "over")
end)

test("goes for the ball without a referee", function()
  begin "unknown"
  expect.state("kick_off", "over")
  expect.reason("kick_off", "the game runs")
end)

test("stands while it is penalized during the others' kick-off, and plays afterwards", function()
  be_set("theirs")
  set_world { game = { state = "playing" } }
  advance(1)
  set_world { robot = { penalized = true } }
  advance(0.5)
  expect.state("kick_off", "standing")
  set_world { robot = { penalized = false } }
  advance(0.1)
  expect.state("kick_off", "over")
end)

test("follows the ball with the head while it stands", function()
  be_set("theirs")
  show_ball(1.2, 0.0)
  advance(0.1)
  expect.state("kick_off/search_ball", "following")
  set_world { game = { state = "playing" } }
  show_ball(1.2, 0.0)
  advance(0.2)
  expect.state("kick_off/search_ball", "following")
end)
