--- Tests of behaviors/wall_gaze.lua.

-- SPDX-License-Identifier: MIT

local function unconfirmed()
  load_behavior "wall_gaze"
  load_behavior "head_scan"
  set_world { confidence = { status = "usable", evidence = 1 }, views = { best_yaw = -0.7, best_score = 3 } }
  advance(0.1)
end

test("leaves the head to the scan while the orientation is confirmed", function()
  unconfirmed()
  for _, evidence in ipairs { -9, 9 } do
    set_world { confidence = { evidence = evidence } }
    advance(1)
    expect.state("wall_gaze", "resting")
    expect.head(1.1, -0.1)
  end
end)

test("leaves it to the scan if the room cannot distinguish the poses", function()
  unconfirmed()
  for _, status in ipairs { "off", "resting", "unlearned", "symmetric", "lost" } do
    set_world { confidence = { status = status } }
    advance(0.5)
    expect.state("wall_gaze", "resting")
  end
end)

test("leaves it to the scan if no view has information", function()
  unconfirmed()
  set_world { views = { best_score = 0 } }
  advance(0.5)
  expect.state("wall_gaze", "resting")
  expect.reason("wall_gaze", "the orientation is confirmed, or the room has no evidence")
end)

test("looks at the view with the most information, then at the next best view", function()
  unconfirmed()
  expect.state("wall_gaze", "looking")
  expect.reason("wall_gaze", "the orientation is unconfirmed")
  expect.head(-0.7, -0.1)
  set_world { views = { best_yaw = 0.5 } }
  advance(0.3)
  expect.head(-0.7, -0.1)   -- finishes the first view before the next
  set_world { robot = { head_yaw = -0.68 } }
  advance(0.3)
  expect.reason("wall_gaze", "the view was held long enough")
  expect.head(0.5, -0.1)
end)

test("looks at another view if the head cannot reach one", function()
  unconfirmed()
  set_world { views = { best_yaw = 0.5 } }
  advance(2.1)
  expect.reason("wall_gaze", "the head cannot reach the view")
  expect.head(0.5, -0.1)
end)

local function learning()
  load_behavior "wall_gaze"
  load_behavior "head_scan"
  set_world { confidence = { status = "resting" }, training = { active = true }, views = { unknown_yaw = 0.9, unknown_score = 8 } }
  advance(0.1)
end

test("looks where most is unknown while the room is learned", function()
  learning()
  expect.state("wall_gaze", "studying")
  expect.head(0.9, -0.1)
  set_world { robot = { head_yaw = 0.9 }, views = { unknown_yaw = -0.4 } }
  advance(0.3)
  expect.head(0.9, -0.1)   -- a tile counts as known only after a while
  advance(0.2)
  expect.reason("wall_gaze", "the view was learned")
  expect.head(-0.4, -0.1)
end)

test("leaves the head to the scan when the visible tiles are known and the view was held long enough", function()
  learning()
  set_world { views = { unknown_score = 1 } }
  advance(1)
  expect.state("wall_gaze", "studying")   -- otherwise it would alternate between two views
  set_world { robot = { head_yaw = 0.9 } }
  advance(0.5)
  expect.state("wall_gaze", "resting")
  expect.reason("wall_gaze", "the visible tiles are known")
  expect.head(1.1, -0.1)
end)

test("leaves the head to the scan at once when the training has ended", function()
  learning()
  set_world { training = { active = false } }
  advance(0.1)
  expect.state("wall_gaze", "resting")
  expect.head(1.1, -0.1)
end)
