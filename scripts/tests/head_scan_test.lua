--- Tests of behaviors/head_scan.lua.

-- SPDX-License-Identifier: MIT

test("sweeps over the walls and then over the field", function()
  load_behavior "head_scan"
  advance(0.1)
  expect.head(1.1, -0.1)
  set_world { robot = { head_yaw = 1.09 } }
  advance(0.1)
  expect.state("head_scan", "walls to the right")
  expect.head(-1.1, -0.1)
  set_world { robot = { head_yaw = -1.09 } }
  advance(0.1)
  expect.state("head_scan", "field to the left")
  expect.head(1.1, 0.25)
  set_world { robot = { head_yaw = 1.09 } }
  advance(0.1)
  expect.state("head_scan", "field to the right")
  expect.head(-1.1, 0.25)
  set_world { robot = { head_yaw = -1.09 } }
  advance(0.1)
  expect.state("head_scan", "walls to the left")
  expect.reason("head_scan", "the side is reached")
end)

test("looks only at the lines while the robot searches for its position", function()
  set_world { pose = { tracked = false } }
  load_behavior "head_scan"
  advance(0.1)
  expect.state("head_scan", "walls to the left")
  expect.head(1.1, 0.25)
  set_world { pose = { tracked = true } }
  advance(0.1)
  expect.head(1.1, -0.1)
end)

test("looks at the walls again if the lines do not show the position", function()
  set_world { pose = { tracked = false } }
  load_behavior "head_scan"
  advance(15.9)   -- the head never reaches a side here, so each state lasts 4 s
  expect.state("head_scan", "field to the right")
  advance(0.2)
  expect.state("head_scan", "walls to the left")
  expect.head(1.1, -0.1)
  set_world { pose = { tracked = true } }
  advance(0.1)
  set_world { pose = { tracked = false } }
  advance(0.1)
  expect.head(1.1, 0.25)
end)

test("turns back when a side cannot be reached", function()
  load_behavior "head_scan"
  advance(4.2)
  expect.state("head_scan", "walls to the right")
  expect.reason("head_scan", "the side cannot be reached")
  for _, next_state in ipairs { "field to the left", "field to the right", "walls to the left" } do
    advance(4.0)
    expect.state("head_scan", next_state)
  end
end)

test("the width can be set live", function()
  load_behavior "head_scan"
  advance(0.1)
  set_param("head_scan.width", "0.7")
  advance(0.1)
  expect.head(0.7, -0.1)
end)
