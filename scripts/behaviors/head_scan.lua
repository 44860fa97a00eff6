--- Lets the head sweep from side to side, once over the walls of the room and once over the lines of the field, so that
--- room awareness and self-localization both see enough.

local p = param {
  width       = { 1.1,  range = { 0, 2.0 },      unit = "rad",   doc = "how far to turn the head to each side" },
  speed       = { 1.0,  range = { 0.1, 5.0 },    unit = "rad/s", doc = "how fast to turn the head" },
  wall_pitch  = { -0.1, range = { -0.6, 0.5 },   unit = "rad",   doc = "how far to look down while looking at the walls" },
  field_pitch = { 0.25, range = { -0.6, 0.5 },   unit = "rad",   doc = "how far to look down while looking at the field" },
  patience    = { 4.0,  range = { 0.5, 20.0 },   unit = "s",     doc = "after which time to turn back even if a side was not reached" },
}

local function look_left(pitch) return function() head.look(p.width, p[pitch], p.speed) end end
local function look_right(pitch) return function() head.look(-p.width, p[pitch], p.speed) end end

local function reached(side) return function() return math.abs(robot.head_yaw - side * p.width) < 0.05 end end

local function sweep(update, side, next_state)
  return {
    update = update,
    { next_state, when = reached(side), because = "the side is reached" },
    { next_state, after = "patience", because = "the side cannot be reached" },
  }
end

behavior "head_scan" {
  priority = 10,
  initial = "walls to the left",
  state "walls to the left" (sweep(look_left("wall_pitch"), 1, "walls to the right")),
  state "walls to the right" (sweep(look_right("wall_pitch"), -1, "field to the left")),
  state "field to the left" (sweep(look_left("field_pitch"), 1, "field to the right")),
  state "field to the right" (sweep(look_right("field_pitch"), -1, "walls to the left")),
}
