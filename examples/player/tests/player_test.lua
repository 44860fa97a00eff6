--- Tests of behaviors/player.lua.

-- SPDX-License-Identifier: MIT

local function begin(state, kick_off)
  load_interface "ball"
  load_behavior "player"
  set_world {
    game = { state = state, kick_off = kick_off },
    pose = { x = -2.2, y = 0.0, rotation = 0.0, known = true },
  }
  advance(0.2)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
  advance(0.1)
end

test("stands in every state in which the referee does not let the robots walk", function()
  begin "initial"
  for _, state in ipairs { "initial", "set", "finished", "standby" } do
    set_world { game = { state = state } }
    show_ball(1.0, 0.0)
    expect.state("player", "waiting")
    expect.walk(0, 0, 0)
  end
end)

test("stands while the referee stops the game", function()
  begin "playing"
  set_world { game = { stopped = true } }
  advance(0.1)
  expect.state("player", "waiting")
  expect.reason("player", "the referee does not let the robots play")
end)

test("takes its position before the kick-off", function()
  begin "ready"
  advance(0.2)
  expect.state("player", "taking position")
  expect.state("player/hold_position", "returning")
  expect.walk(0.2, 0, 0)
end)

test("leaves the kick-off to the opponents until the ball moves", function()
  begin("set", "theirs")
  set_world { game = { state = "playing" } }
  advance(0.1)
  show_ball(2.2, 0.0)
  advance(1)
  expect.state("player", "playing/letting them kick off")
  show_ball(1.2, 0.0)
  advance(0.3)
  expect.state("player", "playing/lining up")
end)

test("does not wait for the opponents for longer than the kick-off", function()
  begin("set", "theirs")
  set_world { game = { state = "playing" } }
  show_ball(2.2, 0.0)
  advance(9)
  expect.state("player", "playing/letting them kick off")
  advance(1.5)
  expect.reason("player", "the time of the kick-off is over")
end)

test("searches the ball, lines up, kicks, and searches again", function()
  begin("playing", "ours")
  expect.state("player", "playing/searching")
  show_ball(2.0, 0.0)
  advance(0.1)
  expect.state("player", "playing/lining up")
  expect.state("player/line_up", "far")
  show_ball(0.2, 0.05)
  advance(0.5)
  expect.started "kick"
  expect.state("player", "playing/shooting")
  report_action("kick", "done")
  show_ball(1.0, 0.0)
  expect.state("player", "playing/lining up")
  expect.state("player/line_up", "far")
end)

test("lines up again after a kick that failed", function()
  begin("playing", "ours")
  show_ball(0.2, 0.05)
  advance(0.1)
  show_ball(1.0, 0.0)
  advance(0.4)
  expect.state("player", "playing/lining up")
end)

test("returns to its position when it does not find the ball, and lines up when it sees it there", function()
  begin("playing", "ours")
  advance(25.2)
  expect.state("player", "playing/returning")
  set_world { pose = { x = -1.2, y = 0.0 } }
  advance(1.5)
  expect.state("player", "playing/searching")
  expect.reason("player", "the robot is at its position")
  set_world { pose = { x = -2.2, y = 0.0 } }
  advance(25.2)
  expect.state("player", "playing/returning")
  show_ball(2.0, 0.0)
  advance(0.1)
  expect.state("player", "playing/lining up")
end)

test("searches again when it loses the ball", function()
  begin("playing", "ours")
  show_ball(2.0, 0.0)
  advance(0.1)
  expect.state("player", "playing/lining up")
  advance(3.2)
  expect.state("player", "playing/searching")
  expect.reason("player", "the ball is lost")
end)

test("does nothing after a fall, and plays again on its feet", function()
  begin("playing", "ours")
  set_world { robot = { posture = "lying" } }
  advance(0.1)
  expect.state("player", "down")
  set_world { robot = { posture = "upright" } }
  advance(0.2)
  expect.state("player", "playing/searching")
end)

test("looks at the room while its orientation is unknown, if the room decides", function()
  begin("playing", "ours")
  set_world { robot = { posture = "lying" }, confidence = { coverage = 0.9 }, pose = { known = false } }
  advance(0.1)
  set_world { robot = { posture = "upright" } }
  advance(0.2)
  expect.state("player", "playing/orienting")
  set_world { confidence = { evidence = -20 } }
  advance(1)
  expect.state("player", "playing/searching")
  expect.reason("player", "the orientation is known")
end)

test("does not look at the room for longer than its time", function()
  begin("playing", "ours")
  set_world { robot = { posture = "lying" }, confidence = { coverage = 0.9 }, pose = { known = false } }
  advance(0.1)
  set_world { robot = { posture = "upright" } }
  advance(6.3)
  expect.state("player", "playing/searching")
  expect.reason("player", "the room does not decide in time")
end)

test("stands while it is penalized, and plays after the penalty", function()
  begin("playing", "ours")
  set_world { robot = { penalized = true } }
  show_ball(1.0, 0.0)
  expect.state("player", "sitting out")
  expect.walk(0, 0, 0)
  set_world { robot = { penalized = false } }
  advance(0.2)
  expect.state("player", "playing/lining up")
end)

test("lets kidnap_recovery find the pose after a lift", function()
  begin("playing", "ours")
  load_behavior "kidnap_recovery"
  set_world { robot = { posture = "lifted" } }
  advance(1)
  expect.state("player", "down")
  set_world { robot = { posture = "upright" } }
  advance(0.5)
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.state("player", "finding itself")
  expect.walk(0, 0, 0.4)
end)
