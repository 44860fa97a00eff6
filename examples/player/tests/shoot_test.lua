--- Tests of behaviors/shoot.lua.

-- SPDX-License-Identifier: MIT

local function begin(rotation)
  load_interface "ball"
  load_behavior "shoot"
  set_world { game = { state = "playing" }, pose = { x = 0, y = 0, rotation = rotation } }
end

local function show_ball(x, y)
  set_input { ball = { seen = true, position = { x = x, y = y }, distance = math.sqrt(x * x + y * y) } }
end

test("stands still, then kicks with the foot before which the ball lies", function()
  begin(0)
  show_ball(0.2, -0.05)
  set_world { robot = { speed = 0.2 } }
  advance(0.5)
  expect.state("shoot", "stopping")
  expect.walk(0, 0, 0)
  set_world { robot = { speed = 0.0 } }
  advance(0.5)
  expect.state("shoot", "kicking")
  expect.started("kick", { foot = "right", direction = 0 })
  report_action("kick", "done")
  advance(0.1)
  expect.state("shoot", "kicked")
end)

test("kicks into the direction that needs the smallest turn", function()
  begin(0)
  set_world { pose = { x = 0, y = -1.5 } }
  show_ball(0.2, 0.0)
  advance(1)
  local left, right = math.atan(0.8 + 1.5, 4.5 - 0.2), math.atan(-0.8 + 1.5, 4.5 - 0.2)
  local middle, slack = (left + right) / 2, (left - right) / 2 - 0.15
  expect.started("kick", { foot = "right", direction = middle - slack })
end)

test("does not kick a ball that is far or would miss the goal", function()
  begin(0)
  show_ball(0.6, 0.0)
  advance(0.5)
  expect.not_started "kick"
  expect.state("shoot", "missed")
  expect.reason("shoot", "the ball is out of reach")
end)

test("does not kick toward its own goal", function()
  begin(math.pi)
  show_ball(0.2, 0.05)
  advance(0.5)
  expect.not_started "kick"
  expect.state("shoot", "missed")
end)

test("has failed if the robot does not stand still in time", function()
  begin(0)
  set_world { robot = { speed = 0.2 } }
  show_ball(0.2, 0.05)
  advance(2.2)
  expect.not_started "kick"
  expect.reason("shoot", "the robot did not stand still in time")
end)

test("has failed if the kick failed", function()
  begin(0)
  show_ball(0.2, 0.05)
  advance(0.5)
  report_action("kick", "failed", "no support")
  advance(0.1)
  expect.state("shoot", "refused")
  expect.log("the kick failed: no support")
end)
