--- Tests of behaviors/stand_up.lua.

test("gets up after a moment of rest", function()
  load_behavior "stand_up"
  advance(0.1)
  expect.get_up(false)
  set_world { robot = { fallen = true } }
  advance(0.5)
  expect.state("stand_up", "lying")
  expect.get_up(false)
  advance(1.0)
  expect.state("stand_up", "getting up")
  expect.get_up(true)
  set_world { robot = { fallen = false } }
  advance(0.1)
  expect.state("stand_up", "upright")
  expect.get_up(false)
end)

test("does not kick while somebody carries it", function()
  load_behavior "stand_up"
  set_world { robot = { fallen = true, carried = true } }
  advance(3)
  expect.state("stand_up", "upright")
  expect.get_up(false)
end)

test("rests again when it was helped up before it began", function()
  load_behavior "stand_up"
  for _, help in ipairs { { fallen = false }, { carried = true } } do
    set_world { robot = { fallen = true, carried = false } }
    advance(0.5)
    expect.state("stand_up", "lying")
    expect.reason("stand_up", "the robot fell")
    set_world { robot = help }
    advance(0.1)
    expect.state("stand_up", "upright")
    expect.reason("stand_up", "the robot was helped up")
  end
end)

test("goes on getting up until it stands, and takes a new rest after a second fall", function()
  load_behavior "stand_up"
  set_world { robot = { fallen = true } }
  advance(6)
  expect.state("stand_up", "getting up")
  set_world { robot = { fallen = false } }
  advance(0.1)
  expect.reason("stand_up", "the robot stands again")
  set_world { robot = { fallen = true } }
  advance(0.5)
  expect.state("stand_up", "lying")
  expect.get_up(false)
end)
