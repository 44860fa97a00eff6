---@meta
-- Functions and fields of scripts, for the Lua language server. Generated from the declarations that make the
-- bindings, and from the libraries' doc comments; do not edit. `REORIENT_REGENERATE=1 ./test` regenerates it.

---@class reorient.State
---@field priority? number|table
---@field initial? string
---@field history? boolean
---@field publishes? string
---@field ends? "done"|"failed"
---@field common? table[]
---@field behaviors? string[]
---@field room? string
---@field hall_seed? integer
---@field field? string
---@field interface? string
---@field enter? fun()
---@field update? fun()
---@field exit? fun()
---@field [integer] table

---Time.
---@class reorient.clock
---@field time number s, time since the robot was switched on
---@field step number s, time since the previous frame
---@field frame number number of this frame
clock = {}

---State of the game as the referee reports it.
---@class reorient.game
---@field sides_changed boolean whether the teams have changed sides; a change rotates the field's axes by 180 degrees
---@field state "unknown"|"initial"|"ready"|"set"|"playing"|"finished"|"standby" state of the game as named in the rules; unknown: the referee has not reported a state
---@field stopped boolean whether all robots must stand still; requests of behaviors to head and legs have no effect then
---@field kick_off "nobody"|"ours"|"theirs" team that takes the kick-off or the free kick; it stays set while the ball is in play, until the next one
game = {}

---The robot's own body.
---@class reorient.robot
---@field posture "upright"|"falling"|"lying"|"getting_up"|"lifted" current posture of the robot
---@field posture_before "upright"|"falling"|"lying"|"getting_up"|"lifted" previous posture
---@field posture_for number s, time since the posture changed
---@field time_since_disturbance number s, time since the last fall, lift or penalty; 0 while the robot is not upright or is penalized
---@field undisturbed_for number s, former name of robot.time_since_disturbance
---@field penalized boolean whether the robot is penalized by the referee
---@field may_walk boolean whether the rules permit walking: not penalized, and the game is ready, playing or unknown; otherwise the robot stands, and walk requests have no effect
---@field head_yaw number rad, measured yaw of the head, positive to the left
---@field head_pitch number rad, measured pitch of the head, positive downward
---@field head_reach number rad, largest yaw of the head to either side
---@field torso_pitch_bias number rad, estimated error of the torso's measured pitch, from the lines of the field, positive forward
---@field camera_pitch_bias number rad, estimated error of the upper camera's pitch in its mounting, positive downward
---@field bias_deviation number rad, standard deviation of the sum of torso_pitch_bias and camera_pitch_bias
---@field walking boolean whether the robot walks or turns: it was requested, or the odometry measures it
---@field speed number m/s, measured speed along the ground, smoothed over 0.3 s
---@field turn_speed number rad/s, measured speed of rotation, positive to the left, smoothed over 0.3 s
---@field requested_speed number m/s, speed of the walk request that the robot got in the previous frame
---@field head_moving boolean whether the head turns faster than 0.1 rad/s
---@field head_speed number rad/s, measured speed of the faster joint of the neck, smoothed over 0.1 s
---@field can_walk boolean whether this body can walk
---@field can_get_up boolean whether this body can get up after a fall
---@field cruise number m/s, walking speed of this body over long distances; 0: it cannot walk
robot = {}

---The believed pose in the field's frame: x toward the opponents' goal, y to the left.
---@class reorient.pose
---@field x number m, position toward the opponents' goal
---@field y number m, position to the left
---@field rotation number rad, direction: 0 toward the opponents' goal, positive to the left
---@field known boolean whether an initial pose was set, or a flip or purge has confirmed the pose; false after a reset
---@field tracked boolean whether the observed field has fitted the believed pose or the mirrored pose for some seconds; false while the robot searches for its position
---@field cluster_weight number fraction of the pose particles' weight in the believed cluster
---@field reflected_weight number fraction of the pose particles' weight near the mirrored pose
---@field recovery_probability number how much worse than usual the pose particles fit the observed field, from 0 (as usual) to 1 (not at all)
pose = {}

---Results of room awareness for the believed pose, from 0 to 1 unless a unit is given.
---@class reorient.confidence
---@field current number smoothed confidence in the believed pose
---@field opposite number smoothed confidence in the mirrored pose
---@field evidence number log-odds, evidence of the room for the mirrored pose: 4.6 means 99 in 100, 0 means undecided, negative values support the believed pose
---@field raw_current number confidence in the believed pose from this frame alone
---@field raw_opposite number confidence in the mirrored pose from this frame alone
---@field goal_opponent number confidence that the robot looks at the wall behind the opponents' goal
---@field goal_own number confidence that the robot looks at the wall behind its own goal
---@field coverage number fraction of the wall whose tiles are trained enough for the comparison
---@field paired number fraction of the wall that is trained enough together with the mirrored tiles on the opposite side
---@field distinctiveness number how much the room differs from itself rotated by 180 degrees; 0: no difference
---@field separability number probability that the room distinguishes a pose from its mirrored pose; below 0.5 (room_status.separability) the room counts as symmetric
---@field asymmetry number former name of confidence.separability
---@field age number s, time for which known tiles were in view since the confidences restarted: after a lift, a fall, a penalty, a set pose, a flip or a jump of the belief
---@field status "usable"|"off"|"resting"|"unlearned"|"symmetric"|"lost"|"fresh" whether the confidences are valid for the believed pose, or the reason why not
---@field can_tell boolean whether the room can distinguish the believed pose from the mirrored pose: learned, not symmetric, evaluated; true while confidence.status is usable, lost or fresh; right after a fall or a lift it is resting
---@field visible_tiles number number of tiles of the wall that were used in this frame
confidence = {}

---Head directions with the most information while the body does not turn.
---@class reorient.views
---@field best_yaw number rad, yaw of the head at which the room differs most from itself rotated by 180 degrees
---@field best_score number tiles, difference of the room from itself rotated by 180 degrees at best_yaw, in fully counted tiles; 0: no tile is in reach
---@field unknown_yaw number rad, yaw of the head at which most tiles are not learned yet
---@field unknown_score number tiles, number of tiles at unknown_yaw that are not learned yet
---@field telling number rad, former name of views.best_yaw
---@field telling_worth number tiles, former name of views.best_score
---@field unknown number rad, former name of views.unknown_yaw
---@field unknown_worth number tiles, former name of views.unknown_score
views = {}

---The background model of the room.
---@class reorient.training
---@field seconds number s, total training time of the background model, including the training of a loaded model
---@field active boolean whether the background model was trained in the previous frame
training = {}

---The comparison of the view with the background model.
---@class reorient.evaluation
---@field active boolean whether the confidences were evaluated in the previous frame
evaluation = {}

---Observations of the field in this frame.
---@class reorient.seen
---@field goal_posts number number of goal posts in view
---@field line_points number number of points on field lines in view
---@field intersections number number of line intersections in view
---@field ball boolean whether a ball is in view
---@field ball_distance number m, distance of the ball; 0 if no ball is in view
---@field ball_bearing number rad, direction of the ball, positive to the left; 0 if no ball is in view
seen = {}

---Dimensions of the field, measured between centers of lines; the origin is the center of the field.
---@class reorient.field
---@field length number m, distance between the goal lines
---@field width number m, distance between the touchlines
---@field border number m, width of the carpet outside the lines
---@field penalty_mark_x number m, distance of both penalty marks from the center
---@field penalty_area_depth number m, depth of the penalty area from the goal line
---@field penalty_area_width number m, width of the penalty area along the goal line
---@field goal_post_y number m, distance of a goal post from the middle of the goal
---@field corner_arc_radius number m, radius of the quarter circles at the corners; 0: the field has none
---@field center_circle_radius number m, radius of the center circle
field = {}

---The true pose of the robot, only available from a simulator or a tracking camera, and the true ball, only available from a simulator that has one.
---@class reorient.truth
---@field x number m, position toward the opponents' goal
---@field y number m, position to the left
---@field rotation number rad, direction: 0 toward the opponents' goal, positive to the left
---@field fallen boolean whether the robot truly lies on the ground
---@field carried boolean whether the robot is truly in the air
---@field ball_x number m, true position of the ball toward the opponents' goal
---@field ball_y number m, true position of the ball to the left
---@field score number number of times the ball rolled into the opponents' goal
---@field score_of_opponents number number of times the ball rolled into the own goal
truth = {}

---@class reorient.command
command = {}

---Requests that the mirrored pose replace the believed pose in this frame.
function command.flip_pose() end

---Requests that the particles near the mirrored pose be removed in this frame.
function command.purge_reflection() end

---Requests in this frame that the orientation become unknown; the position does not change.
function command.reset_orientation() end

---Pauses the training of the background model until the calling state is left.
function command.pause_training() end

---Pauses the evaluation of the room until the calling state is left.
function command.pause_evaluation() end

---What became of this behavior's latest command of a kind, such as "flip_pose": idle (never requested), pending (requested in this frame), granted or refused.
---@param command string
---@return string
function command.state(command) end

---Why it was refused; empty if it was not.
---@param command string
---@return string
function command.reason(command) end

---Time until such a command is not too soon any more (s): after one was granted to any behavior, the same one is refused for some time.
---@param command string
---@return number
function command.wait(command) end

---How often this behavior's commands of a kind were refused since the latest one that was granted.
---@param command string
---@return integer
function command.refusals(command) end

---@class reorient.head
head = {}

---Turns the head to these angles (rad, positive left and downward) at a speed (rad/s). Valid for one frame.
---@param yaw number
---@param pitch number
---@param speed? number
function head.look(yaw, pitch, speed) end

---@class reorient.walk
walk = {}

---Walks with this velocity (m/s, m/s, rad/s to the left). Valid for one frame.
---@param forward number
---@param left number
---@param turn number
function walk.velocity(forward, left, turn) end

---Stands still; counts as a walk request. Valid for one frame.
function walk.stand() end

---@class reorient.motion
motion = {}

---Gets up after a fall. Valid for one frame.
function motion.get_up() end

---@class reorient.body
body = {}

---Claims a part of the body, such as "legs", without moving it: behaviors with a smaller priority do not get it. Valid for one frame.
---@param part string
function body.claim(part) end

---Name of the behavior that had the part in the last frame; empty if none had it.
---@param part string
---@return string
function body.holder(part) end

---Name of the behavior that had the part in the last frame although this one requested it, too; empty if this one was not refused.
---@param part string
---@return string
function body.rival(part) end

---@class reorient.team
team = {}

---Number of messages received from teammates in this frame.
---@return integer
function team.heard() end

---Player number of the sender of this message (1 is the first message).
---@param which integer
---@return integer
function team.sender(which) end

---Text of this message (1 is the first message): unchanged bytes, at most 240.
---@param which integer
---@return string
function team.text(which) end

---Sends a message of at most 240 bytes to the teammates. The team's own program transmits it.
---@param text string
function team.send(text) end

---@class reorient.log
log = {}

---Writes a line to the run's log, with time and state.
---@param text string
function log.info(text) end

---Writes a line to the run's log and marks it as a note, which can be searched for in a recording.
---@param text string
function log.note(text) end

---Seconds since the calling state was entered.
---@return number
function time_in_state() end

---@class reorient.operator
operator = {}

---Lifts the robot.
function operator.pick_up() end

---Places the robot at this pose (m, m, rad), upright and standing.
---@param x number
---@param y number
---@param rotation number
function operator.put_down(x, y, rotation) end

---Places the ball at this position (m), at rest. No effect without a ball.
---@param x number
---@param y number
function operator.put_ball(x, y) end

---Makes the robot fall.
function operator.push_over() end

---Penalizes the robot, or ends the penalty.
---@param penalized boolean
function operator.penalize(penalized) end

---Sets the state of the game: initial, ready, set, playing, finished, standby or unknown.
---@param state string
function operator.set_game_state(state) end

---Stops all motion of the robots, or permits it again.
---@param stopped boolean
function operator.stop_game(stopped) end

---Sets the team that kicks off next: one of the values of game.kick_off.
---@param side string
function operator.set_kick_off(side) end

---Changes the hall's light relative to the camera's exposure, in powers of two.
---@param stops number
function operator.set_exposure_compensation(stops) end

---Changes the light as set by the parameters `light`.
function operator.change_light() end

---Sets the initial pose (m, m, rad).
---@param x number
---@param y number
---@param rotation number
function operator.set_initial_pose(x, y, rotation) end

---Sends the robot a message of a teammate, at most 240 bytes.
---@param sender integer
---@param text string
function operator.tell_message(sender, text) end

---@class reorient.application
application = {}

---Sets values of the application, which the scenario plays, as in { ball = { x = 1.0, seen = true } }.
---@param values table
function application.set(values) end

---State of an action's latest start: idle, requested, running, done or failed.
---@param action string
---@return string
function application.state(action) end

---An argument of an action's latest start.
---@param action string
---@param argument string
---@return any
function application.argument(action, argument) end

---Reports that the latest start of an action is running, done or failed, with a reason.
---@param action string
---@param state string
---@param reason? string
function application.report(action, state, reason) end

---Signals that the teams change sides. The robot stays in place, and from then on all poses are in the axes of the new half.
function operator.half_time() end

---@class reorient.chance
chance = {}

---A random number, at least low and less than high, from the run's seed.
---@param low number
---@param high number
---@return number
function chance.between(low, high) end

---@class reorient.verdict
verdict = {}

---Ends the run as succeeded, with a reason.
---@param text string
function verdict.succeed(text) end

---Ends the run as failed, with a reason.
---@param text string
function verdict.fail(text) end

---@deprecated
---@type reorient.operator
experimenter = operator

do
---Where the ball lies on the field, by the application's detector and the believed pose, and whether it is in play.
---@class lib.ball
local library = {}

--- Whether the position of the ball is known: seen not long ago.
---@return boolean
function library.is_known() end

--- Whether the referee lets the robots play, or there is no referee.
---@return boolean
function library.is_in_play() end

--- The position on the field. Call it only while the ball is known.
---@return number x m, toward the opponents' goal
---@return number y m, to the left
function library.on_field() end
end

do
---Computes the threshold of the evidence from the permitted rate of wrong decisions. Evidence is given in log-odds: a decision at 99 in 100 is wrong once in a hundred evaluations. All behaviors use the same threshold.
---@class lib.decision
local library = {}

--- The threshold for a confirmed pose.
---@return number log_odds
function library.confirmed_threshold() end

--- The threshold for an unconfirmed pose, for example after a disturbance.
---@return number log_odds
function library.unconfirmed_threshold() end

--- Former name of `confirmed_threshold`.
---@return number log_odds
function library.in_peace() end

--- Former name of `unconfirmed_threshold`.
---@return number log_odds
function library.in_doubt() end

--- Whether the evidence for the believed pose reaches the threshold.
---@return boolean
function library.for_believed() end

--- Whether the evidence for either pose reaches the threshold.
---@return boolean
function library.for_either() end
end

do
---Looks at a point on the field: with the head within the reach of the neck, otherwise by turning the body, too.
---@class lib.gaze
local library = {}

--- Angle by which the head must turn to look straight at a point of the field.
---@param x number m
---@param y number m
---@return number angle rad, never negative
function library.angle_to(x, y) end

--- Whether the robot looks at a point of the field, by the believed pose.
---@param x number m
---@param y number m
---@return boolean
function library.is_at(x, y) end

--- Looks at a point of the field for one frame; the body turns if the neck alone cannot reach it, otherwise it stands.
---@param x number m
---@param y number m
function library.at(x, y) end
end

do
---Measures the error of the belief, for scenarios, because only scenarios can read the truth.
---@class lib.ground_truth
local library = {}

--- Start pose beside the field before a match: level with its own penalty mark, facing the field.
---@return number x m
---@return number y m
---@return number rotation rad
function library.start_pose() end

--- Places the robot at the start pose and sets it as initial pose.
function library.start() end

--- Difference of the believed pose and the true pose.
---@return number distance m
---@return number turn rad, never negative
function library.error() end

--- Whether both errors are small enough for a correct belief.
---@return boolean
function library.is_belief_right() end

--- The error in words, for logs and verdicts.
---@return string
function library.error_in_words() end

--- Ends the run; the verdict names the error of the belief.
---@param is_right boolean whether the run succeeds
function library.give_verdict(is_right) end

--- Whether the robot truly stands near a penalty mark.
---@param side number -1 for the mark of its own half, 1 for the other
---@param distance number m
---@return boolean
function library.is_on_mark(side, distance) end

--- Writes truth and belief to the log.
---@param what string description of the event
function library.note(what) end
end

do
---The evidence for the mirrored pose, as the sum of separately reported parts: the room, the ball as the team sees it, the referee's rule that robots are in their own half before a kick-off, and the time since the side was last certain. Each part is in log-odds; positive values support the mirrored pose. Only the room counts in a run without the behavior team_side.
---@class lib.side
local library = {}

--- Whether more than the room counts: the behavior team_side runs.
---@return boolean
function library.is_extended() end

--- The parts of the evidence, each in log-odds.
---@return number room
---@return number team
---@return number rule
---@return number time
function library.parts() end

--- The sum of the parts: 4.6 means 99 in 100 for the mirrored pose, negative values support the believed pose.
---@return number log_odds
function library.evidence() end

--- The sum of the parts beside the room.
---@return number log_odds
function library.evidence_beside_room() end

--- Whether a part can tell the side, and the parts do not contradict each other.
---@return boolean
function library.can_tell() end

--- How sure the robot is that its believed side is right, without what the team says.
---@return number log_odds
---@return integer belief number that changes when its side may have changed
function library.own_certainty() end

--- All parts with their reasons, for a log.
---@return string reason
function library.reason() end

--- Updates the parts, once in each frame.
function library.update() end
end

do
---The message in which a robot tells its teammates where it sees the ball, and how sure it is of its own side. It has the form `side X Y DEVIATION AGE CERTAINTY BELIEF`, as in `side 1.20 -0.35 0.21 0.10 4.3 2`.
---@class lib.side_report
local library = {}

--- The text of a report. Values outside of the ranges are limited.
---@param ball table position `x`, `y` on the field by the believed pose (m), `deviation` (m) and `age` (s)
---@param certainty number log-odds that the believed side is right, from the robot's own evidence
---@param belief integer number that changes when the robot's side may have changed
---@return string text
function library.encode(ball, certainty, belief) end

--- Reads a report.
---@param text string message of a teammate
---@return table report `x`, `y`, `deviation` (m), `age` (s), `certainty` (log-odds), `belief`; nil: the text is not a valid report
function library.decode(text) end
end

do
---Teammates for scenarios: they stand around the ball, follow it if it rolls away, see it with errors, and send where they believe it to be, with the message of lib.side_report. The messages are lost and late as in a game of the simulator. The errors of the ball are those of the simulator's detector (`ball_sensor`); those of the poses are larger than the errors that a robot of the simulator has.
---@class lib.simulated_team
local library = {}

--- A random number with the normal distribution.
---@param deviation number standard deviation
---@return number value
function library.normal(deviation) end

--- A random place on the field.
---@param x number m, center of the ring
---@param y number m
---@param nearest number m, inner radius of the ring
---@param farthest number m, outer radius of the ring
---@param margin number m, smallest distance from the lines
---@return number x m
---@return number y m
function library.place_around(x, y, nearest, farthest, margin) end

--- Places the teammates around the ball.
---@param number integer of teammates
---@param mirrored integer how many of them, the first ones, believe the mirrored pose
---@param certainty number log-odds of their own side that all of them report
function library.place(number, mirrored, certainty) end

--- Moves the teammates, sends and delivers messages, once in each frame.
function library.update() end
end

do
---The evidence of ball and team for the mirrored pose. A robot whose belief is mirrored sees the ball at the mirrored place. So each report of a teammate is compared with where this robot sees the ball, and with the reflection of that place. The errors of both are normally distributed, and some reports show something else. Looks at one scene share most of their errors, so they count once: another scene begins when the ball has moved. A single look may be false, so it counts less than two. A teammate may be mirrored itself, so its reports are never worth more than its own certainty.
---@class lib.team_evidence
local library = {}

--- Standard deviation of the position of a ball on the field, as a robot measures it.
---@param distance number m, of the ball from the robot
---@return number deviation m
function library.deviation(distance) end

--- Where this robot sees the ball on the field by its believed pose.
---@return table ball `x`, `y`, `deviation` (m) and `age` (s); nil: it was not seen lately
function library.ball() end

--- Looks at the ball and listens to the teammates, once in each frame.
---@param is_certain_of_position boolean whether the believed pose or its reflection is right
function library.update(is_certain_of_position) end

--- The evidence of all teammates for the mirrored pose.
---@return number log_odds
function library.evidence() end

--- Why the evidence is what it is.
---@return string reason
function library.reason() end

--- The believed pose was replaced by its reflection: what agreed before contradicts now.
function library.flip() end

--- The side may have changed with a probability: what was counted is worth less.
---@param probability number 0 to 0.5
function library.weaken(probability) end

--- Nothing that was seen before counts any more.
function library.forget() end
end

do
---Walks to a point on the field by the believed pose.
---@class lib.walk
local library = {}

--- The same direction in (-pi, pi].
---@param angle number rad
---@return number angle rad
function library.normalize(angle) end

--- Distance and bearing of a point on the field from the robot.
---@param x number m
---@param y number m
---@return number distance m
---@return number bearing rad, positive to the left of straight ahead
function library.distance_and_bearing(x, y) end

--- Whether the robot believes that it stands near a point.
---@param x number m
---@param y number m
---@param distance number m
---@return boolean
function library.is_near(x, y, distance) end

--- Walks toward a point for one frame; there it turns to `rotation` if given.
---@param x number m
---@param y number m
---@param rotation? number rad
---@return boolean has_arrived
function library.walk_to(x, y, rotation) end

--- Turns on the spot for one frame.
---@param speed number rad/s, to the left
function library.turn(speed) end
end

---Declares parameters with default, range, unit and description. `{ true, doc = ... }` is a switch, `{ "slow", choices = { "slow", "fast" }, doc = ... }` is a choice, and `integer = true` permits only whole numbers. Returns a read-only table of the current values. The full name of a parameter is the name of the file, a dot, and its name.
---@param declarations table<string, table>
---@return table<string, any> values
function param(declarations) end

---Declares what a behavior that runs this one may give it, as `param` declares parameters; each argument has a default. Returns a read-only table of the values in this frame. A dwell time may be the name of an argument.
---@param declarations table<string, table>
---@return table<string, any> values
function args(declarations) end

---Declares a table of numbers, texts and booleans that survives a reload of the script. Removed values stay removed, and values that a new version adds start as declared. Local variables do not survive.
---@generic T: table
---@param defaults T
---@return T memory
function keep(defaults) end

---Declares a state machine. `priority`: if requests conflict, the behavior with the greater priority wins; with equal priorities, the one that was loaded first. `priority = { 50, head = 60 }`: another one for a part of the body. `initial`: the first state. `common`: transitions from any state, not taken while their target is active; if the conditions of two of them hold at the same time, the states alternate in each frame.
---@param name string
---@return fun(body: reorient.State)
function behavior(name) end

---Declares a state. `enter`, `update` and `exit`: functions that run when the state is entered, in every frame, and when it is left. It contains transitions and inner states. A state with inner states may also have `initial`, `common`, and `history = true`, which resumes the inner state that was active last. `publishes = "name"`: a flag that other scripts read as `published.name`. `ends = "done"` or `ends = "failed"`: the state ends the behavior for the one that runs it.
---@param name string
---@return fun(body: reorient.State): table
function state(name) end

---In a state of a behavior: runs another behavior while the state is active, with values for its `args`. A function is evaluated in every frame, and its result is limited to the range of the argument. The behavior starts when the state is entered, runs in each frame after its caller, with the priority of its caller, and stops when the state is left. A state may run several behaviors. The machine is named after its callers: `striker/walk_to`.
---@param behavior string
---@return fun(arguments: table): table
function run(behavior) end

---A condition: a behavior that the state runs has ended in a state with `ends = "done"`.
---@param behavior string
---@return fun(): boolean
function done(behavior) end

---The same for a state with `ends = "failed"`, and for a behavior that was stopped after errors.
---@param behavior string
---@return fun(): boolean
function failed(behavior) end

---The behaviors that the active states run, read-only: `outcome` (`running`, `done` or `failed`), `reason` (of the last transition), `state` (path) and `time_in_state` (s). After the state was left, outcome and reason of a behavior that had ended remain until it runs again; the others are nil and 0.
---@class reorient.Called
---@field outcome "running"|"done"|"failed"|nil
---@field reason string?
---@field state string?
---@field time_in_state number s

---@type table<string, reorient.Called>
called = {}

---Declares a scenario for the simulator: a state machine like a behavior, which plays the operator beside the field and runs after each frame. `behaviors`: scripts to load. `room = "rooms/lab.hdr"` or `hall_seed = 3`, and `field`: the setting, unless the command line sets it. `room` is the path of a panorama from the scripts' root, or the name of one in assets/rooms; `field` likewise. Other files need `--room` and `--field`. Only scenarios have `truth`, `operator` and `verdict`. They cannot move the robot.
---@param name string
---@return fun(body: reorient.State)
function scenario(name) end

---Returns the value that the file lib/walk.lua below the scripts' root returns. Allowed only at the top level of a script.
---@overload fun(module: "lib.ball"): lib.ball
---@overload fun(module: "lib.decision"): lib.decision
---@overload fun(module: "lib.gaze"): lib.gaze
---@overload fun(module: "lib.ground_truth"): lib.ground_truth
---@overload fun(module: "lib.side"): lib.side
---@overload fun(module: "lib.side_report"): lib.side_report
---@overload fun(module: "lib.simulated_team"): lib.simulated_team
---@overload fun(module: "lib.team_evidence"): lib.team_evidence
---@overload fun(module: "lib.walk"): lib.walk
---@param module string
---@return any
function require(module) end

---The other machines at the start of the frame, read-only: `state` (path) and `time_in_state` (s). Of a machine that does not run they are nil and 0; `reorient check` reports unknown names.
---@class reorient.Machine
---@field state string? path of the innermost active state
---@field time_in_state number s

---@type table<string, reorient.Machine>
behaviors = {}

---Whether a state with `publishes = "pose_is_searched"` of any machine was active at the start of the frame; false if no script publishes it.
---@type table<string, boolean>
published = {}

---The values of the application, read-only: `input.NAME` has always a value of its type, `input.age.NAME` is the time since it was set (s; infinite if never), `input.valid.NAME` tells whether it is not too old and fits its declaration. An interface declares them (docs/applications.md).
---@class reorient.InputAge: table<string, any>

---@class reorient.InputValid: table<string, any>

---@class reorient.Input: table<string, any>
---@field age reorient.InputAge
---@field valid reorient.InputValid

---@type reorient.Input
input = {}

---The actions of the application. `action.NAME { ... }` requests one in `enter`, `update` or `exit`; repeated with the same arguments, it continues. `action.NAME.state` is `idle`, `requested`, `running`, `done` or `failed`, `.reason` tells why it failed, and `.time_in_state` for how long (s).
---@class reorient.Action
---@field state "idle"|"requested"|"running"|"done"|"failed"
---@field reason string
---@field time_in_state number s
---@operator call(table): nil

---@class reorient.Actions: table<string, reorient.Action>

---@type reorient.Actions
action = {}

---Writes a line to the run's log; in a test, a line below its result.
---@param ... any
function print(...) end

---@alias reorient.CommandName "flip_pose"|"purge_reflection"|"reset_orientation"|"pause_training"|"pause_evaluation"
---@alias reorient.Verdict "granted"|"outranked"|"too_soon"|"not_allowed"
---@alias reorient.PauseName "pause_training"|"pause_evaluation"
---@alias reorient.ApplicationAction string
---@alias reorient.ActionName "pick_up"|"put_down"|"push_over"|"penalize"|"set_exposure_compensation"|"set_initial_pose"|"half_time"|"change_light"|"tell_message"|"set_game_state"|"stop_game"|"set_kick_off"|"set_input"|"report_action"|"put_ball"
---@alias reorient.MachineName string
---@alias reorient.StatePath string
---@alias reorient.BehaviorScript string
---@alias reorient.ScenarioScript string
---@alias reorient.ParameterName string
---@alias reorient.InputValues table<string, any>

---@class reorient.World
---@field clock? table<string, number|boolean|string>
---@field game? table<string, number|boolean|string>
---@field robot? table<string, number|boolean|string>
---@field pose? table<string, number|boolean|string>
---@field confidence? table<string, number|boolean|string>
---@field views? table<string, number|boolean|string>
---@field training? table<string, number|boolean|string>
---@field evaluation? table<string, number|boolean|string>
---@field seen? table<string, number|boolean|string>
---@field field? table<string, number|boolean|string>
---@field truth? table<string, number|boolean|string>

---@class reorient.expect
expect = {}

---Declares a test. The file runs again for each test in a new sandbox, with its own world, clock and scripts. A test is limited to 60 s (`--timeout`) and to 36 000 s of the robot's time, all tests of a file together to ten times that.
---@param name string
---@param run fun()
function test(name, run) end

---Loads a behavior and the behaviors that it runs. `arguments`: values for its `args`, as a behavior gives them that runs it; they do not change.
---@param behavior reorient.BehaviorScript
---@param arguments? table<string, any>
function load_behavior(behavior, arguments) end

---Loads a scenario and its behaviors.
---@param scenario reorient.ScenarioScript
function load_scenario(scenario) end

---Changes what the robot senses in the fake world from the next frame. Derived values (times since a disturbance, age and status of the confidences, whether training and evaluation are active) follow the engine's own rules until the test sets it itself. A granted command changes the pose and the confidences as it does in the engine: after a flip, the evidence has the other sign. The clock cannot be set: `advance` lets time pass.
---@param world reorient.World
function set_world(world) end

---Declares the values and actions of an application: a name in assets/interfaces, or a path from the scripts' root. Call it before `load_behavior`.
---@param interface string
function load_interface(interface) end

---Sets values of the application in the next frame. They stay until they are set again; their age grows.
---@param values reorient.InputValues
function set_input(values) end

---Reports in the next frame that the latest start of an action is running, done or failed.
---@param action reorient.ApplicationAction
---@param state string
---@param reason? string
function report_action(action, state, reason) end

---Changes a parameter as a user does during a run. The parameter of a script that is loaded later is set when the script is loaded. The test fails if none of its scripts declares the parameter.
---@param name reorient.ParameterName
---@param value string
function set_param(name, value) end

---Adds a message of a teammate to the next frame.
---@param sender integer
---@param text string
function hear(sender, text) end

---Runs the frames of this time, in seconds, at 30 frames per second; at least one frame.
---@param seconds number
function advance(seconds) end

---Replaces a text in a script and reloads it. Without `file`, edits the script that was loaded last.
---@param edit { from: string, to: string, file: string? }
function reload(edit) end

---Runs a whole scenario on the simulator and returns whether the belief is correct at its end. Later expectations apply to the whole run. Optional: `with` (a list of additional behaviors), `width` of the image (160, 320, 544 or 640 pixels), `seconds` (the longest run), `room_awareness`, and `room`, `hall_seed` and `field` as in a scenario. The test is skipped without `reorient test --simulator`.
---@param run { scenario: reorient.ScenarioScript, with: string[]?, seed: integer?, width: integer?, seconds: number?, room_awareness: boolean?, room: string?, hall_seed: integer?, field: string?, params: table<string, any>? }
---@return boolean is_correct
function simulate(run) end

---Loads a recording (path from the tests' folder, below the scripts' root) instead of a fake world and runs its first frame with the current scripts instead of the recorded ones. `advance` and `advance_to` continue it; `set_param`, `reload` and `hear` affect its next frame. The recorded views do not change, so the result is only an estimate once the robot acts differently.
---@param file string
function replay(file) end

---Continues a recording up to the frame at this time (s of the robot).
---@param time number
function advance_to(time) end

---Returns a value of the world as behaviors read it in this frame.
---@param name string
---@return number|string|boolean value
function world_value(name) end

---A behavior started the action during the last `advance`, with these arguments if they are given, numbers to 1e-6; arguments that are left out have their defaults.
---@param action reorient.ApplicationAction
---@param arguments? table
function expect.started(action, arguments) end

---No behavior started the action during the last `advance`.
---@param action reorient.ApplicationAction
function expect.not_started(action) end

---In all frames of the replay so far, the robot did what was recorded: commands, head, walking, messages.
function expect.as_recorded() end

---The machine is in this state (path).
---@param machine reorient.MachineName
---@param path reorient.StatePath
function expect.state(machine, path) end

---The machine's last transition had this reason.
---@param machine reorient.MachineName
---@param text string
function expect.reason(machine, text) end

---The command was issued during the last `advance`, with this verdict if it is given (granted, outranked, too_soon, not_allowed).
---@param name reorient.CommandName
---@param verdict? reorient.Verdict
function expect.command(name, verdict) end

---The command, or without a name any reorientation, was not issued during the last `advance`.
---@param name? reorient.CommandName
function expect.no_command(name) end

---A state holds a lease on this pause now.
---@param name reorient.PauseName
function expect.lease(name) end

---No state holds a lease on this pause now.
---@param name reorient.PauseName
function expect.no_lease(name) end

---The requested angles of the head (yaw, pitch in rad).
---@param yaw number
---@param pitch number
function expect.head(yaw, pitch) end

---The requested walking velocity (m/s, m/s, rad/s).
---@param forward number
---@param left number
---@param turn number
function expect.walk(forward, left, turn) end

---Whether a behavior requests that the robot gets up.
---@param requested boolean
function expect.get_up(requested) end

---A log line of the last `advance` contains this text.
---@param text string
function expect.log(text) end

---A message to the teammates in the last `advance` contains this text.
---@param text string
function expect.message(text) end

---The operator of the scenario performed this action during the last `advance`.
---@param name reorient.ActionName
function expect.action(name) end

---The scenario ended with this verdict, whose text contains `text`.
---@param succeeded boolean
---@param text string
function expect.verdict(succeeded, text) end

---A script failed with an error that contains this text. Without this expectation, a failing script fails the test.
---@param text string
function expect.error(text) end

---The last reload was rejected with an error that contains this text. Without this expectation, a rejected reload fails the test.
---@param text string
function expect.refused(text) end

---Two values are equal. Tables are compared field by field. The first value is the actual one.
---@param actual any
---@param expected any
function expect.equal(actual, expected) end

---The difference of the first two numbers is at most the third.
---@param actual number
---@param expected number
---@param tolerance number
function expect.near(actual, expected, tolerance) end
