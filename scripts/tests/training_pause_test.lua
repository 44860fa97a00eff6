--- Tests of behaviors/training_pause.lua and lib/posture.lua.

local function expect_pause()
  expect.lease("pause_training")
  expect.lease("pause_evaluation")
end

local function expect_no_pause()
  expect.no_lease("pause_training")
  expect.no_lease("pause_evaluation")
end

local function start()
  load_behavior "training_pause"
  advance(0.1)
end

test("allows both while the robot stands on the field", function()
  start()
  expect.state("training_pause", "allowing")
  expect_no_pause()
end)

local REASONS = {
  fallen = "the robot lies or gets up",
  carried = "the robot is carried",
  penalized = "the robot is penalized",
}

for what, reason in pairs(REASONS) do
  test("pauses both while the robot is " .. what .. ", and a moment longer", function()
    start()
    set_world { robot = { [what] = true } }
    advance(0.1)
    expect.state("training_pause", what)
    expect.reason("training_pause", reason)
    expect_pause()
    advance(10)
    expect_pause()
    set_world { robot = { [what] = false } }
    advance(0.4)
    expect.state("training_pause", "settling")
    expect.reason("training_pause", "the robot stands on the field again")
    expect_pause()
    advance(0.3)
    expect.state("training_pause", "allowing")
    expect.reason("training_pause", "the robot has stood for a moment")
    expect_no_pause()
  end)

  test("begins anew when the robot is " .. what .. " while it settles", function()
    start()
    set_world { robot = { carried = true } }
    advance(1)
    set_world { robot = { carried = false } }
    advance(0.2)
    expect.state("training_pause", "settling")
    set_world { robot = { [what] = true } }
    advance(0.1)
    expect.state("training_pause", what)
    expect_pause()
  end)
end

test("a fall goes on until the robot has got up, although its feet carry no load meanwhile", function()
  start()
  set_world { robot = { fallen = true } }
  advance(3)
  set_world { robot = { fallen = false } }
  advance(0.2)
  set_world { robot = { carried = true } }
  advance(2.5)
  expect.state("training_pause", "fallen")
  expect.reason("training_pause", "the robot lies or gets up")
  expect_pause()
  set_world { robot = { carried = false } }
  advance(1)
  expect.state("training_pause", "allowing")
end)

test("a robot that trips has unloaded feet first and then lies", function()
  start()
  set_world { robot = { carried = true } }
  advance(0.4)
  expect.state("training_pause", "carried")
  set_world { robot = { carried = false, fallen = true } }
  advance(0.1)
  expect.state("training_pause", "fallen")
  expect_pause()
end)

test("a robot that is carried off by the referee stays paused from one reason to the next", function()
  start()
  set_world { robot = { carried = true, penalized = true } }
  advance(1)
  expect.state("training_pause", "carried")
  set_world { robot = { carried = false } }
  advance(0.1)
  expect.state("training_pause", "penalized")
  expect_pause()
end)

test("the time to settle can be set", function()
  set_param("training_pause.settle", "2.0")
  start()
  set_world { robot = { carried = true } }
  advance(1)
  set_world { robot = { carried = false } }
  advance(1.9)
  expect_pause()
  advance(0.2)
  expect_no_pause()
end)

test("a reload in the middle keeps the pause", function()
  start()
  set_world { robot = { fallen = true } }
  advance(1)
  reload { from = "priority = 60", to = "priority = 61" }
  advance(0.1)
  expect.state("training_pause", "fallen")
  expect_pause()
end)
