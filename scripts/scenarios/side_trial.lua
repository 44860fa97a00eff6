--- A robot with a known side is lifted and placed at the reflection of its belief, or returned. Teammates see the ball and
--- report it. For the experiment `side`, which measures what the parts of the evidence are worth. The simulator detects the
--- ball. Example: `reorient run side_trial --interface ball --with search_ball --set side_trial.teammates=4`

-- SPDX-License-Identifier: MIT

local ground_truth = require "lib.ground_truth"
local simulated_team = require "lib.simulated_team"

local p = param {
  mirrored  = { true, doc = "whether the robot is placed at the reflection of its belief; otherwise it is returned" },
  teammates = { 2, range = { 0, 4 }, integer = true, doc = "number of teammates that report the ball" },
  mirrored_teammates = { 0, range = { 0, 4 }, integer = true, doc = "number of teammates that believe the mirrored pose" },
  certainty = { 3.8, range = { -9.9, 9.9 }, doc = "certainty of the teammates in log-odds; 3.8: a minute after a kick-off" },
  ball      = { "still", choices = { "still", "rolling", "center" },
    doc = "where the ball is: at random, at rest or rolling, or within 0.3 m of the center mark" },
  kick_off  = { false, doc = "whether the referee sets a kick-off when the robot is placed, so that it stands in its own half" },
  dark      = { 0.0,  range = { 0, 12 },   unit = "stops", doc = "how much darker the hall gets before the robot is placed" },
  learn     = { 5.0,  range = { 0, 600 },  unit = "s", doc = "time for which the robot stands before it is lifted" },
  carry     = { 1.5,  range = { 0.2, 30 }, unit = "s", doc = "time for which the robot is lifted" },
  set_time  = { 5.0,  range = { 0.1, 60 }, unit = "s", doc = "time from the placement to the kick-off" },
  timeout   = { 25.0, range = { 1, 600 },  unit = "s", doc = "time for which the belief is observed" },
}

local MARGIN = 0.7                          -- m, of the robot from the lines
local NEAREST, FARTHEST = 1.0, 4.0          -- m, of the ball from the robot
local AT_CENTER = 0.3                       -- m
local SLOWEST, FASTEST = 0.4, 1.5           -- m/s, of a ball that begins to roll
local FRICTION = 0.35                       -- m/s^2, as that of the simulator

local memory = keep { x = 0.0, y = 0.0, rotation = 0.0, ball_x = 0.0, ball_y = 0.0, speed_x = 0.0, speed_y = 0.0 }

local function random_pose()
  local x, y = field.length / 2 - MARGIN, field.width / 2 - MARGIN
  -- At the kick-off the robot truly stands in its own half. A mirrored robot believes to stand in the other one.
  local most_x = p.kick_off and -MARGIN or x
  local side = p.kick_off and p.mirrored and -1.0 or 1.0
  return side * chance.between(-x, most_x), chance.between(-y, y), chance.between(-math.pi, math.pi)
end

local function place_ball()
  if p.ball == "center" then
    memory.ball_x, memory.ball_y = simulated_team.place_around(0.0, 0.0, 0.0, AT_CENTER, 0.0)
  else
    memory.ball_x, memory.ball_y = simulated_team.place_around(truth.x, truth.y, NEAREST, FARTHEST, 0.2)
  end
  local direction, speed = chance.between(-math.pi, math.pi), chance.between(SLOWEST, FASTEST)
  if p.ball ~= "rolling" then speed = 0.0 end
  memory.speed_x, memory.speed_y = speed * math.cos(direction), speed * math.sin(direction)
  operator.put_ball(memory.ball_x, memory.ball_y)
end

local function rebounding(position, speed, most)
  if math.abs(position) <= most then return speed end
  return position > 0.0 and -math.abs(speed) or math.abs(speed)
end

-- The ball rolls on straight lines, ever slower, and rebounds from the lines of the field.
local function roll_ball()
  local speed = math.sqrt(memory.speed_x ^ 2 + memory.speed_y ^ 2)
  local left = speed > 0.0 and math.max(0.0, 1.0 - FRICTION * clock.step / speed) or 0.0
  memory.speed_x, memory.speed_y = left * memory.speed_x, left * memory.speed_y
  memory.ball_x = memory.ball_x + memory.speed_x * clock.step
  memory.ball_y = memory.ball_y + memory.speed_y * clock.step
  memory.speed_x = rebounding(memory.ball_x, memory.speed_x, field.length / 2)
  memory.speed_y = rebounding(memory.ball_y, memory.speed_y, field.width / 2)
  operator.put_ball(memory.ball_x, memory.ball_y)
end

local function put_down()
  if p.mirrored then
    operator.put_down(-memory.x, -memory.y, memory.rotation + math.pi)
  else
    operator.put_down(truth.x, truth.y, truth.rotation)
  end
  if p.kick_off then operator.set_game_state("set") end
end

scenario "side_trial" {
  behaviors = { "team_side", "orientation", "background_training", "get_up" },
  priority = 100,
  initial = "placing",

  state "placing" {
    enter = function()
      local x, y, rotation = random_pose()
      operator.put_down(x, y, rotation)
      operator.set_initial_pose(x, y, rotation)
      operator.put_ball(0.0, 0.0)
    end,
    { "learning", after = 0.1, because = "the initial pose is set" },
  },

  state "learning" {
    { "carried", after = "learn", because = "the operator lifts the robot" },
  },

  state "carried" {
    enter = function()
      memory.x, memory.y, memory.rotation = pose.x, pose.y, pose.rotation
      operator.pick_up()
      if p.dark > 0.0 then operator.set_exposure_compensation(-p.dark) end
    end,
    { "measured", after = "carry", because = "the robot is placed" },
  },

  state "measured" {
    initial = "about to see the ball",
    enter = put_down,
    update = simulated_team.update,
    { "cannot tell", when = function() return published.side_is_unknown end, after = "timeout",
      because = "the time is up and the robot cannot tell its side" },
    { "right", when = ground_truth.is_belief_right, after = "timeout", because = "the time is up and the belief is right" },
    { "wrong", after = "timeout", because = "the time is up and the belief is wrong" },

    state "about to see the ball" {
      { "before the kick-off", when = function() return p.kick_off end, after = 0.1, because = "the referee sets a kick-off" },
      { "playing", after = 0.1, because = "the robot stands" },
    },

    state "before the kick-off" {
      enter = function()
        place_ball()
        simulated_team.place(p.teammates, p.mirrored_teammates, p.certainty)
      end,
      { "after the kick-off", after = "set_time", because = "the kick-off" },
    },

    state "after the kick-off" {
      enter = function() operator.set_game_state("playing") end,
      update = roll_ball,
    },

    state "playing" {
      enter = function()
        place_ball()
        simulated_team.place(p.teammates, p.mirrored_teammates, p.certainty)
      end,
      update = roll_ball,
    },
  },

  state "cannot tell" {
    enter = function() ground_truth.give_verdict(ground_truth.is_belief_right()) end,
  },

  state "right" {
    enter = function() ground_truth.give_verdict(true) end,
  },

  state "wrong" {
    enter = function() ground_truth.give_verdict(false) end,
  },
}
