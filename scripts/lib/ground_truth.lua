--- Measures the error of the belief, for scenarios, because only scenarios can read the truth.

-- SPDX-License-Identifier: MIT

local walking = require "lib.walk"

local p = param {
  near    = { 0.5, range = { 0.05, 5 }, unit = "m",   doc = "largest error of position of a correct belief" },
  turned  = { 0.5, range = { 0.05, 3.2 }, unit = "rad", doc = "largest error of direction of a correct belief" },
}

local ground_truth = {}

--- Start pose beside the field before a match: level with its own penalty mark, facing the field.
---@return number x m
---@return number y m
---@return number rotation rad
function ground_truth.start_pose() return -field.penalty_mark_x, -field.width / 2 - 0.5, math.pi / 2 end

--- Places the robot at the start pose and sets it as initial pose.
function ground_truth.start()
  operator.put_down(ground_truth.start_pose())
  operator.set_initial_pose(ground_truth.start_pose())
end

--- Difference of the believed pose and the true pose.
---@return number distance m
---@return number turn rad, never negative
function ground_truth.error()
  local dx, dy = truth.x - pose.x, truth.y - pose.y
  return math.sqrt(dx * dx + dy * dy), math.abs(walking.normalize(truth.rotation - pose.rotation))
end

--- Whether both errors are small enough for a correct belief.
---@return boolean
function ground_truth.is_belief_right()
  local distance, turn = ground_truth.error()
  return distance <= p.near and turn <= p.turned
end

--- The error in words, for logs and verdicts.
---@return string
function ground_truth.error_in_words()
  local distance, turn = ground_truth.error()
  return string.format("%.2f m and %.0f degrees off", distance, math.deg(turn))
end

--- Ends the run; the verdict names the error of the belief.
---@param is_right boolean whether the run succeeds
function ground_truth.give_verdict(is_right)
  local judge = is_right and verdict.succeed or verdict.fail
  judge("in the end the belief is " .. ground_truth.error_in_words())
end

--- Whether the robot truly stands near a penalty mark.
---@param side number -1 for the mark of its own half, 1 for the other
---@param distance number m
---@return boolean
function ground_truth.is_on_mark(side, distance)
  local dx, dy = truth.x - side * field.penalty_mark_x, truth.y
  return dx * dx + dy * dy < distance * distance
end

--- Writes truth and belief to the log.
---@param what string description of the event
function ground_truth.note(what)
  log.info(string.format("%s: truth (%.2f, %.2f, %.0f deg), belief (%.2f, %.2f, %.0f deg)", what,
    truth.x, truth.y, math.deg(truth.rotation), pose.x, pose.y, math.deg(pose.rotation)))
end

return ground_truth
