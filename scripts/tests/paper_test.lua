--- Tests of behaviors/paper/paper_orientation.lua, behaviors/paper/paper_training.lua and scenarios/wrong_start.lua.

-- SPDX-License-Identifier: MIT

local function start(behavior)
  load_behavior("paper/" .. behavior)
  advance(0.1)
end

test("the paper's orientation flips at once when the mirrored pose wins, in any room", function()
  start "paper_orientation"
  set_world { confidence = { opposite = 0.4 } }
  advance(0.1)
  expect.command("flip_pose", "granted")
  expect.reason("paper_orientation", "the mirrored pose wins")
end)

test("the paper's orientation purges whenever the current pose wins", function()
  start "paper_orientation"
  set_world { confidence = { current = 0.4 } }
  advance(0.1)
  expect.command("purge_reflection", "granted")
  expect.reason("paper_orientation", "the current pose wins")
  advance(2.8)
  expect.no_command()
  advance(0.4)
  expect.command("purge_reflection")
end)

test("the paper's orientation does nothing while neither wins", function()
  start "paper_orientation"
  set_world { confidence = { current = 0.4, opposite = 0.2 } }
  advance(10)
  expect.no_command()
end)

test("the paper's orientation resets after a fall", function()
  start "paper_orientation"
  set_world { robot = { posture = "lying" } }
  advance(1)
  expect.state("paper_orientation", "fallen")
  set_world { robot = { posture = "upright" } }
  advance(0.1)
  expect.command("reset_orientation", "granted")
  expect.reason("paper_orientation", "the robot got up again")
  advance(3.1)
  expect.state("paper_orientation", "watching")
end)

test("the paper's training rotates the robot until the room is known, then trains online", function()
  set_world { pose = { known = true } }
  start "paper_training"
  expect.state("paper_training", "learning")
  expect.walk(0, 0, 0.6)
  expect.lease("pause_evaluation")
  expect.no_lease("pause_training")
  set_world { training = { seconds = 21 } }
  advance(0.1)
  expect.state("paper_training", "training online")
  expect.no_lease("pause_evaluation")
  set_world { confidence = { opposite = 1.0 } }
  advance(10)
  expect.no_lease("pause_training")
end)

test("the paper's training waits for a pose, and trusts a room that is known", function()
  start "paper_training"
  expect.state("paper_training", "waiting")
  set_world { training = { seconds = 21 } }
  advance(0.1)
  expect.reason("paper_training", "the room is known")
end)

test("the paper's training is interrupted by falls, lifts and penalties", function()
  set_world { pose = { known = true }, training = { seconds = 21 } }
  start "paper_training"
  for _, change in ipairs { { { posture = "lying" }, { posture = "upright" } }, { { penalized = true }, { penalized = false } } } do
    set_world { robot = change[1] }
    advance(1)
    expect.state("paper_training", "disturbed")
    expect.lease("pause_training")
    expect.lease("pause_evaluation")
    set_world { robot = change[2] }
    advance(0.2)
    expect.state("paper_training", "training online")
  end
end)

local function mislead()
  load_scenario "wrong_start"
  set_world { truth = { x = -3.2, y = -3.5, rotation = math.rad(90) }, pose = { x = -3.2, y = -3.5, rotation = math.rad(90) } }
  advance(40.2)
  expect.action("set_initial_pose")
  expect.log("initial pose: reflection")
  set_world { pose = { x = 3.2, y = 3.5, rotation = math.rad(-90) } }
end

test("a wrong start succeeds when the belief is right again", function()
  mislead()
  advance(10)
  expect.state("wrong_start", "misled/wrong")
  set_world { pose = { x = -3.2, y = -3.5, rotation = math.rad(90) } }
  advance(2.2)
  expect.verdict(true, "noticed")
end)

test("a wrong start fails after 200 s", function()
  mislead()
  advance(201)
  expect.verdict(false, "still believes")
end)
