--- How much evidence does it take to act on it? What people want is a robot that errs at most so often.
--- Evidence is told in log-odds: where it says 99 in 100, it is wrong once in a hundred times that it has a chance to be.
--- So what is asked for follows from how often that is. One place decides it for all behaviours.

-- SPDX-License-Identifier: MIT

local p = param {
  false_flips  = { 0.02,  range = { 0.0001, 1000 }, unit = "1/h", doc = "how many flips of a pose that was right are allowed in an hour" },
  looks        = { 240.0, range = { 1, 100000 },    unit = "1/h", doc = "how often in an hour of peace all of the evidence is replaced" },
  disturbances = { 5.0,   range = { 0.1, 10000 },   unit = "1/h", doc = "how often in an hour its pose is put in doubt" },
  least        = { 2.0,   range = { 0, 20 },                      doc = "log-odds that are asked for in any case" },
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
