--- Tests of behaviors/kidnap_recovery.lua.

-- SPDX-License-Identifier: MIT

local function put_down()
  load_behavior "kidnap_recovery"
  set_world { confidence = { coverage = 0.9, distinctiveness = 0.3 } }
  advance(0.1)
  set_world { robot = { posture = "lifted" }, pose = { cluster_weight = 0.9 } }
  advance(1)
  expect.state("kidnap_recovery", "lifted")
  expect.reason("kidnap_recovery", "the robot is lifted")
  expect.lease("pause_training")
  set_world { robot = { posture = "upright" } }
  advance(0.4)
end

test("does nothing while the robot is not lifted", function()
  load_behavior "kidnap_recovery"
  advance(60)
  expect.state("kidnap_recovery", "undisturbed")
  expect.no_lease("pause_training")
  expect.no_command()
end)

test("does not count a hand that only steadies the robot as a lift", function()
  load_behavior "kidnap_recovery"
  set_world { robot = { posture = "lifted" } }
  advance(0.4)
  set_world { robot = { posture = "upright" } }
  advance(2)
  expect.state("kidnap_recovery", "undisturbed")
end)

test("does not count a fall or getting up as a lift", function()
  load_behavior "kidnap_recovery"
  for _, posture in ipairs { "falling", "lying", "getting_up", "upright" } do
    set_world { robot = { posture = posture } }
    advance(3)
    expect.state("kidnap_recovery", "undisturbed")
  end
end)

test("a placed robot turns on the spot without training", function()
  put_down()
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.reason("kidnap_recovery", "the robot stands at an unknown position")
  expect.walk(0, 0, 0.4)
  expect.lease("pause_training")
  expect.no_lease("pause_evaluation")
  expect.no_command()
end)

test("a penalized robot starts to search when it may play again", function()
  load_behavior "kidnap_recovery"
  set_world { robot = { posture = "lifted", penalized = true } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(45)
  expect.state("kidnap_recovery", "lifted")
  expect.lease("pause_training")
  set_world { robot = { penalized = false } }
  advance(0.4)
  expect.state("kidnap_recovery", "searching/with its belief")
end)

test("recovers when the room supports the believed pose long enough", function()
  put_down()
  set_world { confidence = { evidence = -8, current = 0.8 } }
  advance(2.9)
  expect.state("kidnap_recovery", "searching/with its belief")
  advance(0.2)
  expect.state("kidnap_recovery", "recovered")
  expect.reason("kidnap_recovery", "the room supports the believed pose")
  expect.log("s after it was placed")
  expect.no_lease("pause_training")
  expect.no_command()
end)

test("does not count the time for which the confidences are fresh", function()
  put_down()
  set_world { confidence = { evidence = -9, current = 0.9, status = "fresh" } }
  advance(10)
  expect.state("kidnap_recovery", "searching/with its belief")
  set_world { confidence = { status = "usable" } }
  advance(2.9)
  expect.state("kidnap_recovery", "searching/with its belief")
  advance(0.2)
  expect.state("kidnap_recovery", "recovered")
end)

test("does not recover with a pose on which the pose particles do not agree", function()
  put_down()
  set_world { confidence = { evidence = -9, current = 0.9 }, pose = { cluster_weight = 0.4 } }
  advance(15)
  expect.state("kidnap_recovery", "searching/with its belief")
end)

test("resets the orientation once when neither pose wins, and searches again", function()
  put_down()
  advance(24)
  expect.no_command()
  advance(1.5)
  expect.state("kidnap_recovery", "searching/with any orientation")
  expect.reason("kidnap_recovery", "neither pose won")
  expect.command("reset_orientation", "granted")
  expect.walk(0, 0, 0.4)
  advance(20)
  expect.no_command()
  expect.lease("pause_training")
  set_world { confidence = { evidence = -9, current = 0.9 } }
  advance(3.1)
  expect.state("kidnap_recovery", "recovered")
end)

test("does not reset while the room supports the mirrored pose, because orientation will flip it", function()
  put_down()
  set_world { confidence = { evidence = 9 } }
  advance(60)
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.no_command()
end)

test("does not reset while a goal is in view, because it may help", function()
  put_down()
  for _ = 1, 20 do
    set_world { seen = { goal_posts = 1 } }
    advance(0.5)
    set_world { seen = { goal_posts = 0 } }
    advance(2)
  end
  expect.state("kidnap_recovery", "searching/with its belief")
  expect.no_command()
  advance(3)
  expect.state("kidnap_recovery", "searching/with any orientation")
end)

test("gives up in the end, still without training, and can recover later", function()
  put_down()
  advance(50.2)
  expect.state("kidnap_recovery", "lost")
  expect.reason("kidnap_recovery", "neither pose won again")
  expect.log("still unconfirmed")
  expect.lease("pause_training")
  advance(30)
  expect.no_command()
  set_world { confidence = { evidence = -9, current = 0.9 } }
  advance(3.1)
  expect.state("kidnap_recovery", "recovered")
  expect.reason("kidnap_recovery", "the room supports the believed pose")
  expect.no_lease("pause_training")
end)

for what, interrupted in pairs {
  ["a fall"] = { robot = { posture = "lying" } },
  ["a penalty"] = { robot = { penalized = true }, evaluation = { active = false } },   -- background_training pauses it
} do
  test(what .. " does not end the search: it restarts afterward", function()
    put_down()
    advance(20)
    set_world(interrupted)
    set_world { confidence = { evidence = -9, current = 0.9 } }
    advance(45)
    expect.state("kidnap_recovery", "interrupted")
    expect.lease("pause_training")
    set_world {
      robot = { posture = "upright", penalized = false }, confidence = { evidence = 0 }, evaluation = { active = true },
    }
    advance(20)
    expect.state("kidnap_recovery", "searching/with its belief")
    expect.reason("kidnap_recovery", "the robot can search again")
    expect.walk(0, 0, 0.4)
    expect.lease("pause_training")
    expect.no_command()
  end)
end

test("gives up in the end if the room supports the pose, but its position never fits", function()
  put_down()
  set_world { confidence = { evidence = -9, current = 0.35 } }   -- below the parameter share
  advance(88)
  expect.state("kidnap_recovery", "searching/with its belief")
  advance(3)
  expect.state("kidnap_recovery", "lost")
  expect.no_command()
end)

test("a robot that may not walk yet neither searches nor resets, and may recover", function()
  put_down()
  set_world { game = { state = "set" }, robot = { may_walk = false }, confidence = { evidence = -3 } }
  advance(60)
  expect.state("kidnap_recovery", "interrupted")
  expect.no_command()
  set_world { confidence = { evidence = -9, current = 0.9 } }
  advance(3.5)
  expect.state("kidnap_recovery", "recovered")
end)

test("restarts with each lift", function()
  put_down()
  set_world { confidence = { evidence = -9, current = 0.9 } }
  advance(7)
  expect.state("kidnap_recovery", "recovered")
  set_world { robot = { posture = "lifted" } }
  advance(1)
  expect.state("kidnap_recovery", "lifted")
  set_world { robot = { posture = "upright" } }
  advance(1)
  expect.state("kidnap_recovery", "searching/with its belief")
end)

test("leaves the flip to orientation and stands before walking", function()
  load_behavior "orientation"
  load_behavior "penalty_marks"
  set_world { confidence = { coverage = 0.9, distinctiveness = 0.3 } }
  put_down()
  set_world { confidence = { evidence = 9 } }
  advance(4)
  expect.command("flip_pose", "granted")
  expect.walk(0, 0, 0.4)
  set_world { confidence = { evidence = -9, current = 0.9 } }
  advance(5)
  expect.state("kidnap_recovery", "recovered")
  expect.walk(0.2, 0, 0)   -- penalty_marks walks to its mark, which is straight ahead of the flipped pose
end)

test("leaves the legs to goal_search while goal_search looks at a goal", function()
  load_behavior "goal_search"
  put_down()
  advance(3.5)
  expect.state("goal_search", "put down")
  expect.walk(0, 0, 0.4)
  advance(1.2)
  expect.state("goal_search", "searching/opponent goal")
  expect.walk(0, 0, 0)
end)

for what, world in pairs {
  ["is not known"] = { confidence = { coverage = 0.1 } },
  ["looks the same after a rotation by 180 degrees"] = { confidence = { paired = 0.5, distinctiveness = 0.01 } },
} do
  test("does not reset if the room " .. what .. ", and gives up in the end", function()
    put_down()
    set_world(world)
    advance(24)
    expect.state("kidnap_recovery", "searching/with its belief")
    advance(1)
    expect.state("kidnap_recovery", "lost")
    expect.reason("kidnap_recovery", "the room cannot distinguish the poses")
    advance(60)
    expect.no_command()
    expect.lease("pause_training")
  end)
end

test("an edit while it searches changes neither the pause nor the time", function()
  put_down()
  advance(20)
  reload { from = "priority = 25", to = "priority = 26" }
  expect.lease("pause_training")
  advance(5.2)
  expect.command("reset_orientation", "granted")
end)

test("does not recover with a correct direction while the position does not fit", function()
  put_down()
  set_world { confidence = { evidence = -9, current = 0.9 }, pose = { recovery_probability = 0.5 } }
  advance(20)
  expect.state("kidnap_recovery", "searching/with its belief")
  set_world { pose = { recovery_probability = 0.0 } }
  advance(3.2)
  expect.state("kidnap_recovery", "recovered")
end)
