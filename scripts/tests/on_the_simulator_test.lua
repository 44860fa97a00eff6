--- Whole scenarios on the simulator, from the camera image to the verdict: reorient test --simulator runs them.

-- SPDX-License-Identifier: MIT

test("a mirrored robot notices, flips and ends with a correct belief", function()
  local is_right = simulate { scenario = "mirrored_placement", seed = 1 }
  expect.verdict(true, "walked to the right mark")
  expect.command("flip_pose", "granted")
  expect.command("purge_reflection", "granted")
  expect.equal(is_right, true)
end)

test("the same robot without room awareness never notices", function()
  local is_right = simulate { scenario = "mirrored_placement", seed = 1, room_awareness = false }
  expect.verdict(false, "believes its mirrored pose")
  expect.no_command("flip_pose")
  expect.equal(is_right, false)
end)

test("a robot that fell resets its orientation and finds it again", function()
  local is_right = simulate { scenario = "fallen", seed = 1 }
  expect.verdict(true, "found it again")
  expect.command("reset_orientation", "granted")
  expect.equal(is_right, true)
end)

test("a kidnapped robot distrusts its pose, searches, and finds its position", function()
  local is_right = simulate { scenario = "kidnapped", seed = 2 }
  expect.verdict(true, "found its position")
  expect.log("recovered")
  expect.equal(is_right, true)
end)

test("a robot that knows its room keeps its belief when the teams change sides", function()
  local is_right = simulate { scenario = "half_time", seed = 1 }
  expect.verdict(true, "knows its position after the change of sides")
  expect.no_command("flip_pose")
  expect.equal(is_right, true)
end)
