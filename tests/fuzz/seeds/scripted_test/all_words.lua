test("everything", function()
  load_behavior "orientation"
  load_scenario "kidnapped"
  set_world { confidence = { opposite = 0.9, current = 0.1 }, robot = { posture = "upright" }, truth = { x = 1 } }
  set_param("orientation.lingering", "0.2")
  advance(0.5)
  expect.state("orientation", "watching")
  expect.reason("orientation", "x")
  expect.command("flip_pose", "granted")
  expect.no_command()
  expect.lease("pause_training")
  expect.no_lease("pause_training")
  expect.head(0, 0)
  expect.walk(0, 0, 0)
  expect.get_up(false)
  expect.log("x")
  expect.action("pick_up")
  expect.verdict(true, "x")
  reload { from = "lead", to = "laed" }
  expect.refused("lead")
  expect.error("x")
  expect.near(1, 1.5, 0.1)
end)
test("simulates", function()
  local correct = simulate { scenario = "mirrored_placement", seed = 3, with = { "head_scan" }, params = { ["a.b"] = true } }
  expect.equal(correct, true)
  expect.log("head_scan")
  expect.equal({ 1, { a = "x" } }, { 1, { a = "y", b = 2 } })
end)
