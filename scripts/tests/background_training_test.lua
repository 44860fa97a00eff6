--- Tests of behaviors/background_training.lua.

local function start()
  load_behavior "background_training"
  set_world { pose = { known = true } }
  advance(0.1)
end

local function learned()
  start()
  set_world { training = { seconds = 30 }, confidence = { coverage = 0.9 } }
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

test("it goes on learning until enough of the wall is covered", function()
  start()
  set_world { training = { seconds = 25 }, confidence = { coverage = 0.2 } }
  advance(1)
  expect.state("background_training", "learning/studying")
end)

test("it trusts the model after a while whatever the coverage", function()
  start()
  set_world { training = { seconds = 36 }, confidence = { coverage = 0.2 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
end)

test("while it learns from a pose that it was told, it purges reflected beliefs", function()
  start()
  set_world { training = { seconds = 5 }, pose = { reflected_weight = 0.02 } }
  advance(1)
  expect.no_command()
  set_world { pose = { reflected_weight = 0.2 } }
  advance(0.1)
  expect.command("purge_reflection", "granted")
  expect.state("background_training", "learning/vouching")
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

test("it trains on only while the current pose clearly wins", function()
  learned()
  set_world { confidence = { current = 0.8, opposite = 0.1 } }
  advance(0.9)
  expect.lease("pause_training")
  advance(0.3)
  expect.state("background_training", "trusting/refining")
  expect.no_lease("pause_training")
  set_world { confidence = { current = 0.3 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
end)

for _, what in ipairs { "fallen", "carried", "penalized" } do
  test("it stops refining while the robot is " .. what, function()
    learned()
    set_world { confidence = { current = 0.9 } }
    advance(2)
    expect.state("background_training", "trusting/refining")
    set_world { robot = { [what] = true } }
    advance(0.1)
    expect.state("background_training", "trusting/watching")
    expect.reason("background_training", "the robot does not stand on the field")
    expect.lease("pause_training")
    advance(20)
    expect.lease("pause_training")
  end)

  test("it stops learning while the robot is " .. what, function()
    start()
    set_world { robot = { [what] = true } }
    advance(0.1)
    expect.state("background_training", "waiting")
    expect.reason("background_training", "the robot does not stand on the field")
    expect.lease("pause_training")
    expect.lease("pause_evaluation")
    set_world { robot = { [what] = false } }
    advance(0.4)
    expect.state("background_training", "waiting")
    advance(0.3)   -- after it was carried nobody vouches for its pose
    expect.state("background_training", what == "carried" and "waiting" or "learning/studying")
  end)

  test("with training_pause both rest while the robot is " .. what .. ", and nothing is trained sooner than it may", function()
    load_behavior "training_pause"
    learned()
    set_world { confidence = { current = 0.9 }, robot = { [what] = true } }
    advance(1)
    expect.lease("pause_training")
    expect.lease("pause_evaluation")
    set_world { robot = { [what] = false } }
    advance(1)
    expect.lease("pause_training")
    expect.no_lease("pause_evaluation")
    advance(10)
    expect.no_lease("pause_training")
  end)
end

test("a room that is known already is trusted at once", function()
  load_behavior "background_training"
  set_world { training = { seconds = 30 }, confidence = { coverage = 0.9 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
  expect.reason("background_training", "the room is known")
end)

test("a room that was learned enough while a purge settles is trusted", function()
  start()
  set_world { training = { seconds = 5 }, pose = { reflected_weight = 0.2 } }
  advance(0.1)
  expect.state("background_training", "learning/vouching")
  set_world { training = { seconds = 36 } }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
end)

test("after it was put down it does not train on confidences from before", function()
  learned()
  set_world { confidence = { current = 0.9 }, robot = { carried = true } }
  advance(1)
  set_world { robot = { carried = false } }
  advance(9)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
  advance(1)
  expect.state("background_training", "trusting/refining")
end)

test("a robot that was lifted before it had learned the room does not learn from a pose that nobody vouches for", function()
  start()
  set_world { training = { seconds = 5 } }
  set_world { robot = { carried = true } }
  advance(1)
  set_world { robot = { carried = false } }
  advance(5)
  expect.state("background_training", "waiting")
  expect.lease("pause_training")
end)

test("a robot that was lifted before it trained at all does not vouch for its pose any more, either", function()
  start()
  advance(1)
  set_world { robot = { carried = true } }
  advance(1)
  set_world { robot = { carried = false }, pose = { reflected_weight = 0.5 } }
  advance(5)
  expect.state("background_training", "waiting")
  expect.no_command()
end)

test("a robot that was told its pose while it was still carried learns once it stands", function()
  load_behavior "background_training"
  set_world { robot = { carried = true }, pose = { known = true } }
  advance(2)
  expect.state("background_training", "waiting")
  set_world { robot = { carried = false } }
  advance(1)
  expect.state("background_training", "learning/studying")
end)

test("a reload in the middle keeps the leases", function()
  learned()
  reload { from = "doc = \"how long that lead must last\"", to = "doc = \"how long it must last\"" }
  advance(0.1)
  expect.state("background_training", "trusting/watching")
  expect.lease("pause_training")
  expect.no_lease("pause_evaluation")
end)
