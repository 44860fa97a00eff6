--- Tells the teammates where this robot sees the ball and how sure it is of its own side, and shows whether anything can tell
--- the side. With this behavior, orientation decides on the sum of the parts of lib.side, not on the room alone.

-- SPDX-License-Identifier: MIT

local side = require "lib.side"
local side_report = require "lib.side_report"
local team_evidence = require "lib.team_evidence"

local p = param {
  report_time = { 0.5, range = { 0.1, 10 }, unit = "s", doc = "time between messages to the teammates" },
  hold_time   = { 0.5, range = { 0, 10 },   unit = "s", doc = "time for which the evidence must support another state" },
}

local memory = keep { sent_at = -1000.0 }

local function stands_on_the_field() return robot.posture == "upright" and not robot.penalized and pose.tracked end

local function report()
  if clock.time - memory.sent_at < p.report_time or not stands_on_the_field() then return end
  local ball = team_evidence.ball()
  if not ball then return end
  memory.sent_at = clock.time
  team.send(side_report.encode(ball, side.own_certainty()))
end

local function update()
  side.update()
  report()
end

local function is_unknown() return not side.can_tell() end
local function is_believed() return side.can_tell() and side.evidence() < 0.0 end
local function is_mirrored() return side.can_tell() and side.evidence() > 0.0 end

local function explain(what)
  return function() log.info(what .. ": " .. side.reason()) end
end

local to_unknown = { "cannot tell", when = is_unknown, lasting = "hold_time", because = "no part can tell the side" }
local to_believed = { "believed", when = is_believed, lasting = "hold_time", because = "the evidence supports the believed pose" }
local to_mirrored = { "mirrored", when = is_mirrored, lasting = "hold_time", because = "the evidence supports the mirrored pose" }

behavior "team_side" {
  priority = 45,
  initial = "starting",
  update = update,

  state "starting" { to_believed, to_mirrored, to_unknown },

  state "believed" {
    enter = explain("the side is known"),
    to_mirrored, to_unknown,
  },

  state "mirrored" {
    enter = explain("the side seems mirrored"),
    to_believed, to_unknown,
  },

  state "cannot tell" {
    publishes = "side_is_unknown",
    enter = explain("cannot tell the side"),
    to_believed, to_mirrored,
  },
}
