--- Tests of behaviors/striker.lua.

-- SPDX-License-Identifier: MIT

local function begin(state)
  load_interface "ball"
  load_behavior "striker"
  set_world { game = { state = state, kick_off = "theirs" }, pose = { x = -3.0, y = 0.0, rotation = 0.0 } }
  advance(0.1)
end

test("walks to its place before the kick-off and waits there", function()
  begin "ready"
  expect.state("striker", "before the kick-off")
  expect.state("striker/kick_off/walk_to", "walking")
  expect.walk(0.2, 0, 0)
  set_world { pose = { x = -1.2, y = 0.0, rotation = 0.0 } }
  advance(0.5)
  expect.state("striker/kick_off", "positioning/there")
  set_world { game = { state = "set" } }
  advance(0.1)
  expect.state("striker/kick_off", "set")
  expect.state("striker/kick_off/walk_to", "")
  expect.walk(0, 0, 0)
end)

test("plays after the kick-off, and obeys the next one", function()
  begin "set"
  set_world { game = { state = "playing", kick_off = "ours" } }
  advance(0.2)
  expect.state("striker", "playing")
  set_world { game = { state = "ready" } }
  advance(0.2)
  expect.state("striker", "before the kick-off")
  expect.state("striker/kick_off", "positioning/walking")
  expect.state("striker/search_ball", "")
end)

test("runs search, approach and kick at the same time when the ball is in play", function()
  begin "playing"
  expect.state("striker", "playing")
  expect.state("striker/search_ball", "searching/with the head")
  set_input { ball = { seen = true, position = { x = 1.5, y = 0.0 }, distance = 1.5 } }
  advance(0.2)
  expect.state("striker/search_ball", "following")
  expect.state("striker/approach_ball", "approaching")
  set_input { ball = { seen = true, position = { x = 0.2, y = 0.05 }, distance = 0.21 } }
  advance(0.5)
  expect.state("striker/kick_ball", "kicking")
  expect.started("kick", { foot = "left" })
  expect.walk(0, 0, 0)
end)

test("stops everything when the game stops or it is penalized", function()
  begin "playing"
  set_input { ball = { seen = true, position = { x = 1.5, y = 0.0 }, distance = 1.5 } }
  advance(0.2)
  set_world { robot = { penalized = true } }
  advance(0.1)
  expect.state("striker", "before the kick-off")
  expect.state("striker/kick_off", "standing")
  expect.state("striker/approach_ball", "")
  expect.walk(0, 0, 0)
  set_world { robot = { penalized = false } }
  advance(0.2)
  expect.state("striker", "playing")
  set_world { game = { state = "finished" } }
  advance(0.1)
  expect.state("striker", "before the kick-off")
  expect.walk(0, 0, 0)
end)
