--- Looks for the ball: first the head turns from side to side, then the body turns, too, until the ball is seen. While
--- the ball is seen, the head follows it.
--
-- It needs an application that detects the ball: `reorient run --interface ball`, or `reorient game`.

-- SPDX-License-Identifier: MIT

local p = param {
  width = { 1.0, range = { 0.1, 2.0 }, unit = "rad", doc = "largest yaw of the head to each side during the search" },
  pitch = { 0.3, range = { -0.6, 0.5 }, unit = "rad", doc = "pitch of the head during the search" },
  speed = { 1.2, range = { 0.1, 5.0 }, unit = "rad/s", doc = "rotation speed of the head during the search" },
  turn = { 0.6, range = { 0.1, 2 }, unit = "rad/s", doc = "rotation speed of the body" },
  lost_time = { 1.5, range = { 0.1, 30 }, unit = "s", doc = "time without the ball before the search begins" },
  head_time = { 4.0, range = { 0, 60 }, unit = "s", doc = "time of the search with the head alone" },
  turn_time = { 12.0, range = { 1, 120 }, unit = "s", doc = "time for which the body turns before it rests" },
}

local CAMERA_HEIGHT = 0.5   -- m, above the ground; exact enough to look at a ball
local NEAR = 0.1            -- rad

-- `side`: to which the head turns now. `seen_side`: where the ball was seen last, because it is probably still there.
local memory = keep { side = 1, seen_side = 1 }

local function sees_ball() return input.valid.ball.seen and input.ball.seen end

local function has_lost_ball() return not sees_ball() end

local function follow()
  if not input.valid.ball.position then return end
  local ball = input.ball.position
  if sees_ball() then
    memory.seen_side = ball.y >= 0 and 1 or -1
    memory.side = memory.seen_side
  end
  local reach = robot.head_reach
  local yaw = math.max(-reach, math.min(reach, math.atan(ball.y, ball.x)))
  head.look(yaw, math.atan(CAMERA_HEIGHT, input.ball.distance) - 0.1, 4.0)
end

local function scan()
  local target = memory.side * math.min(p.width, robot.head_reach)
  if math.abs(robot.head_yaw - target) < NEAR then memory.side = -memory.side end
  head.look(target, p.pitch, p.speed)
end

local function turn_toward_side()
  scan()
  walk.velocity(0.0, 0.0, memory.seen_side * p.turn)
end

behavior "search_ball" {
  priority = 30,
  initial = "searching",

  state "following" {
    update = follow,
    { "searching", when = has_lost_ball, lasting = "lost_time", because = "the ball is not seen" },
  },

  state "searching" {
    initial = "with the head",
    { "following", when = sees_ball, because = "the ball is seen" },

    state "with the head" {
      update = scan,
      { "with the body", when = function() return robot.may_walk and robot.can_walk end, after = "head_time",
        because = "the head did not find the ball" },
    },

    state "with the body" {
      update = turn_toward_side,
      { "with the head", when = function() return not robot.may_walk end, because = "the referee does not permit walking" },
      { "with the head", after = "turn_time", because = "the body has turned once" },
    },
  },
}
