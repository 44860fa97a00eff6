--- One player alone with the ball of the simulator: run it with `--interface ball`. Counts the goals in a given time.

-- SPDX-License-Identifier: MIT

local p = param {
  duration = { 300.0, range = { 10, 3600 }, unit = "s", doc = "time after which the scenario ends" },
  fall_time = { 0.0, range = { 0, 600 }, unit = "s", doc = "time between two falls (0: none)" },
  report_time = { 10.0, range = { 1, 600 }, unit = "s", doc = "time between two reports of the ball's position" },
}

local memory = keep { goals = 0, own_goals = 0, pushed_at = 0.0 }

local function start()
  operator.put_down(-2.0, 0.0, 0.0)
  operator.set_initial_pose(-2.0, 0.0, 0.0)
  operator.put_ball(0.0, 0.0)
  operator.set_kick_off "ours"
  operator.set_game_state "ready"
end

local function count()
  if truth.score == memory.goals and truth.score_of_opponents == memory.own_goals then return end
  memory.goals, memory.own_goals = truth.score, truth.score_of_opponents
  log.info(string.format("goals: %d, own goals: %d", memory.goals, memory.own_goals))
  operator.put_ball(0.0, 0.0)
end

local function push_at_times()
  if p.fall_time == 0 or clock.time - memory.pushed_at < p.fall_time then return end
  memory.pushed_at = clock.time
  operator.push_over()
end

local function report()
  log.info(string.format("ball at (%.2f, %.2f), robot at (%.2f, %.2f, %.0f deg), belief (%.2f, %.2f, %.0f deg)",
    truth.ball_x, truth.ball_y, truth.x, truth.y, math.deg(truth.rotation), pose.x, pose.y, math.deg(pose.rotation)))
end

scenario "practice" {
  behaviors = { "player", "get_up", "orientation", "background_training", "kidnap_recovery" },
  priority = 100,
  initial = "preparing",

  state "preparing" {
    enter = start,
    { "playing", after = 5.0, because = "the robot had time to take its position" },
  },

  state "playing" {
    initial = "counting",
    enter = function() operator.set_game_state "playing" end,
    update = function()
      count()
      push_at_times()
    end,
    { "over", after = "duration", because = "the time is up" },

    state "counting" {
      exit = report,
      { "counting", after = "report_time", because = "it is time for a report" },
    },
  },

  state "over" {
    enter = function()
      local text = string.format("goals: %d, own goals: %d", memory.goals, memory.own_goals)
      if memory.goals > memory.own_goals then verdict.succeed(text) else verdict.fail(text) end
    end,
  },
}
