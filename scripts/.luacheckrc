-- For luacheck. Generated from the declarations that make the bindings; do not edit.
-- `REORIENT_REGENERATE=1 ./test` regenerates it.
local function fields(...)
  local known = {}
  for _, name in ipairs { ... } do known[name] = {} end
  return { fields = known }
end

stds.reorient = { read_globals = {
  "assert", "error", "getmetatable", "ipairs", "next", "pairs", "pcall", "rawequal", "rawget", "rawlen", "rawset", "select", "setmetatable", "tonumber", "tostring", "type", "xpcall",
  math = fields("abs", "acos", "asin", "atan", "ceil", "cos", "deg", "exp", "floor", "fmod", "huge", "log", "max", "maxinteger", "min", "mininteger", "modf", "pi", "rad", "random", "sin", "sqrt", "tan", "tointeger", "type", "ult"),
  string = fields("byte", "char", "find", "format", "gmatch", "gsub", "len", "lower", "match", "rep", "reverse", "sub", "upper"),
  table = fields("concat", "insert", "move", "pack", "remove", "sort", "unpack"),
  action = { other_fields = true },
  args = {},
  behavior = {},
  behaviors = { other_fields = true },
  called = { other_fields = true },
  done = {},
  failed = {},
  input = { other_fields = true },
  keep = {},
  param = {},
  print = {},
  published = { other_fields = true },
  require = {},
  run = {},
  scenario = {},
  state = {},
  time_in_state = {},
  application = fields("set", "state", "argument", "report"),
  body = fields("claim", "holder", "rival"),
  chance = fields("between"),
  clock = fields("time", "step", "frame"),
  command = fields("flip_pose", "purge_reflection", "reset_orientation", "pause_training", "pause_evaluation", "state", "reason", "wait", "refusals"),
  confidence = fields("current", "opposite", "evidence", "raw_current", "raw_opposite", "goal_opponent", "goal_own", "coverage", "paired", "distinctiveness", "separability", "asymmetry", "age", "status", "can_tell", "visible_tiles"),
  evaluation = fields("active"),
  experimenter = fields("pick_up", "put_down", "put_ball", "push_over", "penalize", "set_game_state", "stop_game", "set_kick_off", "set_exposure_compensation", "change_light", "set_initial_pose", "tell_message", "half_time"),
  field = fields("length", "width", "border", "penalty_mark_x", "penalty_area_depth", "penalty_area_width", "goal_post_y", "corner_arc_radius", "center_circle_radius"),
  game = fields("sides_changed", "state", "stopped", "kick_off"),
  head = fields("look"),
  log = fields("info", "note"),
  motion = fields("get_up"),
  operator = fields("pick_up", "put_down", "put_ball", "push_over", "penalize", "set_game_state", "stop_game", "set_kick_off", "set_exposure_compensation", "change_light", "set_initial_pose", "tell_message", "half_time"),
  pose = fields("x", "y", "rotation", "known", "tracked", "cluster_weight", "reflected_weight", "recovery_probability"),
  robot = fields("posture", "posture_before", "posture_for", "time_since_disturbance", "undisturbed_for", "penalized", "may_walk", "head_yaw", "head_pitch", "head_reach", "torso_pitch_bias", "camera_pitch_bias", "bias_deviation", "walking", "speed", "turn_speed", "requested_speed", "head_moving", "head_speed", "can_walk", "can_get_up", "cruise"),
  seen = fields("goal_posts", "line_points", "intersections", "ball", "ball_distance", "ball_bearing"),
  team = fields("heard", "sender", "text", "send"),
  training = fields("seconds", "active"),
  truth = fields("x", "y", "rotation", "fallen", "carried", "ball_x", "ball_y", "score", "score_of_opponents"),
  verdict = fields("succeed", "fail"),
  views = fields("best_yaw", "best_score", "unknown_yaw", "unknown_score", "telling", "telling_worth", "unknown", "unknown_worth"),
  walk = fields("velocity", "stand"),
} }
stds.reorient_test = { read_globals = {
  expect = { other_fields = true },
  advance = {},
  advance_to = {},
  hear = {},
  load_behavior = {},
  load_interface = {},
  load_scenario = {},
  reload = {},
  replay = {},
  report_action = {},
  set_input = {},
  set_param = {},
  set_world = {},
  simulate = {},
  test = {},
  world_value = {},
} }

std = "reorient"
files["**/*_test.lua"].std = "reorient+reorient_test"
exclude_files = { "annotations", "**/annotations" }
max_line_length = 140
