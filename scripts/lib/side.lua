--- The evidence for the mirrored pose, as the sum of separately reported parts: the room, the ball as the team sees it, the
--- referee's rule that robots are in their own half before a kick-off, and the time since the side was last certain. Each
--- part is in log-odds; positive values support the mirrored pose. Only the room counts in a run without the behavior
--- team_side.

-- SPDX-License-Identifier: MIT

local decision = require "lib.decision"
local team_evidence = require "lib.team_evidence"

local p = param {
  use_room = { true, doc = "whether the evidence of the room counts" },
  use_team = { true, doc = "whether the ball as the team sees it counts" },
  use_rule = { true, doc = "whether the referee's own-half rule counts" },
  use_time = { true, doc = "whether earlier certainty counts" },
  exceptions = { 0.02,  range = { 0.0001, 0.5 },             doc = "fraction of these cases in which a robot is not in its own half" },
  halfway    = { 0.3,   range = { 0.01, 3 },    unit = "m",  doc = "standard deviation of the believed distance from the halfway line" },
  return_time = { 3.0,  range = { 0.1, 30 },    unit = "s",  doc = "time after a penalty in which the robot is in its own half" },
  placed     = { 0.005, range = { 0.0001, 0.5 },             doc = "fraction of the initial poses that are mirrored" },
  swap_time  = { 3600.0, range = { 10, 100000 }, unit = "s", doc = "mean time until an undisturbed robot loses its side" },
  falls      = { 0.05,  range = { 0, 0.5 },                  doc = "fraction of the falls in which the side is lost" },
  enough     = { 2.0,   range = { 0, 20 },                   doc = "smallest evidence at which a part can tell the side, in log-odds" },
}

local MOST = 12.0        -- log-odds that are remembered
local JUMP = 0.4         -- m in a frame: the belief was replaced
local TURN = 0.6         -- rad in a frame

-- `all` and `own` say how sure the side is: 1 minus twice the probability that the believed pose is mirrored. `all` is from
-- every part. `own` is without the team: only this is reported to the teammates, so that no rumor returns to its origin.
local memory = keep {
  all = 0.0, own = 0.0, rule = 0.0, x = 0.0, y = 0.0, rotation = 0.0, known = false, frames = 0, sides_changed = false,
  upright = true, removed = false, returned_at = -1000.0, belief = 0, sum = 0.0, certain_at = -1.0, halfway_at = 0.0,
  disturbance = "",
}

local side = {}

local function to_log_odds(sureness) return math.log((1.0 + sureness) / (1.0 - sureness)) end

local function to_sureness(log_odds)
  local limited = math.max(-MOST, math.min(MOST, log_odds))
  return 1.0 - 2.0 / (1.0 + math.exp(limited))
end

local function room_part()
  return p.use_room and confidence.status == "usable" and confidence.evidence or 0.0
end

local function team_part() return p.use_team and team_evidence.evidence() or 0.0 end

local function rule_part() return p.use_rule and 0.0 - to_log_odds(memory.rule) or 0.0 end

-- What was certain before resists the other parts, or completes them, but does not count a second time what they say now.
local function time_part(sureness, others)
  if not p.use_time then return 0.0 end
  local before = to_log_odds(sureness)
  if before > 0.0 then return 0.0 - math.max(0.0, before - math.max(0.0, -others)) end
  return math.max(0.0, -before - math.max(0.0, others))
end

--- Whether more than the room counts: the behavior team_side runs.
---@return boolean
function side.is_extended() return behaviors.team_side.state ~= nil end

--- The parts of the evidence, each in log-odds.
---@return number room
---@return number team
---@return number rule
---@return number time
function side.parts()
  local room = room_part()
  if not side.is_extended() then return room, 0.0, 0.0, 0.0 end
  local team_now, rule = team_part(), rule_part()
  return room, team_now, rule, time_part(memory.all, room + team_now + rule)
end

--- The sum of the parts: 4.6 means 99 in 100 for the mirrored pose, negative values support the believed pose.
---@return number log_odds
function side.evidence()
  local room, team_now, rule, time = side.parts()
  return room + team_now + rule + time
end

--- The sum of the parts beside the room.
---@return number log_odds
function side.evidence_beside_room()
  local _, team_now, rule, time = side.parts()
  return team_now + rule + time
end

--- Whether a part can tell the side, and the parts do not contradict each other.
---@return boolean
function side.can_tell() return math.abs(side.evidence()) >= p.enough end

--- How sure the robot is that its believed side is right, without what the team says.
---@return number log_odds
---@return integer belief number that changes when its side may have changed
function side.own_certainty()
  local others = room_part() + rule_part()
  return 0.0 - others - time_part(memory.own, others), memory.belief
end

local function rule_reason()
  if memory.rule ~= 0.0 then
    return string.format("before a kick-off or after a penalty it was at x = %.1f m", memory.halfway_at)
  end
  return game.state == "unknown" and "no referee" or "no kick-off and no penalty since a disturbance"
end

local function time_reason()
  if memory.certain_at < 0.0 then
    return memory.disturbance == "" and "the side was never certain" or "not certain since " .. memory.disturbance
  end
  return string.format("certain %.0f s ago", clock.time - memory.certain_at)
end

--- All parts with their reasons, for a log.
---@return string reason
function side.reason()
  local room, team_now, rule, time = side.parts()
  return string.format("room %.1f (%s), team %.1f (%s), rule %.1f (%s), time %.1f (%s)", room, confidence.status,
    team_now, team_evidence.reason(), rule, rule_reason(), time, time_reason())
end

-- ---- what happens to the belief

local function forget(disturbance)
  team_evidence.forget()
  memory.all, memory.own, memory.rule = 0.0, 0.0, 0.0
  memory.certain_at, memory.disturbance = -1.0, disturbance
end

local function turned()
  return math.abs((pose.rotation - memory.rotation + math.pi) % (2.0 * math.pi) - math.pi)
end

local function distance_from(x, y) return math.sqrt((pose.x - x) ^ 2 + (pose.y - y) ^ 2) end

local function is_reflected() return turned() > math.pi - TURN and distance_from(-memory.x, -memory.y) < JUMP end

local function is_set_by_operator()
  return pose.known and (not memory.known or game.state == "initial" or game.state == "ready" or game.state == "set")
end

local function take_flip()
  team_evidence.flip()
  memory.own, memory.rule = -memory.own, -memory.rule
  memory.all = to_sureness(memory.sum)
  memory.certain_at = clock.time
end

local function take_place()
  memory.all = 1.0 - 2.0 * p.placed
  memory.own, memory.certain_at = memory.all, clock.time
end

local function take_jump()
  forget("the belief was replaced")
  if is_set_by_operator() then take_place() end
end

local function watch_belief()
  local has_jumped = memory.frames > 0 and (distance_from(memory.x, memory.y) > JUMP or turned() > TURN)
  if game.sides_changed ~= memory.sides_changed then
    team_evidence.forget()   -- the axes were rotated, not the robot
    memory.belief = memory.belief + 1
  elseif has_jumped then
    memory.belief = memory.belief + 1
    if is_reflected() then take_flip() else take_jump() end
  elseif memory.frames == 0 and pose.known then
    take_place()
  end
  memory.x, memory.y, memory.rotation, memory.known = pose.x, pose.y, pose.rotation, pose.known
  memory.sides_changed = game.sides_changed
end

local function watch_body()
  local is_removed = robot.posture == "lifted" or robot.penalized
  if is_removed then forget(robot.penalized and "a penalty" or "a lift") end
  if is_removed and not memory.removed then memory.belief = memory.belief + 1 end
  if memory.removed and not is_removed then memory.returned_at = clock.time end
  memory.removed = is_removed
  local is_upright = robot.posture == "upright"
  if memory.upright and not is_upright and not is_removed then   -- it falls
    memory.belief = memory.belief + 1
    local left = 1.0 - 2.0 * p.falls
    memory.all, memory.own, memory.rule = left * memory.all, left * memory.own, left * memory.rule
    team_evidence.weaken(p.falls)
  end
  memory.upright = is_upright
end

-- ---- the parts beside room and team

local function is_own_half_certain()
  if robot.penalized or robot.posture ~= "upright" then return false end
  return game.state == "set" or game.state ~= "unknown" and clock.time - memory.returned_at < p.return_time
end

local function watch_rule()
  if not is_own_half_certain() then return end
  local beyond = 1.0 / (1.0 + math.exp(-1.7 * pose.x / p.halfway))   -- probability that it believes to be beyond the line
  memory.rule = (1.0 - 2.0 * beyond) * (1.0 - 2.0 * p.exceptions)
  memory.halfway_at = pose.x
end

-- Less than certain is not remembered, because a part of it may be contradicted soon, as by another teammate.
local function remember_certainty()
  local left = 1.0 - 2.0 * math.min(1.0, clock.step) / p.swap_time
  memory.all, memory.own, memory.rule = left * memory.all, left * memory.own, left * memory.rule
  local own = room_part() + rule_part()
  local all = own + team_part()
  local certain = decision.unconfirmed_threshold()
  if -own > certain then memory.own = math.max(memory.own, to_sureness(-own)) end
  if -all > certain and to_sureness(-all) >= memory.all then
    memory.all, memory.certain_at = to_sureness(-all), clock.time
  end
  memory.sum = all + time_part(memory.all, all)
end

--- Updates the parts, once in each frame.
function side.update()
  if not side.is_extended() then return end
  watch_belief()
  watch_body()
  team_evidence.update(pose.tracked)
  watch_rule()
  remember_certainty()
  memory.frames = 1
end

return side
