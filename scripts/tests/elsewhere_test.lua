--- Tests of scenarios/elsewhere.lua.

-- SPDX-License-Identifier: MIT

test("learns at each place with each heading, then continues elsewhere", function()
  set_param("elsewhere.places", "2")
  set_param("elsewhere.headings", "2")
  set_param("elsewhere.learn", "20")
  set_world { truth = { x = 1, y = 0.5, rotation = 0.3 } }
  load_scenario "elsewhere"
  advance(0.1)
  expect.action("put_down")
  expect.action("set_initial_pose")
  advance(3.0)
  expect.state("elsewhere", "learning")
  advance(2.1)
  expect.state("elsewhere", "turning")
  advance(5.1)
  expect.state("elsewhere", "placing")
  advance(5.1)
  expect.state("elsewhere", "turning")
  advance(5.1)
  expect.state("elsewhere", "carrying")
  advance(1.5)
  expect.state("elsewhere", "standing")
  advance(1.0)
  expect.state("elsewhere", "told")
end)

local function told(which)
  set_param("elsewhere.headings", "1")
  set_param("elsewhere.learn", "5")
  set_param("elsewhere.told", which)
  load_scenario "elsewhere"
  advance(5.5)
  expect.state("elsewhere", "carrying")
  set_world { truth = { x = 1, y = 0.5, rotation = 0.3 } }
  advance(2.7)
  expect.state("elsewhere", "told")
  expect.action("set_initial_pose")
end

test("succeeds when the true pose was set and the belief stays right", function()
  told("truth")
  set_world { pose = { x = 1, y = 0.5, rotation = 0.3 } }
  advance(10.1)
  expect.verdict(true, "0.00 m and 0 degrees off")
end)

test("fails when the mirrored pose was set and the belief stays mirrored", function()
  told("reflection")
  set_world { pose = { x = -1, y = -0.5, rotation = 0.3 + math.pi } }
  advance(10.1)
  expect.verdict(false, "2.24 m and 180 degrees off")
end)
