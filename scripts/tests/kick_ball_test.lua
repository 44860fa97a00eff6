--- Tests of behaviors/kick_ball.lua.

-- SPDX-License-Identifier: MIT

local function begin()
  load_interface "ball"
  load_behavior "kick_ball"
  advance(0.1)
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

test("does nothing before a ball was seen", function()
  begin()
  advance(5)
  expect.state("kick_ball", "waiting")
  expect.not_started "kick"
end)

test("kicks with the foot on whose side the ball lies", function()
  begin()
  show_ball(0.2, -0.05)
  advance(0.5)
  expect.started("kick", { foot = "right" })
  report_action("kick", "done")
  show_ball(0.2, 0.05)
  advance(0.5)
  expect.started("kick", { foot = "left" })
end)

test("does not kick a ball that is far, behind the robot, or was seen long ago", function()
  begin()
  show_ball(1.0, 0.0)
  advance(1)
  show_ball(-0.2, 0.0)
  advance(1)
  expect.not_started "kick"
  show_ball(0.2, 0.0)
  advance(0.1)
  show_ball(2.0, 0.0)
  advance(4)
  expect.not_started "kick"
end)

test("waits for the end of a kick, and kicks again", function()
  begin()
  show_ball(0.2, 0.1)
  advance(0.5)
  expect.state("kick_ball", "kicking")
  report_action("kick", "running")
  advance(1)
  expect.state("kick_ball", "kicking")
  expect.walk(0, 0, 0)
  report_action("kick", "done")
  show_ball(0.2, 0.1)
  advance(0.1)
  expect.reason("kick_ball", "the robot has kicked")
  advance(0.5)
  expect.started("kick", { foot = "left" })
end)

test("rests after a kick that failed", function()
  begin()
  show_ball(0.2, 0.1)
  advance(0.5)
  report_action("kick", "failed", "no support")
  advance(0.1)
  expect.state("kick_ball", "resting")
  expect.log("the kick failed: no support")
  show_ball(0.2, 0.1)
  advance(1.5)
  expect.not_started "kick"
  advance(1.0)
  expect.started "kick"
end)

test("rests if the application never reports the end of a kick", function()
  begin()
  show_ball(0.2, 0.1)
  advance(0.5)
  advance(4.1)
  expect.state("kick_ball", "resting")
  expect.log("the kick failed: the application did not report an end in time")
end)
