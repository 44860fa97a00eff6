--- Moves the head from side to side, once over the walls of the room and once over the lines of the field, so that room
--- awareness and self-localization both see enough. A robot that searches for its position looks only at the lines, but
--- for a limited time, because a robot that finds no lines must learn the room, too.

-- SPDX-License-Identifier: MIT

local p = param {
  width       = { 1.1,  range = { 0, 2.0 },      unit = "rad",   doc = "largest yaw of the head to each side" },
  speed       = { 1.0,  range = { 0.1, 5.0 },    unit = "rad/s", doc = "rotation speed of the head" },
  wall_pitch  = { -0.1, range = { -0.6, 0.5 },   unit = "rad",   doc = "pitch of the head while looking at the walls" },
  field_pitch = { 0.25, range = { -0.6, 0.5 },   unit = "rad",   doc = "pitch of the head while looking at the field" },
  line_search = { 15.0, range = { 0, 600 },      unit = "s",     doc = "longest time to look at lines only while the position is unknown" },
  timeout     = { 4.0,  range = { 0.5, 20.0 },   unit = "s",     doc = "time after which the head turns back without reaching the side" },
}

local NEAR = 0.05   -- rad

local memory = keep { began = 0.0, was_tracked = true }   -- start of the search for the position, s

local function side() return math.min(p.width, robot.head_reach) end   -- rad

local function is_left() return math.abs(robot.head_yaw - side()) < NEAR end

local function is_right() return math.abs(robot.head_yaw + side()) < NEAR end

local function look(yaw, pitch)
  if memory.was_tracked and not pose.tracked then memory.began = clock.time end
  memory.was_tracked = pose.tracked
  head.look(yaw, pitch, p.speed)
end

local function wall_pitch()   -- rad
  local looks_for_lines = not pose.tracked and (memory.was_tracked or clock.time - memory.began < p.line_search)
  return looks_for_lines and p.field_pitch or p.wall_pitch
end

behavior "head_scan" {
  priority = 10,
  initial = "walls to the left",

  state "walls to the left" {
    update = function() look(side(), wall_pitch()) end,
    { "walls to the right", when = is_left, because = "the side is reached" },
    { "walls to the right", after = "timeout", because = "the side cannot be reached" },
  },

  state "walls to the right" {
    update = function() look(-side(), wall_pitch()) end,
    { "field to the left", when = is_right, because = "the side is reached" },
    { "field to the left", after = "timeout", because = "the side cannot be reached" },
  },

  state "field to the left" {
    update = function() look(side(), p.field_pitch) end,
    { "field to the right", when = is_left, because = "the side is reached" },
    { "field to the right", after = "timeout", because = "the side cannot be reached" },
  },

  state "field to the right" {
    update = function() look(-side(), p.field_pitch) end,
    { "walls to the left", when = is_right, because = "the side is reached" },
    { "walls to the left", after = "timeout", because = "the side cannot be reached" },
  },
}
