--- Tests of behaviors/background_training.lua.

-- SPDX-License-Identifier: MIT

local function start()
  load_behavior "background_training"
  set_world { pose = { known = true } }
  advance(0.1)
end

local DISTURBANCES = {
  lying = { { posture = "lying" }, { posture = "upright" }, "the robot falls, lies or gets up" },
  lifted = { { posture = "lifted" }, { posture = "upright" }, "the robot is lifted" },
  penalized = { { penalized = true }, { penalized = false }, "the robot is penalized" },
}

local function expect_pause()
  expect.lease("pause_training")
  expect.lease("pause_evaluation")
end

local function lift_and_put_down()
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" } }
end

local function learned()
  start()
  set_world { training = { seconds = 30 }, confidence = { coverage = 0.9, paired = 0.5, distinctiveness = 0.3 } }
  advance(0.1)
end

test("with a known pose and no model it trains first and does not evaluate", function()
  start()
  expect.state("background_training", "learning/studying")
  expect.lease("pause_evaluation")
  expect.no_lease("pause_training")
end)

test("without a known pose it neither trains nor evaluates", function()
  load_behavior "background_training"
  advance(1)
  expect.state("background_training", "waiting")
  expect.lease("pause_training")
  expect.lease("pause_evaluation")
end)

test("it does not learn while what it sees no longer fits its pose", function()
  start()
  for _, mirrored_weight in ipairs { 0.0, 0.2 } do   -- also while it purges
    set_world { pose = { tracked = true, reflected_weight = mirrored_weight } }
    advance(0.1)
    expect.no_lease("pause_training")
    set_world { pose = { tracked = false } }
    advance(0.1)
    expect.state("background_training", "learning/doubting")
    expect.lease("pause_training")
    expect.lease("pause_evaluation")
  end
  set_world { pose = { tracked = true, reflected_weight = 0.0 } }
  advance(0.1)
  expect.state("background_training", "learning/studying")
  expect.no_lease("pause_training")
end)

test("it learns where it has never seen a line", function()
  set_world { pose = { tracked = false } }
  start()
  advance(1)
  expect.state("background_training", "learning/studying")
  expect.no_lease("pause_training")
end)

test("it continues to learn until enough of the wall is known on both sides", function()
  start()
  set_world { training = { seconds = 25 }, confidence = { coverage = 0.5, paired = 0.1 } }
  advance(1)
  expect.state("background_training", "learning/studying")
end)

test("it continues to learn a room that hardly differs from itself rotated by 180 degrees", function()
  start()
  set_world { training = { seconds = 12 }, confidence = { paired = 0.5, separability = 0.6 } }
  advance(1)
  expect.state("background_training", "learning/studying")
  set_world { confidence = { separability = 0.8 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
end)

test("less of the wall is enough after a while, since a still body cannot see more", function()
  start()
  set_world { training = { seconds = 13.8 }, confidence = { coverage = 0.6, paired = 0.3 } }
  advance(0.1)
  expect.state("background_training", "learning/studying")
  set_world { training = { seconds = 14.2 }, confidence = { separability = 0.6 } }
  advance(0.1)
  expect.state("background_training", "learning/studying")
  set_world { confidence = { separability = 1.0 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
end)

test("it trusts the model after a while, however much of the wall is known", function()
  start()
  set_world { training = { seconds = 36 }, confidence = { coverage = 0.5, paired = 0.1 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
end)

test("a room whose model was discarded is learned again", function()
  learned()
  expect.state("background_training", "trusting/watching")
  set_world { training = { seconds = 0 }, confidence = { paired = 0 } }
  advance(0.1)
  expect.state("background_training", "learning/studying")
  expect.lease("pause_evaluation")
end)

test("while it learns with a set initial pose, it purges mirrored beliefs", function()
  start()
  set_world { training = { seconds = 5 }, pose = { reflected_weight = 0.02 } }
  advance(1)
  expect.no_command()
  set_world { pose = { reflected_weight = 0.2 } }
  advance(0.1)
  expect.command("purge_reflection", "granted")
  expect.state("background_training", "learning/purging")
  expect.lease("pause_evaluation")
  set_world { pose = { reflected_weight = 0.0 } }
  advance(4)
  expect.state("background_training", "learning/studying")
end)

test("a learned room is evaluated and no longer trained", function()
  learned()
  expect.state("background_training", "trusting/watching")
  expect.reason("background_training", "enough of the room was learned")
  expect.lease("pause_training")
  expect.no_lease("pause_evaluation")
end)

test("it continues to train if a distinguishable room starts to seem symmetric without a disturbance", function()
  learned()
  set_world { confidence = { evidence = -7 } }
  advance(1.2)
  expect.state("background_training", "trusting/refining")
  set_world { confidence = { status = "symmetric" } }
  advance(1)
  expect.no_lease("pause_training")
  set_world { confidence = { evidence = -3 } }
  advance(0.1)
  expect.lease("pause_training")
  set_world { confidence = { evidence = -7 } }
  advance(2)
  expect.lease("pause_training")   -- now the room must become distinguishable first
end)

test("it trains further only while the believed pose clearly wins", function()
  learned()
  set_world { confidence = { evidence = -7 } }
  advance(0.9)
  expect.lease("pause_training")
  advance(0.3)
  expect.state("background_training", "trusting/refining")
  expect.no_lease("pause_training")
  set_world { confidence = { evidence = -3 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
end)

for what, change in pairs(DISTURBANCES) do
  test("it stops refining while the robot is " .. what .. ", and neither trains nor evaluates", function()
    learned()
    set_world { confidence = { evidence = -9 } }
    advance(2)
    expect.state("background_training", "trusting/refining")
    set_world { robot = change[1] }
    advance(0.1)
    expect.state("background_training", "disturbed")
    expect.reason("background_training", change[3])
    expect_pause()
    advance(20)
    expect_pause()
  end)

  test("it stops learning while the robot is " .. what, function()
    start()
    advance(0.5)
    expect.state("background_training", "learning/studying")
    set_world { robot = change[1] }
    advance(0.1)
    expect.state("background_training", "disturbed")
    expect_pause()
    set_world { robot = change[2] }
    advance(0.4)
    expect.state("background_training", "disturbed")
    expect_pause()
    advance(0.3)   -- after a lift its pose is not reliable
    expect.state("background_training", what == "lifted" and "waiting" or "learning/studying")
  end)

  test("both rest while the robot is " .. what .. ", and a moment longer", function()
    learned()
    set_world { confidence = { evidence = -9 }, robot = change[1] }
    advance(1)
    expect_pause()
    set_world { robot = change[2] }
    advance(0.4)
    expect_pause()
    advance(0.3)
    expect.state("background_training", "trusting/watching")
    expect.lease("pause_training")
    expect.no_lease("pause_evaluation")
    advance(3)
    expect.no_lease("pause_training")
  end)

  test("a known room that seems symmetric now is still known after the robot was " .. what, function()
    learned()
    set_world { training = { seconds = 12 }, confidence = { separability = 0.5 }, robot = change[1] }
    advance(1)
    set_world { robot = change[2] }
    advance(1)
    expect.state("background_training", "trusting/watching")
    expect.no_lease("pause_evaluation")
  end)

  test("a room whose model was discarded while the robot was " .. what .. " is not known", function()
    learned()
    set_world { training = { seconds = 0 }, confidence = { paired = 0 }, robot = change[1] }
    advance(1)
    set_world { robot = change[2] }
    advance(1)
    expect.state("background_training", what == "lifted" and "waiting" or "learning/studying")
    set_world { training = { seconds = 9 }, confidence = { paired = 0.5, separability = 0.5 } }
    advance(1)
    expect.state("background_training", what == "lifted" and "waiting" or "learning/studying")
  end)

  test("the time restarts when the robot is " .. what .. " again", function()
    learned()
    lift_and_put_down()
    advance(0.3)
    set_world { robot = change[1] }
    advance(0.1)
    set_world { robot = change[2] }
    advance(0.4)
    expect.state("background_training", "disturbed")
    expect_pause()
  end)
end

test("a fall lasts until the robot stands again", function()
  learned()
  for _, posture in ipairs { "falling", "lying", "getting_up" } do
    set_world { robot = { posture = posture } }
    advance(3)
    expect.state("background_training", "disturbed")
    expect_pause()
  end
  set_world { robot = { posture = "upright" } }
  advance(1)
  expect.state("background_training", "trusting/watching")
end)

test("a robot that is penalized and lifted stays paused during both", function()
  learned()
  set_world { robot = { posture = "lifted", penalized = true } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(10)
  expect.state("background_training", "disturbed")
  expect_pause()
end)

test("the time for which the robot must stand can be set", function()
  set_param("background_training.undisturbed_time", "2.0")
  learned()
  lift_and_put_down()
  advance(1.9)
  expect_pause()
  advance(0.2)
  expect.no_lease("pause_evaluation")
end)

test("a reload while the robot is disturbed keeps the pause", function()
  learned()
  set_world { robot = { posture = "lying" } }
  advance(1)
  reload { from = "priority = 40", to = "priority = 41" }
  advance(0.1)
  expect.state("background_training", "disturbed")
  expect_pause()
end)

test("a room that is known already is trusted at once", function()
  load_behavior "background_training"
  set_world { training = { seconds = 30 }, confidence = { coverage = 0.9, paired = 0.5 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
  expect.reason("background_training", "the room is known")
end)

test("a room that is learned enough during the pause after a purge is trusted", function()
  start()
  set_world { training = { seconds = 5 }, pose = { reflected_weight = 0.2 } }
  advance(0.1)
  expect.state("background_training", "learning/purging")
  set_world { training = { seconds = 36 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
end)

test("after it was placed it does not train while the confidences are not usable yet", function()
  learned()
  lift_and_put_down()
  set_world { confidence = { evidence = -9, status = "fresh" } }
  advance(9)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
  set_world { confidence = { status = "usable" } }
  advance(0.9)
  expect.lease("pause_training")
  advance(0.2)
  expect.state("background_training", "trusting/refining")
end)

test("a robot that was lifted before it had learned the room does not learn from an unreliable pose", function()
  start()
  set_world { training = { seconds = 5 } }
  lift_and_put_down()
  advance(5)
  expect.state("background_training", "waiting")
  expect.lease("pause_training")
end)

test("a robot that was lifted while it learned uses what it has learned", function()
  start()
  set_world { training = { seconds = 11 }, confidence = { paired = 0.3, separability = 0.5 } }
  advance(0.1)
  expect.state("background_training", "learning/studying")
  lift_and_put_down()
  advance(1)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
  expect.no_lease("pause_evaluation")
end)

test("a robot that was lifted before any training does not purge, because its pose is not reliable", function()
  start()
  advance(1)
  lift_and_put_down()
  set_world { pose = { reflected_weight = 0.5 } }
  advance(5)
  expect.state("background_training", "waiting")
  expect.no_command()
end)

test("a robot whose initial pose was set while it was lifted learns as soon as it stands", function()
  load_behavior "background_training"
  set_world { robot = { posture = "lifted" }, pose = { known = true } }
  advance(2)
  expect.state("background_training", "disturbed")
  set_world { robot = { posture = "upright" } }
  advance(1)
  expect.state("background_training", "learning/studying")
end)

test("a reload does not end the leases", function()
  learned()
  reload { from = "doc = \"time for which the log-odds must reach proof\"", to = "doc = \"how long it must last\"" }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
  expect.no_lease("pause_evaluation")
end)
