--- Replace this by a description of the situation. In this example the operator sets the pose of the robot, and the
--- scenario judges the error of the believed pose after some time.

local p = param {
  time  = { 20.0, range = { 1, 600 }, unit = "s",  doc = "how long to wait" },
  error = { 0.5,  range = { 0.01, 5 }, unit = "m", doc = "how far the believed pose may be off" },
}

local function is_right()
  local dx, dy = pose.x - truth.x, pose.y - truth.y
  return dx * dx + dy * dy < p.error * p.error
end

scenario "NAME" {
  behaviors = { "orientation", "head_scan" },
  initial = "placing",

  state "placing" {
    enter = function()
      operator.put_down(-1.0, 0.5, 0)
      operator.set_initial_pose(-1.0, 0.5, 0)
    end,
    { "waiting", after = 0.1, because = "the initial pose is set" },
  },

  state "waiting" {
    { "right", when = is_right, after = "time", because = "the time is over" },
    { "wrong", after = "time", because = "the time is over" },
  },

  state "right" { enter = function() verdict.succeed("the robot knows its place") end },
  state "wrong" { enter = function() verdict.fail("the robot has lost its place") end },
}
