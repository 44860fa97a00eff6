--- Tests of behaviors/get_up.lua.

-- SPDX-License-Identifier: MIT

test("gets up after a moment of rest", function()
  load_behavior "get_up"
  advance(0.1)
  expect.get_up(false)
  set_world { robot = { posture = "lying" } }
  advance(0.5)
  expect.state("get_up", "lying")
  expect.get_up(false)
  advance(1.0)
  expect.state("get_up", "getting up")
  expect.get_up(true)
  set_world { robot = { posture = "upright" } }
  advance(0.1)
  expect.state("get_up", "idle")
  expect.get_up(false)
end)

test("does not move while it is lifted, in any attitude", function()
  load_behavior "get_up"
  set_world { robot = { posture = "lifted" } }
  advance(3)
  expect.state("get_up", "idle")
  expect.get_up(false)
end)

test("stops when it is lifted", function()
  load_behavior "get_up"
  set_world { robot = { posture = "lying" } }
  advance(2)
  expect.get_up(true)
  set_world { robot = { posture = "lifted" } }
  advance(0.1)
  expect.state("get_up", "idle")
  expect.reason("get_up", "the robot stands again or is lifted")
  expect.get_up(false)
end)

test("waits again after it was helped up before it started to get up", function()
  load_behavior "get_up"
  for _, help in ipairs { "upright", "getting_up", "lifted" } do
    set_world { robot = { posture = "lying" } }
    advance(0.5)
    expect.state("get_up", "lying")
    expect.reason("get_up", "the robot fell")
    set_world { robot = { posture = help } }
    advance(0.1)
    expect.state("get_up", "idle")
    expect.reason("get_up", "the robot was helped up")
  end
end)

test("continues to get up until it stands, and waits again after a second fall", function()
  load_behavior "get_up"
  set_world { robot = { posture = "lying" } }
  advance(6)
  expect.state("get_up", "getting up")
  set_world { robot = { posture = "upright" } }
  advance(0.1)
  expect.reason("get_up", "the robot stands again or is lifted")
  set_world { robot = { posture = "lying" } }
  advance(0.5)
  expect.state("get_up", "lying")
  expect.get_up(false)
end)
