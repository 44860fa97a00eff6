--- Tests of behaviors/penalty_marks.lua and lib/walk.lua.

local function stand_at(x, y, rotation) set { pose = { x = x, y = y, rotation = rotation } } end

test("walks straight to its own mark when it looks there", function()
  load "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(90))
  advance(0.1)
  expect.state("penalty_marks", "walking")
  expect.walk(0.2, 0, 0)
end)

test("turns on the spot when the mark is behind it", function()
  load "penalty_marks"
  stand_at(-3.2, -3.5, math.rad(-90))
  advance(0.1)
  expect.walk(0, 0, 0.6)
end)

test("goes to the other mark after it was on one", function()
  load "penalty_marks"
  stand_at(-3.2, 0.05, 0)
  advance(0.1)
  expect.state("penalty_marks", "on the mark")
  expect.walk(0, 0, 0)
  advance(1.1)
  expect.state("penalty_marks", "walking")
  expect.walk(0.2, 0, -2 * math.atan(0.05, 6.4))
end)

test("turns round once on a mark while it learns the room", function()
  load "penalty_marks"
  set { training = { active = true }, confidence = { coverage = 0.3 } }
  stand_at(-3.2, 0, 0)
  advance(0.1)
  expect.state("penalty_marks", "turning round")
  expect.walk(0, 0, 0.6)
  advance(2 * math.pi / 0.6)
  expect.state("penalty_marks", "on the mark")
end)

test("stands and looks about after it was put down, until it is sure", function()
  load "penalty_marks"
  stand_at(2, 0, 0)
  set { robot = { carried = true } }
  advance(1)
  expect.state("penalty_marks", "helpless")
  set { robot = { carried = false } }
  advance(5)
  expect.state("penalty_marks", "looking about")
  expect.walk(0, 0, 0)
  set { confidence = { current = 0.9 } }
  advance(2.2)
  expect.state("penalty_marks", "walking")
  expect.reason("penalty_marks", "the robot is sure of its pose")
  expect.walk(0, 0, 0.6)
end)

test("goes to its own mark in the end even when it never becomes sure", function()
  load "penalty_marks"
  set { robot = { carried = true } }
  advance(1)
  set { robot = { carried = false } }
  advance(26)
  expect.state("penalty_marks", "walking")
  expect.reason("penalty_marks", "its patience ended")
end)

test("an edit of the library counts without losing the way", function()
  load "penalty_marks"
  stand_at(-3.2, 0, 0)
  advance(1.3)
  expect.state("penalty_marks", "walking")
  reload { file = "lib/walk.lua", from = "speed    = { 0.2,", to = "speed    = { 0.3," }
  advance(0.1)
  expect.walk(0.3, 0, 0)
end)
