--- How much evidence does it take to act on it? What people want is a robot that errs at most so often.
--- Evidence is told in log-odds: where it says 99 in 100, it is wrong once in a hundred times that it has a chance to be.
--- So what is asked for follows from how often that is. One place decides it for all behaviours.

-- SPDX-License-Identifier: MIT

local p = param {
  false_flips  = { 0.02,  range = { 0.0001, 1000 }, unit = "1/h", doc = "permitted number of flips of a correct pose per hour" },
  looks        = { 240.0, range = { 1, 100000 },    unit = "1/h", doc = "number of independent evaluations per hour of a confirmed pose" },
  disturbances = { 5.0,   range = { 0.1, 10000 },   unit = "1/h", doc = "number of disturbances per hour that make the pose unconfirmed" },
  least        = { 2.0,   range = { 0, 20 },                      doc = "lower limit of the thresholds in log-odds" },
}

local decision = {}

local function log_odds(chances) return math.max(p.least, math.log(chances / p.false_flips)) end

--- While nothing has happened to the robot that would put its pose in doubt.
---@return number log_odds
function decision.in_peace() return log_odds(p.looks) end

--- While it is not known which of the two poses is the right one: after a disturbance, each of them may be.
---@return number log_odds
function decision.in_doubt() return log_odds(p.disturbances) end

--- Whether the room says that the believed pose is right.
---@return boolean
function decision.for_believed() return confidence.evidence < -decision.in_doubt() end

--- Whether the room says enough of either pose to act on it.
---@return boolean
function decision.for_either() return math.abs(confidence.evidence) >= decision.in_doubt() end

return decision
