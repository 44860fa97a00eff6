--- The scenario plays the application of the interface `ball`: a ball rolls toward the robot, which kicks it away.
--- Example: `reorient run ball --seconds 30`

-- SPDX-License-Identifier: MIT

local p = param {
  kicks = { 3, range = { 1, 100 }, integer = true, doc = "kicks after which the scenario has succeeded" },
  speed = { 0.5, range = { 0.1, 3 }, unit = "m/s", doc = "speed of the ball" },
  swing = { 1.0, range = { 0.1, 3 }, unit = "s", doc = "duration of a kick" },
  timeout = { 60.0, range = { 1, 600 }, unit = "s", doc = "time after which the scenario has failed" },
}

local memory = keep { distance = 2.0, side = 0.06, kicks = 0 }

local function show_ball()
  application.set { ball = { seen = true, position = { x = memory.distance, y = memory.side }, distance = memory.distance } }
end

local function roll()
  memory.distance = math.max(0.15, memory.distance - p.speed * clock.step)
  show_ball()
end

local function send_ball_away()
  memory.kicks = memory.kicks + 1
  memory.distance = 2.0
  memory.side = -memory.side
  show_ball()
  application.report("kick", "done")
end

scenario "ball" {
  behaviors = { "kick_ball" },
  interface = "ball",
  initial = "placing",

  state "placing" {
    enter = function()
      operator.put_down(0, 0, 0)
      operator.set_initial_pose(0, 0, 0)
    end,
    { "rolling", after = 0.5, because = "the robot stands" },
  },

  state "rolling" {
    update = roll,
    { "swinging", when = function() return application.state("kick") == "requested" end, because = "a kick was requested" },
    { "failed", after = "timeout", because = "no kick was requested" },
  },

  state "swinging" {
    enter = function() application.report("kick", "running") end,
    update = show_ball,
    exit = send_ball_away,
    { "rolling", when = function() return memory.kicks + 1 < p.kicks end, after = "swing", because = "the ball was kicked" },
    { "succeeded", after = "swing", because = "all kicks were made" },
  },

  state "succeeded" { enter = function() verdict.succeed("the robot kicked " .. memory.kicks .. " times") end },
  state "failed" { enter = function() verdict.fail("the robot kicked " .. memory.kicks .. " times only") end },
}
