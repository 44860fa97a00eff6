--- Where the ball lies on the field, by the application's detector and the believed pose, and whether it is in play.

-- SPDX-License-Identifier: MIT

local ball_library = {}

--- Whether the position of the ball is known: seen not long ago.
---@return boolean
function ball_library.is_known() return input.valid.ball.position end

--- Whether the referee lets the robots play, or there is no referee.
---@return boolean
function ball_library.is_in_play() return game.state == "playing" or game.state == "unknown" end

--- The position on the field. Call it only while the ball is known.
---@return number x m, toward the opponents' goal
---@return number y m, to the left
function ball_library.on_field()
  local ball = input.ball.position
  local cosine, sine = math.cos(pose.rotation), math.sin(pose.rotation)
  return pose.x + cosine * ball.x - sine * ball.y, pose.y + sine * ball.x + cosine * ball.y
end

return ball_library
