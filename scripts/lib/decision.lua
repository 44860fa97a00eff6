--- Computes the threshold of the evidence from the permitted rate of wrong decisions. Evidence is given in log-odds: a
--- decision at 99 in 100 is wrong once in a hundred evaluations. All behaviors use the same threshold.

-- SPDX-License-Identifier: MIT

local p = param {
  false_flips  = { 0.02,  range = { 0.0001, 1000 }, unit = "1/h", doc = "permitted number of flips of a correct pose per hour" },
  looks        = { 240.0, range = { 1, 100000 },    unit = "1/h", doc = "number of independent evaluations per hour of a confirmed pose" },
  disturbances = { 5.0,   range = { 0.1, 10000 },   unit = "1/h", doc = "number of disturbances per hour that make the pose unconfirmed" },
  least        = { 2.0,   range = { 0, 20 },                      doc = "lower limit of the thresholds in log-odds" },
}

local decision = {}

local function log_odds(chances) return math.max(p.least, math.log(chances / p.false_flips)) end

--- The threshold for a confirmed pose.
---@return number log_odds
function decision.confirmed_threshold() return log_odds(p.looks) end

--- The threshold for an unconfirmed pose, for example after a disturbance.
---@return number log_odds
function decision.unconfirmed_threshold() return log_odds(p.disturbances) end

--- Former name of `confirmed_threshold`.
---@return number log_odds
function decision.in_peace() return decision.confirmed_threshold() end

--- Former name of `unconfirmed_threshold`.
---@return number log_odds
function decision.in_doubt() return decision.unconfirmed_threshold() end

--- Whether the evidence for the believed pose reaches the threshold.
---@return boolean
function decision.for_believed() return confidence.evidence < -decision.unconfirmed_threshold() end

--- Whether the evidence for either pose reaches the threshold.
---@return boolean
function decision.for_either() return math.abs(confidence.evidence) >= decision.unconfirmed_threshold() end

return decision
