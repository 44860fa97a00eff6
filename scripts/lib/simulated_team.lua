--- Teammates for scenarios: they stand around the ball, follow it if it rolls away, see it with errors, and send where they
--- believe it to be, with the message of lib.side_report. The messages are lost and late as in a game of the simulator. The
--- errors of the ball are those of the simulator's detector (`ball_sensor`); those of the poses are larger than the errors
--- that a robot of the simulator has.

-- SPDX-License-Identifier: MIT

local side_report = require "lib.side_report"
local team_evidence = require "lib.team_evidence"

local p = param {
  bearing_noise   = { 0.02,  range = { 0, 0.5 }, unit = "rad", doc = "standard deviation of the measured direction of the ball" },
  elevation_noise = { 0.008, range = { 0, 0.2 }, unit = "rad", doc = "standard deviation of the angle of the ball below the horizon" },
  missed          = { 0.1,   range = { 0, 1 },                 doc = "fraction of the reports in which the ball is not detected" },
  seen_range      = { 5.0,   range = { 0.1, 50 }, unit = "m",  doc = "largest distance at which a teammate sees the ball" },
  position        = { 0.15,  range = { 0, 2 },   unit = "m",   doc = "standard deviation of a teammate's believed position" },
  rotation        = { 0.05,  range = { 0, 1 },   unit = "rad", doc = "standard deviation of a teammate's believed direction" },
  period          = { 0.5,   range = { 0.1, 10 }, unit = "s",  doc = "time between the reports of a teammate" },
  loss            = { 0.1,   range = { 0, 1 },                 doc = "fraction of the messages that are lost" },
  delay           = { 0.05,  range = { 0, 10 },  unit = "s",   doc = "shortest time until a message arrives" },
  delay_spread    = { 0.05,  range = { 0, 10 },  unit = "s",   doc = "largest time that is added at random to the delay" },
  nearest         = { 1.0,   range = { 0, 10 },  unit = "m",   doc = "smallest distance of a teammate from the ball at the start" },
  farthest        = { 4.0,   range = { 0.1, 20 }, unit = "m",  doc = "distance from the ball above which a teammate walks toward it" },
  speed           = { 0.2,   range = { 0, 2 },   unit = "m/s", doc = "speed of a teammate that walks" },
}

local CAMERA_HEIGHT = 0.5     -- m, above the ball
local FIRST_NUMBER = 2        -- on the jersey; the robot of the scenario is 1
local MOST_ATTEMPTS = 100
local MARGIN = 0.3            -- m, of a teammate from the lines

local memory = keep { mates = {}, underway = {} }

local simulated_team = {}

--- A random number with the normal distribution.
---@param deviation number standard deviation
---@return number value
function simulated_team.normal(deviation)
  local radius = math.sqrt(-2.0 * math.log(1.0 - chance.between(0.0, 1.0)))
  return deviation * radius * math.cos(chance.between(-math.pi, math.pi))
end

--- A random place on the field.
---@param x number m, center of the ring
---@param y number m
---@param nearest number m, inner radius of the ring
---@param farthest number m, outer radius of the ring
---@param margin number m, smallest distance from the lines
---@return number x m
---@return number y m
function simulated_team.place_around(x, y, nearest, farthest, margin)
  local most_x, most_y = field.length / 2 - margin, field.width / 2 - margin
  local found_x, found_y = 0.0, 0.0
  for _ = 1, MOST_ATTEMPTS do
    local direction, distance = chance.between(-math.pi, math.pi), chance.between(nearest, farthest)
    found_x, found_y = x + distance * math.cos(direction), y + distance * math.sin(direction)
    if math.abs(found_x) <= most_x and math.abs(found_y) <= most_y then break end
  end
  return math.max(-most_x, math.min(most_x, found_x)), math.max(-most_y, math.min(most_y, found_y))
end

--- Places the teammates around the ball.
---@param number integer of teammates
---@param mirrored integer how many of them, the first ones, believe the mirrored pose
---@param certainty number log-odds of their own side that all of them report
function simulated_team.place(number, mirrored, certainty)
  memory.mates, memory.underway = {}, {}
  for which = 1, number do
    local x, y = simulated_team.place_around(truth.ball_x, truth.ball_y, p.nearest, p.farthest, MARGIN)
    memory.mates[which] = {
      x = x, y = y, certainty = certainty, side = which <= mirrored and -1.0 or 1.0,
      error_x = simulated_team.normal(p.position), error_y = simulated_team.normal(p.position),
      error_rotation = simulated_team.normal(p.rotation), next_at = clock.time + chance.between(0.0, p.period),
    }
  end
end

-- The ball as the teammate measures it, on the field by its belief; nothing: it does not see the ball.
local function seen_by(mate)
  local dx, dy = truth.ball_x - mate.x, truth.ball_y - mate.y
  local distance = math.sqrt(dx * dx + dy * dy)
  local angle = math.atan(CAMERA_HEIGHT, distance) + simulated_team.normal(p.elevation_noise)
  local direction = math.atan(dy, dx) + simulated_team.normal(p.bearing_noise) + mate.error_rotation
  local is_missed = chance.between(0.0, 1.0) < p.missed
  if is_missed or distance > p.seen_range then return nil end
  local measured = math.min(1.5 * p.seen_range, CAMERA_HEIGHT / math.tan(math.max(0.01, angle)))
  return {
    x = mate.side * (mate.x + mate.error_x + measured * math.cos(direction)),
    y = mate.side * (mate.y + mate.error_y + measured * math.sin(direction)),
    deviation = team_evidence.deviation(measured), age = 0.0,
  }
end

local function send(which, mate)
  mate.next_at = mate.next_at + p.period
  local ball = seen_by(mate)
  local is_lost = chance.between(0.0, 1.0) < p.loss
  local due = clock.time + p.delay + chance.between(0.0, 1.0) * p.delay_spread
  if not ball or is_lost then return end
  table.insert(memory.underway,
    { due = due, sender = FIRST_NUMBER + which - 1, text = side_report.encode(ball, mate.certainty, 0) })
end

local function follow_ball(mate)
  local dx, dy = truth.ball_x - mate.x, truth.ball_y - mate.y
  local distance = math.sqrt(dx * dx + dy * dy)
  if distance <= p.farthest then return end
  mate.x = mate.x + p.speed * clock.step * dx / distance
  mate.y = mate.y + p.speed * clock.step * dy / distance
end

--- Moves the teammates, sends and delivers messages, once in each frame.
function simulated_team.update()
  for which, mate in ipairs(memory.mates) do
    follow_ball(mate)
    if clock.time >= mate.next_at then send(which, mate) end
  end
  for which = #memory.underway, 1, -1 do
    local message = memory.underway[which]
    if clock.time >= message.due then
      operator.tell_message(message.sender, message.text)
      table.remove(memory.underway, which)
    end
  end
end

return simulated_team
