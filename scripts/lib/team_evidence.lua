--- The evidence of ball and team for the mirrored pose. A robot whose belief is mirrored sees the ball at the mirrored place.
--- So each report of a teammate is compared with where this robot sees the ball, and with the reflection of that place. The
--- errors of both are normally distributed, and some reports show something else. Looks at one scene share most of their
--- errors, so they count once: another scene begins when the ball has moved. A single look may be false, so it counts less
--- than two. A teammate may be mirrored itself, so its reports are never worth more than its own certainty.

-- SPDX-License-Identifier: MIT

local side_report = require "lib.side_report"

local p = param {
  bearing_noise   = { 0.02,  range = { 0, 0.5 }, unit = "rad", doc = "standard deviation of the measured direction of the ball" },
  elevation_noise = { 0.008, range = { 0, 0.2 }, unit = "rad", doc = "standard deviation of the angle of the ball below the horizon" },
  camera_height   = { 0.5,   range = { 0.1, 3 }, unit = "m",   doc = "height of the camera above the ball" },
  position        = { 0.15,  range = { 0, 2 },   unit = "m",   doc = "standard deviation of the believed position" },
  rotation        = { 0.05,  range = { 0, 1 },   unit = "rad", doc = "standard deviation of the believed direction" },
  ball_speed      = { 1.0,   range = { 0, 10 },  unit = "m/s", doc = "assumed speed of the ball between two looks" },
  false_looks     = { 0.05,  range = { 0.001, 0.5 },           doc = "fraction of the looks that show something else" },
  mistaken        = { 0.002, range = { 0.0001, 0.2 },          doc = "fraction of the scenes in which the looks fit the wrong pose" },
  moved           = { 0.7,   range = { 0.1, 5 }, unit = "m",   doc = "distance by which the ball must move for another scene" },
  scene_time      = { 2.0,   range = { 0, 60 },  unit = "s",   doc = "shortest duration of a scene" },
  looks           = { 2,     range = { 1, 100 }, integer = true, doc = "number of looks at a scene that count fully; fewer count less" },
  seen_time       = { 1.0,   range = { 0.1, 10 }, unit = "s",  doc = "time for which a look at the ball counts" },
  trust_time      = { 10.0,  range = { 0.5, 120 }, unit = "s", doc = "time for which the reports of a teammate count after the last one" },
  most_certainty  = { 4.6,   range = { 0, 9.9 },               doc = "largest certainty of a teammate that is believed, in log-odds" },
}

local MOST_TEAMMATES = 10
local HIGHEST_PLAYER = 20
local FRESH = 0.1       -- s: age at which a look belongs to the present pose
local MOST_RELATION = 20.0

-- `ball`: where this robot saw it. `team`: what is known of each teammate, by its number. `relation` is the log-odds that
-- its belief and this robot's are on opposite sides.
local memory = keep { ball = { x = 0.0, y = 0.0, deviation = 0.0, at = -1000.0 }, team = {}, number = 0, evidence = 0.0 }

local team_evidence = {}

local function squared(value) return value * value end

--- Standard deviation of the position of a ball on the field, as a robot measures it.
---@param distance number m, of the ball from the robot
---@return number deviation m
function team_evidence.deviation(distance)
  local height = p.camera_height
  local radial = squared(p.elevation_noise * (height + distance * distance / height))
  local tangential = (squared(p.bearing_noise) + squared(p.rotation)) * distance * distance
  return math.sqrt(squared(p.position) + (radial + tangential) / 2)
end

-- The ball relative to the robot, by the application's detector, else by the field vision. `input` is read under another
-- name because a run without an application is not to be warned of a missing ball.
local values = nil
local function has_detector()
  if values == nil then
    values = false
    for name in pairs(input) do
      if name == "ball" then values = input end
    end
  end
  return values
end

local function look()
  local detector = has_detector()
  if detector then
    local is_seen = detector.valid.ball.position and detector.age.ball.position <= FRESH
    local ball = detector.ball.position
    if is_seen then return ball.x, ball.y end
  elseif seen.ball then
    return seen.ball_distance * math.cos(seen.ball_bearing), seen.ball_distance * math.sin(seen.ball_bearing)
  end
  return nil
end

local function update_ball()
  local x, y = look()
  if not x then return end
  local cosine, sine = math.cos(pose.rotation), math.sin(pose.rotation)
  local ball = memory.ball
  ball.x, ball.y = pose.x + cosine * x - sine * y, pose.y + sine * x + cosine * y
  ball.deviation = team_evidence.deviation(math.sqrt(x * x + y * y))
  ball.at = clock.time
end

--- Where this robot sees the ball on the field by its believed pose.
---@return table ball `x`, `y`, `deviation` (m) and `age` (s); nil: it was not seen lately
function team_evidence.ball()
  local ball = memory.ball
  local age = clock.time - ball.at
  if age > p.seen_time then return nil end
  return { x = ball.x, y = ball.y, deviation = ball.deviation, age = age }
end

-- Log-odds of the reflected place against the place itself, of one look.
local function log_odds(ball, report)
  local difference = p.ball_speed * math.abs(ball.age - report.age)
  local variance = squared(ball.deviation) + squared(report.deviation) + squared(difference)
  local direct = squared(report.x - ball.x) + squared(report.y - ball.y)
  local reflected = squared(report.x + ball.x) + squared(report.y + ball.y)
  local scale = 1.0 / (2.0 * math.pi * variance)
  local near = scale * math.exp(-direct / (2.0 * variance))
  local far = scale * math.exp(-reflected / (2.0 * variance))
  local anywhere = p.false_looks / (field.length * field.width)
  local right = 1.0 - p.false_looks - p.mistaken
  return math.log((right * far + p.mistaken * near + anywhere) / (right * near + p.mistaken * far + anywhere))
end

local function relation_of(mate)
  local scene = mate.sum / math.max(mate.looks, p.looks)
  return math.max(-MOST_RELATION, math.min(MOST_RELATION, mate.relation + scene))
end

local function begin_scene(mate, ball)
  mate.relation = relation_of(mate)
  mate.sum, mate.looks, mate.x, mate.y, mate.began = 0.0, 0, ball.x, ball.y, clock.time
end

local function compare(mate, ball, report)
  local has_moved = squared(ball.x - mate.x) + squared(ball.y - mate.y) > squared(p.moved)
  if mate.looks == 0 or has_moved and clock.time - mate.began >= p.scene_time then begin_scene(mate, ball) end
  mate.sum, mate.looks = mate.sum + log_odds(ball, report), mate.looks + 1
end

local function mate_of(sender, belief)
  local mate = memory.team[sender]
  if mate and mate.belief == belief then return mate end
  if not mate then
    if memory.number >= MOST_TEAMMATES then return nil end
    memory.number = memory.number + 1
  end
  mate = { relation = 0.0, sum = 0.0, looks = 0, x = 0.0, y = 0.0, began = 0.0, heard_at = 0.0, certainty = 0.0,
    belief = belief }
  memory.team[sender] = mate
  return mate
end

local function hear(sender, report, ball)
  if sender < 1 or sender > HIGHEST_PLAYER then return end
  local mate = mate_of(sender, report.belief)
  if not mate then return end
  mate.heard_at = clock.time
  mate.certainty = math.max(-p.most_certainty, math.min(p.most_certainty, report.certainty))
  if ball then compare(mate, ball, report) end
end

local function forget_silent_teammates()
  for sender = 1, HIGHEST_PLAYER do
    local mate = memory.team[sender]
    if mate and clock.time - mate.heard_at > p.trust_time then
      memory.team[sender] = nil
      memory.number = memory.number - 1
    end
  end
end

-- The teammate is right with the log-odds `certainty`; on the opposite side with the log-odds `relation`.
local function worth(mate)
  local relation, certainty = relation_of(mate), mate.certainty
  return math.log((math.exp(certainty + relation) + 1.0) / (math.exp(certainty) + math.exp(relation)))
end

-- All teammates are compared with this robot's view of the ball, which may show something else, so together they are bounded
-- by `mistaken`.
local function add_up()
  local sum = 0.0
  for sender = 1, HIGHEST_PLAYER do   -- not pairs(): the last bits of a sum depend on its order
    local mate = memory.team[sender]
    if mate then sum = sum + worth(mate) end
  end
  local most = math.log((1.0 - p.mistaken) / p.mistaken)
  memory.evidence = math.max(-most, math.min(most, sum))
end

--- Looks at the ball and listens to the teammates, once in each frame.
---@param is_certain_of_position boolean whether the believed pose or its reflection is right
function team_evidence.update(is_certain_of_position)
  if is_certain_of_position then update_ball() end
  local ball = nil
  for which = 1, team.heard() do
    local report = side_report.decode(team.text(which))
    if report then
      ball = ball or team_evidence.ball()
      hear(team.sender(which), report, ball)
    end
  end
  if memory.number > 0 then
    forget_silent_teammates()
    add_up()
  end
end

--- The evidence of all teammates for the mirrored pose.
---@return number log_odds
function team_evidence.evidence() return memory.evidence end

--- Why the evidence is what it is.
---@return string reason
function team_evidence.reason()
  if memory.number == 0 then return "no teammate reports the ball" end
  local compared = 0
  for _, mate in pairs(memory.team) do
    if mate.looks > 0 then compared = compared + 1 end
  end
  if compared == 0 then return "this robot does not see the ball" end
  return string.format("%d of %d teammates and this robot see the ball", compared, memory.number)
end

--- The believed pose was replaced by its reflection: what agreed before contradicts now.
function team_evidence.flip()
  local ball = memory.ball
  ball.x, ball.y = -ball.x, -ball.y
  for _, mate in pairs(memory.team) do
    mate.relation, mate.sum, mate.x, mate.y = -mate.relation, -mate.sum, -mate.x, -mate.y
  end
  memory.evidence = -memory.evidence
end

--- The side may have changed with a probability: what was counted is worth less.
---@param probability number 0 to 0.5
function team_evidence.weaken(probability)
  for _, mate in pairs(memory.team) do
    local likelihood = math.exp(-math.abs(relation_of(mate)))   -- of the less likely relation against the other one
    local weaker = math.log((1.0 - probability + probability * likelihood) / (probability + (1.0 - probability) * likelihood))
    mate.relation = relation_of(mate) < 0.0 and -weaker or weaker
    mate.sum, mate.looks = 0.0, 0
  end
  add_up()
end

--- Nothing that was seen before counts any more.
function team_evidence.forget()
  memory.team, memory.number, memory.evidence = {}, 0, 0.0
  memory.ball.at = -1000.0
end

return team_evidence
