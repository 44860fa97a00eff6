--- Tests of behaviors/goal_search.lua and lib/gaze.lua.

-- SPDX-License-Identifier: MIT

local FRESH = 0.4   -- s, more than the confidences are fresh after a disturbance (room_status.age)

local function stand_at(x, y, rotation) set_world { pose = { x = x, y = y, rotation = rotation } } end

--- Stands where the opponent goal is 45 degrees to the left and the own goal 45 degrees to the right.
local function stand_between_the_goals() stand_at(0.0, -4.5, math.rad(90)) end

local function look_at(yaw)
  set_world { robot = { head_yaw = yaw } }
  advance(1.2)
end

local function start()
  load_behavior "goal_search"
  stand_between_the_goals()
  set_world { confidence = { evidence = -9, coverage = 0.9, distinctiveness = 0.3 }, seen = { goal_posts = 2 } }
  advance(0.1)
end

--- Up to the first frames of a search.
local function put_down()
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" }, confidence = { evidence = 0 } }
  advance(4.2 + FRESH)
end

local DISTURBANCES = {
  lying = { { posture = "lying" }, { posture = "upright" } },
  lifted = { { posture = "lifted" }, { posture = "upright" } },
  penalized = { { penalized = true }, { penalized = false } },
}

test("does not request head or legs while the room supports one pose", function()
  start()
  advance(60)
  expect.state("goal_search", "resting")
  set_world { confidence = { evidence = 9 } }
  advance(60)
  expect.state("goal_search", "resting")
end)

test("searches when the room supports neither pose for a while", function()
  start()
  set_world { confidence = { evidence = -2 } }
  advance(9.5)
  expect.state("goal_search", "resting")
  advance(0.6)
  expect.state("goal_search", "searching/opponent goal")
end)

test("reports as its reason that the room supports neither pose", function()
  start()
  set_world { confidence = { evidence = -2 } }
  advance(10.03)
  expect.state("goal_search", "searching/choosing")
  expect.reason("goal_search", "the room supports neither pose")
  expect.walk(0, 0, 0)
end)

test("does not search in a room that is not known", function()
  start()
  set_world { confidence = { evidence = 0, coverage = 0.1 } }
  advance(60)
  expect.state("goal_search", "resting")
end)

test("does not search in a room that looks the same after a rotation by 180 degrees", function()
  start()
  set_world { confidence = { evidence = 0, paired = 0.5, distinctiveness = 0.01 } }
  advance(60)
  expect.state("goal_search", "resting")
end)

for what, change in pairs(DISTURBANCES) do
  test("waits for fresh confidences after the robot was " .. what .. ", then searches if the room supports neither pose", function()
    start()
    set_world { robot = change[1] }
    advance(1)
    expect.state("goal_search", "disturbed")
    expect.reason("goal_search", "the robot is not upright on the field, or is penalized")
    set_world { robot = change[2], confidence = { evidence = -1 } }
    advance(4.2)
    expect.state("goal_search", "put down")
    expect.reason("goal_search", "the robot may stand elsewhere than before")
    advance(FRESH)
    expect.state("goal_search", "searching/opponent goal")
  end)
end

test("rests after a disturbance when the room supports one pose", function()
  start()
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(4.2 + FRESH)
  expect.state("goal_search", "resting")
  expect.reason("goal_search", "the room supports one pose, or cannot distinguish them")
end)

test("rests after a disturbance when the room is not known", function()
  start()
  set_world { robot = { posture = "lifted" }, confidence = { evidence = 0, coverage = 0.1 } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(4.2 + FRESH)
  expect.state("goal_search", "resting")
end)

test("another disturbance before the confidences are valid restarts the waiting time", function()
  start()
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" }, confidence = { evidence = 0 } }
  advance(4)
  set_world { robot = { posture = "lying" } }
  advance(1)
  expect.state("goal_search", "disturbed")
  set_world { robot = { posture = "upright" } }
  advance(4)
  expect.state("goal_search", "put down")
end)

test("starts with the goal that is nearer to the view", function()
  start()
  set_world { robot = { head_yaw = 0.5 } }
  put_down()
  expect.state("goal_search", "searching/own goal")
  expect.reason("goal_search", "the own goal is nearer to the view")
  expect.head(math.rad(45), 0.0)
  expect.walk(0, 0, 0)
end)

test("looks at both goals in turn and dwells on each", function()
  start()
  put_down()
  expect.state("goal_search", "searching/opponent goal")
  expect.reason("goal_search", "the opponent goal is nearer to the view")
  expect.head(-math.rad(45), 0.0)
  set_world { robot = { head_yaw = -math.rad(45) } }
  advance(0.9)
  expect.state("goal_search", "searching/opponent goal")
  advance(0.2)
  expect.state("goal_search", "searching/own goal")
  expect.reason("goal_search", "the goal was in view long enough")
  expect.head(math.rad(45), 0.0)
  look_at(math.rad(45))
  expect.state("goal_search", "searching/opponent goal")
end)

test("turns the body toward a goal that the neck does not reach, in the shorter direction", function()
  start()
  stand_at(0, 0, math.rad(20))   -- the own goal is 160 degrees to the left, the opponent goal 20 to the right
  set_world { robot = { head_yaw = math.rad(-20) } }
  put_down()
  advance(1.2)
  expect.state("goal_search", "searching/own goal")
  expect.head(1.4, 0.0)
  expect.walk(0, 0, 0.5)
  stand_at(0, 0, math.rad(-20))
  advance(0.1)
  expect.head(-1.4, 0.0)
  expect.walk(0, 0, -0.5)
end)

test("stands while the neck reaches the goal", function()
  start()
  put_down()
  expect.walk(0, 0, 0)
end)

test("continues with the other goal if the head cannot reach one", function()
  start()
  put_down()
  set_world { robot = { head_yaw = 0.3 }, confidence = { evidence = 0 } }
  advance(8.2)
  expect.state("goal_search", "searching/own goal")
  expect.reason("goal_search", "the head cannot reach the goal")
end)

for _, case in ipairs { { "believed", -9 }, { "reflected", 9 } } do
  test("ends when the " .. case[1] .. " pose wins for a while", function()
    start()
    put_down()
    set_world { confidence = { evidence = case[2] } }
    advance(0.8)
    expect.state("goal_search", "searching/opponent goal")
    advance(0.3)
    expect.state("goal_search", "resting")
    expect.reason("goal_search", "the room supports one pose")
  end)
end

test("ends when it takes too long, and starts again later", function()
  start()
  put_down()
  set_world { confidence = { evidence = 0 } }
  look_at(-math.rad(45))
  advance(19)
  expect.state("goal_search", "resting")
  expect.reason("goal_search", "the search took too long")
  advance(10.1)
  expect.state("goal_search", "searching/opponent goal")
end)

test("ends when no goal is at either believed position, because the belief is wrong", function()
  start()
  put_down()
  set_world { confidence = { evidence = 0 }, seen = { goal_posts = 0 } }
  look_at(-math.rad(45))
  expect.state("goal_search", "searching/own goal")
  look_at(math.rad(45))
  expect.state("goal_search", "resting")
  expect.reason("goal_search", "no goal is at the believed position")
  advance(5)
  expect.state("goal_search", "resting")
end)

test("does not count goals as missing that the head cannot reach", function()
  start()
  put_down()
  look_at(0.0)   -- between the goals; the neck does not reach them, and the body does not turn
  advance(18)
  expect.state("goal_search", "searching/opponent goal")
  advance(4)
  expect.state("goal_search", "resting")
  expect.reason("goal_search", "the search took too long")
end)

test("does not count a goal in another direction as the expected goal", function()
  start()
  put_down()
  set_world { confidence = { evidence = 0 } }
  for _ = 1, 2 do
    set_world { robot = { head_yaw = 0.0 }, seen = { goal_posts = 2 } }
    advance(0.5)
    set_world { robot = { head_yaw = -math.rad(45) }, seen = { goal_posts = 0 } }
    advance(1.2)
    set_world { robot = { head_yaw = math.rad(45) } }
    advance(1.2)
  end
  expect.reason("goal_search", "no goal is at the believed position")
end)

test("a fall ends the search", function()
  start()
  put_down()
  set_world { robot = { posture = "lying" } }
  advance(0.1)
  expect.state("goal_search", "disturbed")
end)

test("overrides head_scan only while it searches", function()
  load_behavior "head_scan"
  start()
  expect.head(1.1, -0.1)
  put_down()
  expect.head(-math.rad(45), 0.0)
end)

test("leaves the legs to get_up", function()
  load_behavior "get_up"
  start()
  put_down()
  stand_at(0, 0, 0)
  set_world { robot = { posture = "lying" } }
  advance(1.5)
  expect.walk(0, 0, 0)
  expect.get_up(true)
end)
