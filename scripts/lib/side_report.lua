--- The message in which a robot tells its teammates where it sees the ball, and how sure it is of its own side. It has the
--- form `side X Y DEVIATION AGE CERTAINTY BELIEF`, as in `side 1.20 -0.35 0.21 0.10 4.3 2`.

-- SPDX-License-Identifier: MIT

local side_report = {}

local FORM = "side %.2f %.2f %.2f %.2f %.1f %d"
local PATTERN = "^side (%-?%d+%.%d+) (%-?%d+%.%d+) (%d+%.%d+) (%d+%.%d+) (%-?%d+%.%d+) (%d+)$"
local LONGEST = 60           -- bytes of a valid message
local OUTSIDE = 1.0          -- m beyond the carpet at which a ball may still be reported
local LEAST_DEVIATION, MOST_DEVIATION = 0.05, 5.0   -- m
local MOST_AGE = 5.0         -- s
local MOST_CERTAINTY = 9.9   -- log-odds
local MOST_BELIEFS = 1000000

local function clamp(value, least, most) return math.max(least, math.min(most, value)) end

local function is_on_carpet(x, y)
  local margin = field.border + OUTSIDE
  return math.abs(x) <= field.length / 2 + margin and math.abs(y) <= field.width / 2 + margin
end

--- The text of a report. Values outside of the ranges are limited.
---@param ball table position `x`, `y` on the field by the believed pose (m), `deviation` (m) and `age` (s)
---@param certainty number log-odds that the believed side is right, from the robot's own evidence
---@param belief integer number that changes when the robot's side may have changed
---@return string text
function side_report.encode(ball, certainty, belief)
  return string.format(FORM, ball.x, ball.y, clamp(ball.deviation, LEAST_DEVIATION, MOST_DEVIATION),
    clamp(ball.age, 0.0, MOST_AGE), clamp(certainty, -MOST_CERTAINTY, MOST_CERTAINTY), belief % MOST_BELIEFS)
end

--- Reads a report.
---@param text string message of a teammate
---@return table report `x`, `y`, `deviation` (m), `age` (s), `certainty` (log-odds), `belief`; nil: the text is not a valid report
function side_report.decode(text)
  if #text > LONGEST then return nil end
  local x, y, deviation, age, certainty, belief = text:match(PATTERN)
  if not x then return nil end
  local report = { x = tonumber(x), y = tonumber(y), deviation = tonumber(deviation), age = tonumber(age),
    certainty = tonumber(certainty), belief = math.tointeger(tonumber(belief)) }
  local is_valid = is_on_carpet(report.x, report.y) and report.deviation >= LEAST_DEVIATION and
    report.deviation <= MOST_DEVIATION and report.age <= MOST_AGE and math.abs(report.certainty) <= MOST_CERTAINTY and
    report.belief and report.belief < MOST_BELIEFS
  return is_valid and report or nil
end

return side_report
