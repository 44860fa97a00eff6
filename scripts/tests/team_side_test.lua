--- Tests of behaviors/team_side.lua, and of the libraries side, side_report and team_evidence that it uses.

-- SPDX-License-Identifier: MIT

-- The robot stands at (-1, 0) by its belief and faces the opponents' goal, in a room that shows nothing.
local function begin()
  load_interface "ball"
  load_behavior "orientation"
  load_behavior "team_side"
  set_world {
    pose = { x = -1.0, y = 0.0, rotation = 0.0, known = false, tracked = true },
    confidence = { coverage = 0.9, paired = 0.5, distinctiveness = 0.0 },
  }
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

-- The teammates report the ball twice in a second.
local function hear_for(seconds, reports)
  for _ = 1, math.ceil(2 * seconds) do
    for sender, text in pairs(reports) do hear(sender, text) end
    show_ball(2.0, 0.0)
    advance(0.5)
  end
end

local AT_BALL = "side 1.00 0.00 0.20 0.00 4.3 1"          -- where the robot sees it
local AT_REFLECTION = "side -1.00 0.00 0.20 0.00 4.3 1"

local function play(state) set_world { game = { state = state } } end

test("cannot tell the side alone in a room that shows nothing", function()
  begin()
  show_ball(2.0, 0.0)
  advance(1.0)
  expect.state("team_side", "cannot tell")
  expect.log("no teammate reports the ball")
  advance(20)
  expect.no_command()
end)

test("flips when two teammates see the ball at the mirrored place", function()
  begin()
  hear_for(2, { [2] = AT_REFLECTION, [3] = AT_REFLECTION })
  expect.state("orientation", "correcting")
  expect.reason("orientation", "the mirrored pose won")
end)

test("believes its pose when two teammates see the ball where it sees it", function()
  begin()
  hear_for(2, { [2] = AT_BALL, [3] = AT_BALL })
  expect.state("team_side", "believed")
  expect.state("orientation", "watching/confirmed")
  expect.no_command("flip_pose")
end)

test("agrees with the team after the flip", function()
  begin()
  hear_for(2, { [2] = AT_REFLECTION, [3] = AT_REFLECTION })
  set_world { pose = { x = 1.0, y = 0.0, rotation = math.pi } }
  advance(0.1)
  hear_for(4, { [2] = AT_REFLECTION, [3] = AT_REFLECTION })
  expect.state("team_side", "believed")
  expect.no_command("flip_pose")
end)

test("one teammate alone is not enough for a flip", function()
  begin()
  hear_for(30, { [2] = "side -1.00 0.00 0.20 0.00 9.9 1" })
  expect.state("team_side", "mirrored")
  expect.no_command("flip_pose")
end)

test("a teammate that is not sure of its own side is worth nothing", function()
  begin()
  hear_for(30, { [2] = "side -1.00 0.00 0.20 0.00 0.0 1", [3] = "side -1.00 0.00 0.20 0.00 0.0 1" })
  expect.state("team_side", "cannot tell")
  expect.no_command()
end)

test("two teammates that contradict each other cause no flip", function()
  begin()
  hear_for(30, { [2] = AT_BALL, [3] = AT_REFLECTION })
  expect.state("team_side", "cannot tell")
  expect.no_command("flip_pose")
end)

test("what one teammate says is not certain enough to be remembered", function()
  begin()
  hear_for(5, { [2] = AT_BALL })
  expect.state("team_side", "believed")
  hear_for(5, { [2] = AT_BALL, [3] = AT_REFLECTION })
  expect.state("team_side", "cannot tell")
end)

test("a ball on the center mark tells nothing", function()
  begin()
  for _ = 1, 40 do
    hear(2, "side 0.02 0.01 0.20 0.00 4.3 1")
    hear(3, "side -0.03 0.00 0.20 0.00 4.3 1")
    show_ball(1.0, 0.0)
    advance(0.5)
  end
  expect.state("team_side", "cannot tell")
  expect.no_command()
end)

test("repeated looks at a ball that lies near the center count once", function()
  begin()
  for _ = 1, 60 do
    hear(2, "side -0.20 0.00 0.30 0.00 4.3 1")
    hear(3, "side -0.20 0.00 0.30 0.00 4.3 1")
    show_ball(1.2, 0.0)
    advance(0.5)
  end
  expect.no_command("flip_pose")
end)

test("old reports expire", function()
  begin()
  hear_for(2, { [2] = AT_BALL, [3] = AT_BALL })
  set_world { robot = { posture = "lifted" } }
  advance(0.5)
  set_world { robot = { posture = "upright" } }
  hear_for(1, { [2] = AT_BALL })
  expect.state("team_side", "believed")
  set_world { robot = { posture = "lifted" } }
  advance(0.5)
  set_world { robot = { posture = "upright" } }
  advance(2)
  expect.state("team_side", "cannot tell")
end)

test("reports from before a teammate's own side may have changed do not count", function()
  begin()
  hear_for(1, { [2] = AT_REFLECTION })
  hear_for(1, { [2] = "side -1.00 0.00 0.20 0.00 0.0 2" })
  expect.state("team_side", "cannot tell")
end)

test("ignores messages that are no reports", function()
  begin()
  local text = {
    "", "side", "ball 1.00", "side nan nan 0.20 0.00 4.3 1", "side -inf 0.00 0.20 0.00 4.3 1", "side 1e9 0.00 0.20 0.00 4.3 1",
    "side -1.00 0.00 0.20 0.00 99.0 1", "side -1.00 0.00 0.00 0.00 4.3 1", "side -1.00 0.00 0.20 60.00 4.3 1",
    "side -1.00 0.00 0.20 0.00 4.3 -1", "side -1.00 0.00 0.20 0.00 4.3", "side -1.00 0.00 0.20 0.00 4.3 1 ",
    "side -1.00 0.00 0.20 0.00 4.3 99999999999999999999999", "side -90.00 0.00 0.20 0.00 4.3 1",
    "SIDE -1.00 0.00 0.20 0.00 4.3 1", "\0side -1.00 0.00 0.20 0.00 4.3 1", string.rep("side -1.00 ", 20), "\xff\xfe",
  }
  for _ = 1, 3 do
    for which = 1, #text do
      hear(1 + which % 4, text[which])
      show_ball(2.0, 0.0)
      advance(0.1)
    end
  end
  expect.state("team_side", "cannot tell")
  expect.no_command()
end)

test("a whole team does not flip a pose that the room has confirmed", function()
  begin()
  set_world { confidence = { distinctiveness = 0.3, evidence = -8.0 } }
  advance(0.5)
  expect.state("orientation", "watching/confirmed")
  set_world { confidence = { evidence = 0.0 } }
  for _ = 1, 40 do
    for sender = 1, 30 do hear(sender, AT_REFLECTION) end
    show_ball(2.0, 0.0)
    advance(0.5)
  end
  expect.state("orientation", "watching/confirmed")
  expect.no_command("flip_pose")
end)

test("sends where it sees the ball, without what the team says", function()
  begin()
  hear_for(2, { [2] = AT_BALL, [3] = AT_BALL })
  expect.message("side 1.00 0.00 0.")
  expect.message(" 0.0 ")
end)

test("is sure of a side that the operator has just set", function()
  begin()
  set_world { pose = { x = -3.0, y = -2.0, rotation = 1.5, known = true } }
  advance(1.0)
  expect.state("team_side", "believed")
  expect.no_command()
end)

test("a lift ends what was certain before", function()
  begin()
  set_world { pose = { x = -3.0, y = -2.0, rotation = 1.5, known = true } }
  advance(1.0)
  set_world { robot = { posture = "lifted" } }
  advance(1.0)
  expect.log("not certain since a lift")
  set_world { robot = { posture = "upright" } }
  advance(1.0)
  expect.state("team_side", "cannot tell")
end)

test("certainty decays with the time and with falls", function()
  begin()
  set_world { pose = { x = -3.0, y = -2.0, rotation = 1.5, known = true } }
  advance(1.0)
  for _ = 1, 12 do
    set_world { robot = { posture = "lying" } }
    advance(0.2)
    set_world { robot = { posture = "upright" } }
    advance(0.2)
  end
  advance(1.0)
  expect.state("team_side", "cannot tell")
  set_world { pose = { x = -1.0, y = -2.0, rotation = 0.0, known = false } }
  advance(1.0)
  set_world { pose = { x = -3.0, y = -2.0, rotation = 1.5, known = true } }
  advance(2.0)
  expect.state("team_side", "believed")
  set_param("side.swap_time", "60")
  advance(60)
  expect.state("team_side", "cannot tell")
end)

test("a robot that believes to be in the opponents' half before the kick-off seems mirrored", function()
  begin()
  play("ready")
  set_world { pose = { x = 1.0 } }
  advance(1.0)
  play("set")
  advance(1.0)
  expect.state("team_side", "mirrored")
  expect.no_command("flip_pose")
  play("playing")
  hear_for(2, { [2] = "side -3.00 0.00 0.20 0.00 4.3 1" })
  expect.state("orientation", "correcting")
end)

test("a robot near the halfway line before the kick-off tells nothing", function()
  begin()
  play("ready")
  set_world { pose = { x = 0.0 } }
  advance(1.0)
  play("set")
  advance(1.0)
  set_world { robot = { posture = "lifted" } }
  advance(0.2)
  set_world { robot = { posture = "upright" } }
  advance(2.0)
  expect.state("team_side", "cannot tell")
end)

test("half-time keeps what was certain", function()
  begin()
  set_world { pose = { x = -3.0, y = -2.0, rotation = 1.5, known = true } }
  advance(1.0)
  set_world { game = { sides_changed = true }, pose = { x = 3.0, y = 2.0, rotation = 1.5 - math.pi } }
  advance(2.0)
  expect.state("team_side", "believed")
  expect.no_command("flip_pose")
end)

test("the room alone decides without team_side", function()
  load_interface "ball"
  load_behavior "orientation"
  set_world { pose = { x = -1.0, y = 0.0, rotation = 0.0, tracked = true }, confidence = { coverage = 0.9, distinctiveness = 0.3 } }
  hear_for(10, { [2] = AT_REFLECTION, [3] = AT_REFLECTION })
  expect.no_command()
  set_world { confidence = { evidence = 8.5 } }
  advance(0.3)
  expect.command("flip_pose", "granted")
end)
