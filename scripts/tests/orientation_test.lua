--- Tests of behaviors/orientation.lua.

-- SPDX-License-Identifier: MIT

local function learned_room()
  load_behavior "orientation"
  set_world { confidence = { coverage = 0.9, distinctiveness = 0.3 } }
  advance(0.1)
end

test("watches first", function()
  learned_room()
  expect.state("orientation", "watching/unconfirmed")
  expect.no_command()
end)

test("flips once when the mirrored pose wins", function()
  learned_room()
  set_world { confidence = { evidence = 8.5 } }
  advance(0.15)
  expect.no_command()
  advance(0.1)
  expect.state("orientation", "correcting")
  expect.reason("orientation", "the mirrored pose won")
  expect.command("flip_pose", "granted")
  advance(2.0)
  expect.no_command()
end)

test("does not flip on evidence that does not last", function()
  learned_room()
  for _ = 1, 10 do
    set_world { confidence = { evidence = 9 } }
    advance(0.15)
    set_world { confidence = { evidence = 1 } }
    advance(0.1)
  end
  expect.state("orientation", "watching/unconfirmed")
  expect.no_command()
end)

test("does not flip while the evidence decreases", function()
  learned_room()
  set_world { confidence = { age = 0.3, evidence = 12 } }
  advance(0.1)
  set_world { confidence = { age = 0.4, evidence = 11 } }
  advance(0.5)
  expect.no_command()
  set_world { confidence = { age = 0.9, evidence = 11.8 } }
  advance(0.3)
  expect.command("flip_pose", "granted")
end)

test("evidence from before a reset does not count", function()
  learned_room()
  set_world { confidence = { age = 0.5, evidence = 12 }, robot = { posture = "lying" } }
  advance(0.1)
  set_world { robot = { posture = "upright" } }
  advance(0.1)
  expect.state("orientation", "resetting")
  set_world { confidence = { age = 0.6, evidence = 10 } }
  advance(2.9)
  expect.no_command("flip_pose")
  advance(0.5)
  expect.command("flip_pose", "granted")
end)

test("evidence before a restart of the confidences does not count", function()
  learned_room()
  set_world { confidence = { age = 0.5, evidence = 30 } }
  advance(0.1)
  set_world { confidence = { age = 0.3, evidence = 9 } }
  advance(0.3)
  expect.command("flip_pose", "granted")
end)

test("flips with decreased evidence once the pose has settled", function()
  learned_room()
  set_world { confidence = { age = 1.0, evidence = 20 } }
  advance(0.1)
  set_world { confidence = { age = 5.5, evidence = 10 } }
  advance(4.5)
  expect.no_command()
  advance(0.7)
  expect.command("flip_pose", "granted")
end)

test("waits some seconds for the pose to settle, even at a low image rate", function()
  learned_room()
  set_world { confidence = { age = 0.2, evidence = 20 } }
  advance(0.1)
  for second = 1, 4 do
    set_world { confidence = { age = 0.2 + 0.2 * second, evidence = 15 } }
    advance(1.0)
    expect.no_command()
  end
  advance(1.2)
  expect.command("flip_pose", "granted")
end)

test("does not decide before enough of the room was learned", function()
  learned_room()
  set_world { confidence = { evidence = 10, coverage = 0.1 } }
  advance(10)
  expect.no_command()
end)

test("does not flip in a room that looks the same after a rotation by 180 degrees", function()
  learned_room()
  set_world { confidence = { evidence = 10, paired = 0.5, distinctiveness = 0.0 } }
  advance(10)
  expect.no_command()
  expect.state("orientation", "watching/unconfirmed")
end)

test("does not flip in a room that is symmetric as far as it was seen", function()
  learned_room()
  set_world { confidence = { evidence = 10, separability = 0.4 } }
  advance(10)
  expect.no_command()
  expect.state("orientation", "watching/unconfirmed")
  set_world { confidence = { separability = 0.6 } }
  advance(1)
  expect.command("flip_pose")
end)

test("purges when the current pose wins while mirrored beliefs linger", function()
  learned_room()
  set_world { confidence = { evidence = -9 }, pose = { reflected_weight = 0.3 } }
  advance(0.7)
  expect.command("purge_reflection", "granted")
  expect.reason("orientation", "the believed pose won while mirrored beliefs may linger")
end)

test("flips at once after a purge if the evidence changes", function()
  learned_room()
  set_world { confidence = { evidence = -9 }, pose = { reflected_weight = 0.3 } }
  advance(0.3)
  expect.command("purge_reflection", "granted")
  set_world { confidence = { evidence = 9 }, pose = { reflected_weight = 0 } }
  advance(0.3)
  expect.command("flip_pose", "granted")
  expect.reason("orientation", "the mirrored pose won after a purge")
end)

test("does not purge if hardly any mirrored belief is left", function()
  learned_room()
  set_world { confidence = { evidence = -9 }, pose = { reflected_weight = 0.02 } }
  advance(5)
  expect.no_command()
end)

test("resets the orientation after a fall, once the robot is up", function()
  learned_room()
  set_world { robot = { posture = "lying" } }
  advance(3)
  expect.state("orientation", "fallen")
  expect.no_command()
  set_world { robot = { posture = "upright" } }
  advance(0.5)
  expect.state("orientation", "resetting")
  expect.command("reset_orientation", "granted")
  expect.reason("orientation", "the robot got up again")
  advance(3)
  expect.state("orientation", "watching/unconfirmed")
  expect.reason("orientation", "after min_time")
end)

test("a robot that gets up is reset once it stands, not sooner", function()
  learned_room()
  set_world { robot = { posture = "lying" } }
  advance(3)
  set_world { robot = { posture = "getting_up" } }
  advance(2.7)
  expect.state("orientation", "fallen")
  expect.no_command()
  set_world { robot = { posture = "upright" } }
  advance(0.1)
  expect.command("reset_orientation", "granted")
end)

test("a fallen robot that is lifted is not reset, since its next position is unknown", function()
  learned_room()
  set_world { robot = { posture = "lying" } }
  advance(3)
  set_world { robot = { posture = "lifted" } }
  advance(1)
  set_world { robot = { posture = "upright" } }
  advance(3)
  expect.state("orientation", "watching/unconfirmed")
  expect.no_command()
end)

test("purges once after a reset, when the room supports one orientation", function()
  learned_room()
  set_world { robot = { posture = "lying" } }
  advance(3)
  set_world { robot = { posture = "upright" } }
  advance(0.5)
  expect.command("reset_orientation", "granted")
  advance(6)
  expect.no_command()
  set_world { confidence = { evidence = -9 } }
  advance(1)
  expect.command("purge_reflection", "granted")
  advance(10)
  expect.no_command()
end)

test("a fall during the waiting time after a flip counts", function()
  learned_room()
  set_world { confidence = { evidence = 9 } }
  advance(0.7)
  expect.state("orientation", "correcting")
  set_world { robot = { posture = "lying" } }
  advance(0.1)
  expect.state("orientation", "fallen")
  expect.reason("orientation", "the robot fell")
end)

test("a robot that is dropped has fallen", function()
  learned_room()
  set_world { robot = { posture = "lifted" } }
  advance(0.4)
  expect.state("orientation", "lifted")
  expect.reason("orientation", "the robot is lifted")
  set_world { robot = { posture = "lying" } }
  advance(0.1)
  expect.state("orientation", "fallen")
end)

test("does not flip while the confidences are fresh, whatever restarted them", function()
  learned_room()
  set_world { confidence = { evidence = 9, status = "fresh" } }
  advance(3)
  expect.no_command()
end)

test("does not purge while the confidences are fresh", function()
  learned_room()
  set_world { confidence = { evidence = -9, status = "fresh" }, pose = { reflected_weight = 0.3 } }
  advance(3)
  expect.no_command()
end)

test("purges at once after a flip that also mirrored correct particles", function()
  learned_room()
  set_world { confidence = { evidence = 9 }, pose = { reflected_weight = 0.4 } }
  advance(0.3)
  expect.command("flip_pose", "granted")   -- by which the evidence becomes -9
  expect.command("purge_reflection", "granted")
  expect.state("orientation", "purging")
  expect.reason("orientation", "the flip also mirrored correct particles")
end)

test("does not purge the particles that the room supports after a refused flip", function()
  set_param("arbiter.flip_cooldown", 20)
  learned_room()
  set_world { confidence = { evidence = 9 } }
  advance(0.3)
  expect.command("flip_pose", "granted")
  set_world { confidence = { evidence = -9 } }
  advance(10)
  set_world { confidence = { evidence = 30 }, pose = { reflected_weight = 0.4 } }
  advance(1)
  expect.command("flip_pose", "too_soon")
  expect.state("orientation", "correcting")
end)

test("does nothing while it is lifted", function()
  learned_room()
  set_world { robot = { posture = "lifted" }, confidence = { evidence = 10 } }
  advance(5)
  expect.state("orientation", "lifted")
  expect.no_command()
  set_world { robot = { posture = "upright" } }
  advance(0.3)
  expect.no_command()   -- the confidences have restarted
  advance(0.3)
  expect.command("flip_pose", "granted")
end)

test("watches as soon as it stands again, and decides only after new views", function()
  learned_room()
  set_world { robot = { posture = "lifted" } }
  advance(2)
  set_world { robot = { posture = "upright" }, confidence = { evidence = 10 } }
  advance(0.1)
  expect.state("orientation", "watching/unconfirmed")
  expect.reason("orientation", "the robot stands again")
  expect.no_command()
end)

test("purges once after a flip that was confirmed, even with few mirrored beliefs", function()
  learned_room()
  set_world { confidence = { evidence = 10 } }
  advance(0.7)
  expect.command("flip_pose", "granted")
  set_world { confidence = { evidence = -9 } }
  advance(4)
  expect.command("purge_reflection", "granted")
  expect.state("orientation", "purging")
  advance(10)
  expect.state("orientation", "watching/confirmed")
end)

test("requires more evidence to flip a confirmed pose", function()
  learned_room()
  set_world { confidence = { evidence = -9 } }
  advance(0.5)
  expect.state("orientation", "watching/confirmed")
  expect.reason("orientation", "the believed pose won")
  set_world { confidence = { evidence = 7 } }
  advance(5)
  expect.no_command()
  set_world { confidence = { evidence = 10 } }
  advance(0.5)
  expect.command("flip_pose", "granted")
end)

test("the pose is unconfirmed again when earlier views are not valid any more", function()
  learned_room()
  set_world { confidence = { evidence = -9 } }
  advance(0.5)
  expect.state("orientation", "watching/confirmed")
  -- The initial pose was set; the view of this frame counts already.
  set_world { confidence = { age = 0.033, evidence = 0 } }
  advance(0.1)
  expect.state("orientation", "watching/unconfirmed")
  set_world { confidence = { age = 1, evidence = 7 } }
  advance(0.5)
  expect.command("flip_pose", "granted")
end)

test("an edit of the threshold does not change the state and has an effect at once", function()
  learned_room()
  set_world { confidence = { evidence = 4 } }
  advance(2)
  expect.no_command()
  reload { from = "disturbances = { 5.0,", to = "disturbances = { 0.5,", file = "lib/decision.lua" }
  advance(0.6)
  expect.command("flip_pose", "granted")
end)

test("an edit during the waiting time does not restart it", function()
  learned_room()
  set_world { confidence = { evidence = 9 } }
  advance(0.6)
  expect.state("orientation", "correcting")
  set_world { confidence = { evidence = 0 } }
  advance(2.0)
  reload { from = "priority = 50", to = "priority = 51" }
  advance(0.5)
  expect.state("orientation", "correcting")
  advance(0.6)
  expect.state("orientation", "watching/unconfirmed")
end)

test("after an invalid edit the previous version continues to run", function()
  learned_room()
  reload { from = "initial = \"watching\"", to = "initial = \"wathcing\"" }
  expect.refused("did you mean 'watching'?")
  set_world { confidence = { evidence = 9 } }
  advance(0.7)
  expect.command("flip_pose", "granted")
end)

test("the permitted rate of false flips can be set", function()
  set_param("decision.false_flips", "1")
  learned_room()
  set_world { confidence = { evidence = 3 } }
  advance(0.7)
  expect.command("flip_pose")
end)

test("does not decide between the poses while the pose filter is lost, because both may be wrong", function()
  learned_room()
  set_world { confidence = { evidence = 9 }, pose = { recovery_probability = 0.6 } }
  advance(5)
  expect.no_command()
  set_world { pose = { recovery_probability = 0.1 } }
  advance(0.7)
  expect.command("flip_pose", "granted")
end)
