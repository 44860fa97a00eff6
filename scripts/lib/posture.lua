--- Whether the robot lies or somebody has lifted it. Its feet alone do not tell: they carry no load either while it
--- falls and while it gets up. A behaviour that asks calls posture.watch() in each frame.

local p = param {
  upright = { 0.5, range = { 0, 5 }, unit = "s", doc = "how long after lying unloaded feet still belong to getting up" },
}

local memory = keep { down_at = -1000.0 }

local posture = {}

local function is_getting_up() return clock.time - memory.down_at < p.upright end

--- Remembers; stands in the machine's `update`.
function posture.watch()
  if robot.fallen or (robot.carried and is_getting_up()) then memory.down_at = clock.time end
end

--- Whether the robot lies or has not yet got up: its feet do not carry it.
function posture.is_down() return robot.fallen or (robot.carried and is_getting_up()) end

--- Whether the robot hangs in somebody's hands. At the beginning of a fall this is true for half a second, too.
function posture.is_lifted() return robot.carried and not posture.is_down() end

return posture
