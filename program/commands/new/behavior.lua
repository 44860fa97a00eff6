--- Replace this by one or two sentences that say what the behavior is for. This example looks around while the robot
--- is not sure of its pose.

local p = param {
  sure  = { 0.5, range = { 0, 1 },                doc = "how far the believed pose must be ahead for the robot to be sure" },
  dwell = { 1.0, range = { 0.1, 10 }, unit = "s", doc = "how long to look to one side" },
  angle = { 0.8, range = { 0, 2 }, unit = "rad",  doc = "largest yaw of the head to each side" },
}

local memory = keep { looks = 0 }   -- survives a reload; local variables do not

local function is_sure() return confidence.current - confidence.opposite > p.sure end

behavior "NAME" {
  priority = 22,                    -- greater than that of head_scan: while this one looks, that one waits
  initial = "sure",

  state "sure" {
    { "looking", when = function() return not is_sure() end, lasting = 0.5, because = "the robot is not sure of its pose" },
  },

  state "looking" {
    initial = "left",
    enter = function()
      memory.looks = memory.looks + 1
      log.info("not sure of the pose: look " .. memory.looks)
    end,
    { "sure", when = is_sure, because = "the robot is sure of its pose" },

    state "left" {
      update = function() head.look(p.angle, 0) end,
      { "right", after = "dwell" },
    },
    state "right" {
      update = function() head.look(-p.angle, 0) end,
      { "left", after = "dwell" },
    },
  },
}
