--- Tests of behaviors/penalty_marks.lua and lib/walk.lua.

-- SPDX-License-Identifier: MIT

local function stand_at(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

local DISTURBANCES = {
  lying = { { posture = "lying" }, { posture = "upright" } },
  lifted = { { posture = "lifted" }, { posture = "upright" } },
  penalized = { { penalized = true }, { penalized = false } },
}

test("walks straight to its own mark if it faces it", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(90))
  advance(0.1)
  expect.state("penalty_marks", "walking")
  expect.walk(0.2, 0, 0)
end)

test("turns on the spot when the mark is behind it", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(-90))
  advance(0.1)
  expect.walk(0, 0, 0.6)
end)

test("walks to the other mark after it was on one", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, 0.05, 0)
  advance(0.1)
  expect.state("penalty_marks", "on the mark")
  expect.walk(0, 0, 0)
  advance(1.1)
  expect.state("penalty_marks", "walking")
  expect.walk(0.2, 0, -2 * math.atan(0.05, 6.4))
end)

test("rotates before its first steps while it learns the room", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(90))
  set_world { training = { active = true }, confidence = { coverage = 0.1 } }
  advance(0.1)
  expect.state("penalty_marks", "turning round")
  expect.reason("penalty_marks", "the robot starts to learn the room")
  advance(2 * math.pi / 0.6)
  expect.state("penalty_marks", "walking")
  advance(3)
  expect.state("penalty_marks", "walking")   -- once is enough
end)

test("rotates once on a mark while it learns the room", function()
  load_behavior "penalty_marks"
  advance(0.1)
  stand_at(-3.2, 0, 0)
  set_world { training = { active = true }, confidence = { coverage = 0.3 } }
  advance(0.1)
  expect.state("penalty_marks", "turning round")
  expect.walk(0, 0, 0.6)
  advance(2 * math.pi / 0.6)
  expect.state("penalty_marks", "on the mark")
end)

test("rotates on the spot while the lines do not fit the pose, for a limited time", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(90))
  set_world { pose = { tracked = false } }
  advance(1.9)
  expect.state("penalty_marks", "walking")
  advance(0.2)
  expect.state("penalty_marks", "looking round")
  expect.walk(0, 0, 0.6)
  advance(3)
  set_world { pose = { tracked = true } }
  advance(0.1)
  expect.state("penalty_marks", "walking")
  expect.reason("penalty_marks", "the pose is known, or another behavior searches for it")
  set_world { pose = { tracked = false } }
  advance(2.1)
  expect.state("penalty_marks", "looking round")
  advance(30.0)
  expect.state("penalty_marks", "walking")
end)

test("walks to its own mark first after a disturbance", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, 0, 0)
  advance(1.2)
  expect.state("penalty_marks", "walking")   -- to the other mark
  for _, change in pairs(DISTURBANCES) do
    set_world { robot = change[1] }
    advance(1)
    expect.state("penalty_marks", "disturbed")
    expect.reason("penalty_marks", "the robot cannot walk now")
    expect.walk(0, 0, 0)
    set_world { robot = change[2] }
    stand_at(2, 0, 0)
    advance(0.4)
    expect.state("penalty_marks", "disturbed")
    advance(0.3)
    expect.state("penalty_marks", "walking")
    expect.reason("penalty_marks", "the robot stands again")
    expect.walk(0, 0, 0.6)   -- its own mark is behind it
  end
end)

test("walks to its own mark first even if it was lifted from the other mark", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, 0, 0)
  advance(1.2)
  stand_at(3.2, 0, 0)
  advance(0.1)
  expect.state("penalty_marks", "on the mark")
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  stand_at(2, 0, math.pi)
  advance(1)
  expect.walk(0.2, 0, 0)
end)

test("a disturbance ends the rotation", function()
  load_behavior "penalty_marks"
  set_world { training = { active = true }, confidence = { coverage = 0.3 } }
  stand_at(-3.2, 0, 0)
  advance(0.1)
  expect.state("penalty_marks", "turning round")
  set_world { robot = { posture = "lying" } }
  advance(0.1)
  expect.state("penalty_marks", "disturbed")
end)

test("waits while another behavior searches for the pose, even on a mark", function()
  load_behavior "kidnap_recovery"
  load_behavior "penalty_marks"
  stand_at(-3.2, 0, 0)
  set_world { confidence = { coverage = 0.9, distinctiveness = 0.3 } }
  set_world { robot = { posture = "lifted" }, pose = { cluster_weight = 0.9 } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(5)
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.state("penalty_marks", "waiting")
  expect.reason("penalty_marks", "another behavior searches for the pose")
  set_world { confidence = { evidence = -9, current = 0.9 } }
  advance(3.2)
  expect.state("kidnap_recovery", "recovered")
  expect.state("penalty_marks", "on the mark")   -- of its own half, and only now
end)

test("continues to the same mark after a goal search", function()
  load_behavior "goal_search"
  load_behavior "penalty_marks"
  set_world { confidence = { evidence = -9, coverage = 0.9, distinctiveness = 0.3 } }
  stand_at(-3.2, 0, 0)
  advance(1.2)
  expect.state("penalty_marks", "walking")   -- to the opponent's mark
  set_world { confidence = { evidence = 0 } }
  advance(11)
  expect.state("penalty_marks", "waiting")
  expect.walk(0, 0, 0)
  set_world { confidence = { evidence = -9 } }
  advance(1.2)
  expect.state("penalty_marks", "walking")
  expect.reason("penalty_marks", "the search has ended")
  expect.walk(0.2, 0, 0)
end)

test("a fall while it waits is a disturbance", function()
  load_behavior "kidnap_recovery"
  load_behavior "penalty_marks"
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(2)
  expect.state("penalty_marks", "waiting")
  set_world { robot = { posture = "lying" } }
  advance(1)
  expect.state("penalty_marks", "disturbed")
end)

test("an edit of the library takes effect without restarting the walk", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, 0, 0)
  advance(1.3)
  expect.state("penalty_marks", "walking")
  reload { file = "lib/walk.lua", from = "speed    = { 1.0,", to = "speed    = { 1.5," }
  advance(0.1)
  expect.walk(0.3, 0, 0)
end)

test("stands while the referee does not permit walking", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(90))
  set_world { robot = { may_walk = false } }
  advance(0.1)
  expect.state("penalty_marks", "held")
  expect.walk(0, 0, 0)
  set_world { robot = { may_walk = true } }
  advance(0.1)
  expect.state("penalty_marks", "walking")
  expect.reason("penalty_marks", "the game continues")
end)

test("stands if the body cannot walk", function()
  load_behavior "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(90))
  set_world { robot = { can_walk = false } }
  advance(0.1)
  expect.state("penalty_marks", "held")
  expect.walk(0, 0, 0)
end)
