--- A recorded flip of a mirrored robot (seed 1, 160 pixels wide), placed at 42.5 s.
--- Made by reorient record-test from its recording, 42.90 to 43.90 s.

-- SPDX-License-Identifier: MIT

test("flips its belief about a second after its feet touched the ground", function()
  replay "recordings/recorded_flip.mcap"
  expect.state("orientation", "watching/unconfirmed")
  expect.near(world_value("pose.x"), -3.2, 0.5)

  advance_to(43.37)
  expect.no_command("flip_pose")

  advance_to(43.43)
  expect.command("flip_pose", "granted")
  expect.reason("orientation", "the mirrored pose won")

  advance_to(43.90)
  expect.state("orientation", "correcting")
  expect.near(world_value("pose.x"), 3.2, 0.5)
end)

test("waits longer if hold_time is longer", function()
  replay "recordings/recorded_flip.mcap"
  set_param("orientation.hold_time", "2")
  advance_to(43.90)
  expect.no_command("flip_pose")
end)
