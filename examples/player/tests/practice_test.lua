--- Tests of scenarios/practice.lua.

-- SPDX-License-Identifier: MIT

local function begin()
  load_interface "ball"
  load_scenario "practice"
  set_param("practice.duration", "20")
  set_world { truth = { x = 0, y = 0, rotation = 0, ball_x = 1, ball_y = 0, score = 0, score_of_opponents = 0 } }
end

test("places robot and ball, lets the robot play, and ends after its time", function()
  begin()
  advance(0.1)
  expect.action "put_down"
  expect.action "put_ball"
  expect.state("practice", "preparing")
  advance(5)
  expect.state("practice", "playing/counting")
  expect.action "set_game_state"
  advance(20)
  expect.verdict(false, "goals: 0, own goals: 0")
end)

test("counts a goal and puts the ball on the center mark", function()
  begin()
  advance(6)
  set_world { truth = { score = 1 } }
  advance(0.1)
  expect.log "goals: 1, own goals: 0"
  expect.action "put_ball"
  advance(20)
  expect.verdict(true, "goals: 1, own goals: 0")
end)

test("pushes the robot over if that is requested, and reports where the ball lies", function()
  begin()
  set_param("practice.fall_time", "8")
  advance(8.1)
  expect.action "push_over"
  advance(7)
  expect.log "ball at"
end)
