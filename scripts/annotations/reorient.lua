---@meta
-- What scripts can see and say, for the Lua language server. Generated from the declarations that make the
-- bindings, and from the libraries' doc comments; do not edit. `REORIENT_REGENERATE=1 ./test` writes it anew.

---@class reorient.State
---@field priority? number
---@field initial? string
---@field history? boolean
---@field publishes? string
---@field common? table[]
---@field behaviors? string[]
---@field room? string
---@field hall_seed? integer
---@field field? string
---@field enter? fun()
---@field update? fun()
---@field exit? fun()
---@field [integer] table

---Time.
---@class reorient.clock
---@field time number s, since the robot was switched on
---@field step number s, since the frame before
---@field frame number number of this frame
clock = {}

---What the referee says of the game.
---@class reorient.game
---@field sides_changed boolean the team plays towards the end that was its own at first; where this changes, so have the field's axes
---@field state "unknown"|"initial"|"ready"|"set"|"playing"|"finished"|"standby" as the rules call it; unknown: nobody has said anything
---@field stopped boolean nobody may move: what a behaviour asks of head and legs is not carried out
---@field kick_off "nobody"|"ours"|"theirs" who kicks off next, or takes the free kick
game = {}

---The robot's own body.
---@class reorient.robot
---@field posture "upright"|"falling"|"lying"|"getting_up"|"lifted" how it stands, lies or hangs in somebody's hands
---@field posture_before "upright"|"falling"|"lying"|"getting_up"|"lifted" the posture before the present one
---@field posture_for number s, for how long it has had its posture
---@field time_since_disturbance number s, time since the last fall, lift or penalty; 0 while the robot is not upright or is penalized
---@field undisturbed_for number s, former name of robot.time_since_disturbance
---@field penalized boolean the referee has taken it out of the game
---@field may_walk boolean the referee lets it: it is in the game, which is ready or playing, or of which nobody has said anything; else it stands, whatever a behaviour asks
---@field head_yaw number rad, measured angle of the head, to the left
---@field head_pitch number rad, measured angle of the head, downwards
---@field head_reach number rad, how far the neck turns to either side
---@field torso_pitch_bias number rad, how much farther the torso leans forward than is measured, as far as the lines of the field have shown
---@field camera_pitch_bias number rad, how much lower the upper camera looks in its mounting than is measured
---@field bias_deviation number rad, how well the sum of the two is known: a standard deviation
---@field can_walk boolean this body walks
---@field can_get_up boolean this body gets up after a fall
---@field cruise number m/s, at which speed this body goes far; 0: it does not walk
robot = {}

---Where the robot believes that it is, in the field's frame: x towards the opponent goal, y to the left.
---@class reorient.pose
---@field x number m, towards the opponent goal
---@field y number m, to the left
---@field rotation number rad, 0 looks towards the opponent goal, positive turns left
---@field known boolean somebody told where the robot stands, or a flip or purge has confirmed it; a reset takes it back
---@field tracked boolean what is seen of the field has fitted the believed pose, or its reflection, for seconds; false while the robot looks for its place
---@field cluster_weight number of all pose particles, in the cluster that is believed
---@field reflected_weight number of all pose particles, near the reflection of the believed pose
---@field recovery_probability number how much worse than usual the pose particles fit what is seen of the field: 0 as usual, 1 not at all
pose = {}

---What room awareness says about the believed pose; all from 0 to 1 unless said.
---@class reorient.confidence
---@field current number in the believed pose, smoothed
---@field opposite number in the reflection of the believed pose, smoothed
---@field evidence number log-odds, how strongly the room speaks for the reflection of the believed pose: 4.6 is 99 in 100, 0 says nothing, below 0 it speaks for the believed pose
---@field raw_current number in the believed pose, this frame's
---@field raw_opposite number in the reflection, this frame's
---@field goal_opponent number that the robot looks at the wall behind the opponent goal
---@field goal_own number that the robot looks at the wall behind its own goal
---@field coverage number share of the wall that is trained well enough to be compared with
---@field paired number the same, together with what lies on the other side of the room
---@field distinctiveness number how much the room differs from itself turned by half a turn; 0: it looks the same
---@field separability number how probable it is that the room can tell a pose from its reflection; below 0.5 (room_status.separability) it counts as symmetric
---@field asymmetry number former name of confidence.separability
---@field age number s, for how long known tiles were in view since the confidences began anew: after a lift, a fall, a penalty, a told pose, a flip or a jump of the belief
---@field status "usable"|"off"|"resting"|"unlearned"|"symmetric"|"lost"|"fresh" whether the confidences say something about the believed pose; if not, why not
---@field can_tell boolean whether the room can tell the believed pose from its reflection: it is known, not symmetric, and being compared; true while confidence.status is usable, lost or fresh
---@field visible_tiles number how many tiles of the wall counted in this frame
confidence = {}

---Which way to turn the head, as long as the body stays as it is.
---@class reorient.views
---@field best_yaw number rad, yaw of the head at which the room differs most from its reflection
---@field best_score number tiles, how much it differs there, in tiles that count fully; 0: no tile is in reach
---@field unknown_yaw number rad, yaw of the head at which most tiles are not learned yet
---@field unknown_score number tiles, number of tiles that are not learned yet there
---@field telling number rad, former name of views.best_yaw
---@field telling_worth number tiles, former name of views.best_score
---@field unknown number rad, former name of views.unknown_yaw
---@field unknown_worth number tiles, former name of views.unknown_score
views = {}

---The background model of the room.
---@class reorient.training
---@field seconds number s, how long the background model was trained so far, what was loaded of it included
---@field active boolean it was trained in the frame before
training = {}

---The comparison of what is seen with the background model.
---@class reorient.evaluation
---@field active boolean it went on in the frame before
evaluation = {}

---What was seen of the field in this frame.
---@class reorient.seen
---@field goal_posts number how many goal posts
---@field line_points number how many points on field lines
---@field intersections number how many places where lines meet
---@field ball boolean whether a ball is seen
---@field ball_distance number m, how far away it is; 0 where none is seen
---@field ball_bearing number rad, where it is, positive to the left; 0 where none is seen
seen = {}

---The field as drawn, to the centres of its lines; the origin is its centre.
---@class reorient.field
---@field length number m, between the goal lines
---@field width number m, between the touchlines
---@field border number m, carpet beyond the lines
---@field penalty_mark_x number m, distance of both penalty marks from the centre
---@field penalty_area_depth number m, from the goal line
---@field penalty_area_width number m, along the goal line
---@field goal_post_y number m, distance of a goal's posts from its middle
---@field corner_arc_radius number m, radius of the quarter circles at the corners; 0: there are none
---@field center_circle_radius number m, radius of the centre circle
field = {}

---Where the robot really is; only where a simulator or a tracking camera knows.
---@class reorient.truth
---@field x number m, towards the opponent goal
---@field y number m, to the left
---@field rotation number rad, 0 looks towards the opponent goal, positive turns left
---@field fallen boolean the robot really lies
---@field carried boolean the robot really hangs in the air
truth = {}

command = {}

---Asks that the belief be turned into its reflection, in this frame.
function command.flip_pose() end

---Asks that beliefs in the reflected pose be removed, in this frame.
function command.purge_reflection() end

---Asks that the orientation be forgotten and the position kept, in this frame.
function command.reset_orientation() end

---Stops the training of the background model until the state that says so is left.
function command.pause_training() end

---Stops the evaluation of the room until the state that says so is left.
function command.pause_evaluation() end

head = {}

---Turns the head to these angles (rad; to the left, downwards) at a speed (rad/s). Holds for one frame.
---@param yaw number
---@param pitch number
---@param speed? number
function head.look(yaw, pitch, speed) end

walk = {}

---Walks with this velocity (m/s, m/s, rad/s to the left). Holds for one frame.
---@param forward number
---@param left number
---@param turn number
function walk.velocity(forward, left, turn) end

---Stands still: a walk request like any other. Holds for one frame.
function walk.stand() end

motion = {}

---Gets up after a fall. Holds for one frame.
function motion.get_up() end

team = {}

---How many messages of team mates came with this frame.
---@return integer
function team.heard() end

---Who sent this one of them, the first being 1: the number of a player.
---@param which integer
---@return integer
function team.sender(which) end

---What it says: bytes as they came, at most 240.
---@param which integer
---@return string
function team.text(which) end

---Sends a message of at most 240 bytes to the team mates. The team's own program carries it.
---@param text string
function team.send(text) end

log = {}

---Writes a line into the run's log, with the time and the state.
---@param text string
function log.info(text) end

---The same, marked as a note, to be found again in a recording of the run.
---@param text string
function log.note(text) end

---Seconds since the state was entered whose function asks.
---@return number
function time_in_state() end

operator = {}

---Takes the robot off the ground.
function operator.pick_up() end

---Puts the robot down at this pose (m, m, rad), upright and standing.
---@param x number
---@param y number
---@param rotation number
function operator.put_down(x, y, rotation) end

---Makes the robot fall.
function operator.push_over() end

---Takes the robot out of the game, or lets it in again.
---@param penalized boolean
function operator.penalize(penalized) end

---The referee says: initial, ready, set, playing, finished, standby or unknown.
---@param state string
function operator.set_game_state(state) end

---Nobody may move any more, or everybody again.
---@param stopped boolean
function operator.stop_game(stopped) end

---Who kicks off next: ours, theirs or nobody.
---@param side string
function operator.set_kick_off(side) end

---Changes the hall's light against the camera's exposure, in powers of two.
---@param stops number
function operator.set_exposure_compensation(stops) end

---Another light begins, as the parameters `light` say.
function operator.change_light() end

---Tells the robot where it stands (m, m, rad).
---@param x number
---@param y number
---@param rotation number
function operator.set_initial_pose(x, y, rotation) end

---Tells the robot what a team mate says, at most 240 bytes.
---@param sender integer
---@param text string
function operator.tell_message(sender, text) end

---Tells the robot that the teams change sides; it stays where it is, and from here on all poses are in the axes of the new half.
function operator.half_time() end

chance = {}

---A random number from low on and below high; the run's seed says which.
---@param low number
---@param high number
---@return number
function chance.between(low, high) end

verdict = {}

---Ends the run: the robot did right, and why.
---@param text string
function verdict.succeed(text) end

---Ends the run: the robot did wrong, and why.
---@param text string
function verdict.fail(text) end

---@deprecated
experimenter = operator

do
---How much evidence does it take to act on it? What people want is a robot that errs at most so often. Evidence is told in log-odds: where it says 99 in 100, it is wrong once in a hundred times that it has a chance to be. So what is asked for follows from how often that is. One place decides it for all behaviours.
---@class lib.decision
local library = {}

--- While nothing has happened to the robot that would put its pose in doubt.
---@return number log_odds
function library.in_peace() end

--- While it is not known which of the two poses is the right one: after a disturbance, each of them may be.
---@return number log_odds
function library.in_doubt() end

--- Whether the room says that the believed pose is right.
---@return boolean
function library.for_believed() end

--- Whether the room says enough of either pose to act on it.
---@return boolean
function library.for_either() end
end

do
---Looking at a place on the field: with the head where the neck reaches, else by turning the body as well.
---@class lib.gaze
local library = {}

--- How far the head has to turn from where it is until a point of the field is straight ahead of it.
---@param x number m
---@param y number m
---@return number angle rad, never negative
function library.angle_to(x, y) end

--- Whether the robot looks at a point of the field, by the pose that it believes in.
---@param x number m
---@param y number m
---@return boolean
function library.is_at(x, y) end

--- One frame's look at a point of the field; the body turns while the neck alone does not reach it, else it stands.
---@param x number m
---@param y number m
function library.at(x, y) end
end

do
---How right the belief is, for scenarios: they alone may know the truth.
---@class lib.ground_truth
local library = {}

--- Where a robot stands beside the field before a match: at the height of its own penalty mark, looking into the field.
---@return number x m
---@return number y m
---@return number rotation rad
function library.start_pose() end

--- Puts the robot down at the start and tells it so.
function library.start() end

--- How far the believed pose is from the true one.
---@return number distance m
---@return number turn rad, never negative
function library.error() end

--- Whether both errors are small enough to call the belief right.
---@return boolean
function library.is_belief_right() end

--- The error in words, for logs and verdicts.
---@return string
function library.error_in_words() end

--- Ends the run; the verdict names the error of the belief.
---@param is_right boolean whether the run succeeds
function library.give_verdict(is_right) end

--- Whether the robot really stands near a penalty mark.
---@param side number -1 for the mark of its own half, 1 for the other
---@param distance number m
---@return boolean
function library.is_on_mark(side, distance) end

--- Writes truth and belief into the log.
---@param what string what happened just now
function library.note(what) end
end

do
---Walking to a place on the field, by the pose that the robot believes in.
---@class lib.walk
local library = {}

--- The same direction in (-pi, pi].
---@param angle number rad
---@return number angle rad
function library.normalize(angle) end

--- How far away a point on the field is, and where from the robot.
---@param x number m
---@param y number m
---@return number distance m
---@return number bearing rad, to the left of where the robot looks
function library.distance_and_bearing(x, y) end

--- Whether the robot believes that it stands near a point.
---@param x number m
---@param y number m
---@param distance number m
---@return boolean
function library.is_near(x, y, distance) end

--- One frame's walk towards a point; there it turns to `rotation`, if one is given.
---@param x number m
---@param y number m
---@param rotation? number rad
---@return boolean has_arrived
function library.walk_to(x, y, rotation) end

--- One frame's turn on the spot.
---@param speed number rad/s, to the left
function library.turn(speed) end
end

---Declares numbers that can be tuned: default, range, unit, sentence. `{ true, doc = ... }` is a switch, `{ "slow", choices = { "slow", "fast" }, doc = ... }` a choice, `integer = true` asks for whole numbers. The result is a read-only table of the present values. Their full name is the file's name, a dot, and the name.
---@param declarations table<string, table>
---@return table<string, any> values
function param(declarations) end

---A table of plain values that survives a reload, what was removed from it included; what a new version declares besides begins as declared. Local variables do not survive.
---@generic T: table
---@param defaults T
---@return T memory
function keep(defaults) end

---Declares a state machine. `priority`: the greater wins where two want the same, and of equal ones the behaviour that was loaded first. `initial`: the first state. `common`: transitions out of whichever state, not taken while their target is active.
---@param name string
---@return fun(body: reorient.State)
function behavior(name) end

---Declares a state: what to do on entering it, in every frame, and on leaving it; its transitions; states within it, then also `initial`, `common`, and `history = true` to resume the inner state that was active last. `publishes = "name"`: what others may ask for as `published.name`.
---@param name string
---@return fun(body: reorient.State): table
function state(name) end

---Declares a situation for the simulator: a state machine as a behaviour is, which plays the person beside the field. `behaviors`: which to load. `room = "rooms/lab.hdr"` (a panorama, from the scripts' root, or the name of one in assets/rooms) or `hall_seed = 3`, and `field` likewise: where it takes place, unless the command line says it. It alone has `truth`, `operator` and `verdict`; it cannot move the robot. It runs after each frame.
---@param name string
---@return fun(body: reorient.State)
function scenario(name) end

---What the file lib/walk.lua below the scripts' root returns. Stands at the top of a script.
---@overload fun(module: "lib.decision"): lib.decision
---@overload fun(module: "lib.gaze"): lib.gaze
---@overload fun(module: "lib.ground_truth"): lib.ground_truth
---@overload fun(module: "lib.walk"): lib.walk
---@param module string
---@return any
function require(module) end

---The other machines as they stood when the frame began, read-only: `state` (path) and `time_in_state` (s).
---@class reorient.Machine
---@field state string path of the innermost active state
---@field time_in_state number s

---@type table<string, reorient.Machine>
behaviors = {}

---Whether a state with `publishes = "pose_is_searched"` was active when the frame began, in whatever machine; false where nobody publishes it.
---@type table<string, boolean>
published = {}

---Writes a line into the run's log.
---@param ... any
function print(...) end

---@alias reorient.CommandName "flip_pose"|"purge_reflection"|"reset_orientation"|"pause_training"|"pause_evaluation"
---@alias reorient.Verdict "granted"|"outranked"|"too_soon"|"not_allowed"
---@alias reorient.PauseName "pause_training"|"pause_evaluation"
---@alias reorient.ActionName "pick_up"|"put_down"|"push_over"|"penalize"|"set_exposure_compensation"|"set_initial_pose"|"half_time"|"change_light"|"tell_message"|"set_game_state"|"stop_game"|"set_kick_off"
---@alias reorient.MachineName string
---@alias reorient.StatePath string
---@alias reorient.BehaviorScript string
---@alias reorient.ScenarioScript string
---@alias reorient.ParameterName string

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

expect = {}

---Declares a test. Its file is run anew for it in a fresh sandbox, with a world, a clock and scripts of its own. It may take 60 s (`--timeout`) and 36 000 s of the robot's time, the tests of a file ten times that.
---@param name string
---@param run fun()
function test(name, run) end

---Loads a behaviour.
---@param behavior reorient.BehaviorScript
function load_behavior(behavior) end

---Loads a scenario and its behaviours.
---@param scenario reorient.ScenarioScript
function load_scenario(scenario) end

---Changes what the robot senses in the fake world, from the next frame on. What follows from the rest (times since a disturbance, age and status of the confidences, whether training and evaluation go on) follows by the engine's own rules until the test sets it itself. A granted command changes the pose and the confidences as it does in the engine: after a flip, the evidence has the other sign. The clock cannot be set: `advance` lets time pass.
---@param world reorient.World
function set_world(world) end

---Changes a parameter as a user does live. One of a script that is loaded later waits for it; one that nothing in the test has is a failure.
---@param name reorient.ParameterName
---@param value string
function set_param(name, value) end

---A message of a team mate that comes with the next frame.
---@param sender integer
---@param text string
function hear(sender, text) end

---Lets this many seconds pass, 30 frames each; at least one frame.
---@param seconds number
function advance(seconds) end

---Edits a text of a script (the one that was loaded last, where no file is named) and reloads it.
---@param edit { from: string, to: string, file: string? }
function reload(edit) end

---Runs a whole scenario on the simulator and gives whether the belief was right at its end; what is expected behind it is expected of the whole run. Also takes `with`, a list of more behaviours, `width` of the image (160, 320, 544, 640), `seconds` at most, `room_awareness`, and `room`, `hall_seed`, `field` as a scenario does. Skipped unless `reorient test --simulator`.
---@param run { scenario: reorient.ScenarioScript, with: string[]?, seed: integer?, width: integer?, seconds: number?, room_awareness: boolean?, room: string?, hall_seed: integer?, field: string?, params: table<string, any>? }
---@return boolean is_correct
function simulate(run) end

---Plays a recording (from the tests' folder on), with the scripts that there are now instead of those that were recorded, instead of a fake world: its first frame, then `advance` and `advance_to` go on in it; `set_param`, `reload` and `hear` reach its next frame. What the robot saw stays what it was: once it acts otherwise, it is a guess.
---@param file string
function replay(file) end

---Goes on in a recording, up to the frame of this time of it (s of the robot).
---@param time number
function advance_to(time) end

---A value of the world as behaviours see it in this frame.
---@param name string
---@return number|string|boolean value
function world_value(name) end

---In all frames of the replay so far the robot acted as it was recorded: commands, head, walk, words.
function expect.as_recorded() end

---The machine is in this state (path).
---@param machine reorient.MachineName
---@param path reorient.StatePath
function expect.state(machine, path) end

---The machine's last transition had this reason.
---@param machine reorient.MachineName
---@param text string
function expect.reason(machine, text) end

---The command was issued during the last `advance`, with this verdict if one is named (granted, outranked, too_soon, not_allowed).
---@param name reorient.CommandName
---@param verdict? reorient.Verdict
function expect.command(name, verdict) end

---The command, or any reorientation, was not issued during the last `advance`.
---@param name? reorient.CommandName
function expect.no_command(name) end

---Some state holds this pause now.
---@param name reorient.PauseName
function expect.lease(name) end

---No state holds this pause now.
---@param name reorient.PauseName
function expect.no_lease(name) end

---The head is asked to turn there (yaw, pitch, rad).
---@param yaw number
---@param pitch number
function expect.head(yaw, pitch) end

---The robot is asked to walk so (m/s, m/s, rad/s).
---@param forward number
---@param left number
---@param turn number
function expect.walk(forward, left, turn) end

---The robot is asked, or is not asked, to get up.
---@param wanted boolean
function expect.get_up(wanted) end

---A log line of the last `advance` contains this.
---@param text string
function expect.log(text) end

---A message to the team mates of the last `advance` contains this.
---@param text string
function expect.message(text) end

---The scenario did this during the last `advance`.
---@param name reorient.ActionName
function expect.action(name) end

---The scenario's verdict, and a part of its text.
---@param succeeded boolean
---@param text string
function expect.verdict(succeeded, text) end

---A script failed so; without this, a failing script fails the test.
---@param text string
function expect.error(text) end

---The reload was refused so; without this, that fails the test.
---@param text string
function expect.refused(text) end

---Two values are the same, tables field by field; the first is what was seen.
---@param actual any
---@param expected any
function expect.equal(actual, expected) end

---Two numbers differ by no more than the third.
---@param actual number
---@param expected number
---@param tolerance number
function expect.near(actual, expected, tolerance) end
