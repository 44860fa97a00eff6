// SPDX-License-Identifier: MIT
#include "robots/companion/companion.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robots/camera_pairing.h"
#include "robots/companion/application_json.h"

namespace reorient {
namespace {

constexpr std::size_t kMostSamples = 100;      // body samples between two frames
constexpr std::size_t kMostWaitingNotes = 64;  // notes that wait to be sent

ReportedPosture posture_of(std::uint32_t reported) { return static_cast<ReportedPosture>(reported); }
static_assert(static_cast<int>(ReportedPosture::unknown) == REORIENT_UNKNOWN &&
              static_cast<int>(ReportedPosture::upright) == REORIENT_UPRIGHT &&
              static_cast<int>(ReportedPosture::falling) == REORIENT_FALLING &&
              static_cast<int>(ReportedPosture::fallen) == REORIENT_FALLEN &&
              static_cast<int>(ReportedPosture::getting_up) == REORIENT_GETTING_UP);

std::uint32_t kind_of(Reorientation reorientation) {
  switch (reorientation) {
    case Reorientation::flip_pose:
      return REORIENT_FLIP;
    case Reorientation::purge_reflection:
      return REORIENT_PURGE;
    case Reorientation::reset_orientation:
      return REORIENT_RESET;
  }
  return 0;
}

Isometry3 camera_pose_of(const double (&pose)[12]) {
  Isometry3 result = Isometry3::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) result.linear()(row, column) = pose[4 * row + column];
    result.translation()(row) = pose[4 * row + 3];
  }
  return result;
}

Eigen::Matrix3d covariance_of(const double (&half)[6]) {
  Eigen::Matrix3d full;
  full << half[0], half[1], half[2], half[1], half[3], half[4], half[2], half[4], half[5];
  return full;
}

void set_covariance(const Eigen::Matrix3d& full, double (&half)[6]) {
  const double values[6] = {full(0, 0), full(0, 1), full(0, 2), full(1, 1), full(1, 2), full(2, 2)};
  std::copy(std::begin(values), std::end(values), std::begin(half));
}

/// Drops the oldest note if too many wait.
void keep_note(std::vector<reorient_note>& notes, std::uint32_t kind, std::string_view text) {
  if (notes.size() >= kMostWaitingNotes) notes.erase(notes.begin());
  reorient_note& note = notes.emplace_back();
  note.kind = kind;
  set_text(note.text, text);
}

}  // namespace

Companion::Companion(CompanionOptions options)
    : options_(std::move(options)),
      connection_(options_.socket, options_.now),
      command_(options_.server, options_.stores_commands) {
  samples_.reserve(kMostSamples);
  body_samples_.reserve(kMostSamples);
  particles_.reserve(REORIENT_MOST_PARTICLES);
  percepts_.reserve(REORIENT_MOST_PERCEPTS);
  for (Arrived* const one : {&arrived_, &newest_}) {
    one->message.particles.reserve(REORIENT_MOST_PARTICLES);
    one->message.messages.reserve(REORIENT_MOST_MESSAGES);
    one->message.percepts.list.reserve(REORIENT_MOST_PERCEPTS);
  }
}

const Handshake* Companion::wait_for_handshake() {
  while (!handshake_) {
    if (options_.is_over && options_.is_over()) return nullptr;
    connection_.listen(options_.patience, *this);
  }
  return &*handshake_;
}

void Companion::begin(const Handshake& handshake, bool continues, int behaviors) {
  engine_for_ = handshake;
  continues_ = continues;
  behaviors_ = behaviors;
  states_.clear();
  command_.withdraw();  // it was requested by another engine
  actions_.clear();
  if (!continues) pending_.begin_axes();
  welcome_client();
}

/// Welcomes a client whose robot the engine was created for.
void Companion::welcome_client() {
  if (!handshake_ || !engine_for_) return;
  has_other_robot_ = identity_of(*handshake_) != identity_of(*engine_for_);
  if (has_other_robot_ || welcomed_) return;
  welcomed_ = connection_.send(REORIENT_WELCOME, reorient_welcome{options_.server, continues_ ? 1u : 0u,
                                                                  static_cast<std::uint32_t>(behaviors_)});
  actions_.begin_connection();
  continues_ = true;  // the next client connects to an engine that has a state
  reported_refusal_.clear();
}

bool Companion::observe(Observation& observation) {
  // Read everything that arrived while the engine was busy, to use the newest frame and not the oldest.
  connection_.listen(0.0, *this);
  while (true) {
    if (has_other_robot()) return false;
    // A client that sends only a hello does not replace the engine with what it learned.
    if (!has_other_robot_ && use_newest(observation)) return true;
    if (options_.is_over && options_.is_over()) return false;
    connection_.listen(options_.patience, *this);
  }
}

void Companion::connected() {
  ++counts_.clients;
  reported_percepts_ = false;
  handshake_.reset();
  has_other_robot_ = false;
  welcomed_ = false;
}

void Companion::tell(const std::string& line) {
  if (options_.tell) options_.tell(line);
}

/// Reports equal refusals once, since a refused client tries again.
void Companion::refused(const std::string& why) {
  if (std::exchange(reported_refusal_, why) != why) tell("client refused: " + why);
}

void Companion::disconnected() {
  if (welcomed_) tell("client left");
  handshake_.reset();
  has_other_robot_ = false;
  welcomed_ = false;
  has_newest_ = false;
  samples_.clear();
  words_.clear();  // messages to teammates do not wait for another client
  for (auto& images : shared_) images.reset();
  for (auto& [behavior, state] : states_) state.second = false;
}

void Companion::receive(std::uint16_t kind, std::span<const std::byte> body, OwnedDescriptor& memory) {
  if (kind == REORIENT_HELLO) return take_hello(body);
  if (!handshake_) throw BadMessage("expected a hello as the first message, found type " + std::to_string(kind));
  switch (kind) {
    case REORIENT_MEMORY:
      return take_memory(body, memory);
    case REORIENT_FRAME:
      return take_frame(body);
    case REORIENT_SAMPLE:
      return take_sample(body);
    case REORIENT_GAME:
      return take_game(body);
    case REORIENT_VALUES:
      return take_values(body);
    case REORIENT_REPORT:
      return take_report(body);
    default:
      throw BadMessage("unknown message type " + std::to_string(kind) + " (expected 1 to 7)");
  }
}

void Companion::take_hello(std::span<const std::byte> body) {
  if (handshake_) throw BadMessage("second hello on one connection (expected one); connect again to send another");
  handshake_ = read_handshake(body, options_.known);
  pending_.begin_client(handshake_->client);
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const std::optional<reorient_camera>& camera = handshake_->cameras[i];
    images_[i] = camera ? Image(camera->width, camera->height) : Image();
  }
  welcome_client();
  if (welcomed_) tell("client connected to the running engine");
}

void Companion::take_memory(std::span<const std::byte> body, OwnedDescriptor& memory) {
  const auto layout = take_message<reorient_memory>(body, "memory");
  if (!body.empty())
    throw BadMessage("memory: " + std::to_string(body.size()) + " bytes too many (expected " +
                     std::to_string(sizeof(layout)) + ")");
  if (!memory) throw BadMessage("memory: message without a file descriptor");
  if (layout.camera >= shared_.size() || !handshake_->cameras[layout.camera])
    throw BadMessage("memory: camera " + std::to_string(layout.camera) + " (the hello does not describe it)");
  shared_[layout.camera].reset();
  shared_[layout.camera].emplace(memory, layout, *handshake_->cameras[layout.camera]);
  memory = OwnedDescriptor();
}

void Companion::take_frame(std::span<const std::byte> body) {
  read_frame(body, handshake_->has_detector, arrived_.message);
  for (std::size_t i = 0; i < shared_.size(); ++i) {
    const reorient_image& image = arrived_.message.frame.images[i];
    if (image.present == 0) continue;
    if (!shared_[i]) throw BadMessage("frame: image of camera " + std::to_string(i) + ", whose memory was not sent");
    if (image.slot >= REORIENT_SLOTS)
      throw BadMessage("frame: images[" + std::to_string(i) + "].slot is " + std::to_string(image.slot) +
                       " (expected 0 to 2)");
  }
  ++counts_.frames;
  report_percepts();
  command_.acknowledge(arrived_.message.frame.done_server, arrived_.message.frame.done);
  if (pending_.add(arrived_.message)) command_.withdraw();
  if (const std::string error = error_in(arrived_.message); !error.empty())
    return drop_frame(arrived_.message.frame.number, error);
  arrived_.at = options_.now();
  if (has_newest_) ++counts_.superseded;
  std::swap(arrived_, newest_);
  has_newest_ = true;
}

/// Reports an unusable frame by a note, since it gets no answer.
void Companion::drop_frame(std::uint64_t number, const std::string& why) {
  constexpr double kPause = 1.0;  // s; a client that sends one wrong frame sends many
  ++counts_.unusable;
  if (options_.now() < next_complaint_) return;
  next_complaint_ = options_.now() + kPause;
  tell_note(NoteKind::fault, "frame " + std::to_string(number) + " dropped: " + why);
  send_waiting();
}

void Companion::take_sample(std::span<const std::byte> body) {
  const reorient_sample sample = read_sample(body);
  if (!is_valid(sample)) return;
  if (samples_.size() >= kMostSamples) samples_.erase(samples_.begin());
  samples_.push_back(sample);
}

void Companion::take_values(std::span<const std::byte> body) {
  if (body.size() > REORIENT_LONGEST_VALUES)
    throw BadMessage("values: expected at most 32768 bytes, found " + std::to_string(body.size()));
  std::string json(body.size(), '\0');
  if (!body.empty()) std::memcpy(json.data(), body.data(), body.size());
  pending_.add(read_values(json, handshake_->application));
}

void Companion::take_report(std::span<const std::byte> body) {
  const auto report = take_message<reorient_report>(body, "report");
  if (!body.empty())
    throw BadMessage("report: " + std::to_string(body.size()) + " bytes too many (expected " +
                     std::to_string(sizeof(report)) + ")");
  constexpr ActionState kStates[] = {ActionState::running, ActionState::done, ActionState::failed};
  if (report.state < REORIENT_ACTION_RUNNING || report.state > REORIENT_ACTION_FAILED)
    throw BadMessage("report: state is " + std::to_string(report.state) + " (expected 1 running, 2 done or 3 failed)");
  actions_.acknowledge(report.id);
  pending_.add(ActionReport{report.id, kStates[report.state - REORIENT_ACTION_RUNNING], text_of(report.reason)});
}

void Companion::take_game(std::span<const std::byte> body) {
  const auto game = take_message<reorient_game>(body, "game");
  if (!body.empty())
    throw BadMessage("game: " + std::to_string(body.size()) + " bytes too many (expected " +
                     std::to_string(sizeof(game)) + ")");
  if (game.size > REORIENT_LONGEST_DATAGRAM)
    throw BadMessage("game: datagram of " + std::to_string(game.size) + " bytes (expected at most 256)");
  constexpr std::uint32_t kMost = 1000;  // more than any team or player
  const auto team = static_cast<int>(std::min(game.team, kMost)),
             player = static_cast<int>(std::min(game.player, kMost));
  if (game_.team() != team || game_.player() != player) game_.set_robot(team, player);
  ExternalInputs inputs;
  game_.read(std::as_bytes(std::span(game.datagram).first(game.size)), inputs);
  if (const std::string complaint = game_.take_complaint(); !complaint.empty()) {
    tell_note(NoteKind::fault, complaint);
    tell(complaint);
  }
  pending_.add(inputs);
}

/// Returns false if there is no new frame or it is unusable.
bool Companion::use_newest(Observation& observation) {
  if (!has_newest_) return false;
  has_newest_ = false;
  const FrameMessage& message = newest_.message;
  const reorient_frame& frame = message.frame;
  const bool has_time = message.has(REORIENT_HAS_TIME);
  const double time = has_time ? frame.time : newest_.at - handshake_->delay;
  const std::optional<ClientClock::Moment> moment =
      clock_.advance(handshake_->client, time, pose_of(frame.odometry), newest_.at - last_arrival_);
  last_arrival_ = newest_.at;
  if (clock_.restarted()) {  // the client has a new belief, in the present axes
    command_.withdraw();
    pending_.begin_axes();
  }
  observation = {};
  if (!moment) return drop_frame(frame.number, "its time is not later than that of the previous frame"), false;
  if (!take_images(message, moment->time, observation))
    return drop_frame(frame.number, "its image was overwritten before it was read"), false;
  observation.time = moment->time;
  observation.odometry = moment->odometry;
  observation.body = with_load(body_sample(frame, moment->time), frame.has);
  take_samples(moment->time, has_time);
  observation.body_samples = body_samples_;
  observation.reported_posture = posture_of(frame.posture);
  if (handshake_->own_localization && (message.has(REORIENT_HAS_BELIEF) || !message.particles.empty())) {
    particles_ = message.particles;
    ExternalBelief& belief = observation.belief.emplace();
    belief.pose = pose_of(frame.belief);
    belief.covariance = covariance_of(frame.covariance);
    belief.particles = particles_;
  }
  if (message.has_percepts) {
    percepts_ = message.percepts.list;
    observation.percepts = {handshake_->detector_replaces_vision, percepts_};
  }
  observation.external = pending_.take(message);
  answered_ = frame.number;
  answered_time_ = time;
  answered_at_ = newest_.at;
  return true;
}

/// Reports invalid percepts once for each connection.
void Companion::report_percepts() {
  const PerceptMessage& percepts = arrived_.message.percepts;
  counts_.percepts += percepts.dropped;
  if (percepts.dropped == 0 || std::exchange(reported_percepts_, true)) return;
  const std::string problem = "frame " + std::to_string(arrived_.message.frame.number) + ": " +
                              std::to_string(percepts.dropped) + " of its percepts dropped: " + percepts.mistake;
  tell_note(NoteKind::fault, problem);
  tell(problem);
}

/// Uses the standing load if the robot does not report the load on its feet.
BodySample Companion::with_load(BodySample sample, std::uint32_t has) const {
  if ((has & REORIENT_HAS_FOOT_LOAD) == 0 && handshake_->body.standing_load)
    sample.foot_load = *handshake_->body.standing_load;
  return sample;
}

/// Takes the samples since the previous frame. A frame arrives after its image was exposed, so later samples wait for
/// the next frame. Samples of another clock or out of order are dropped.
void Companion::take_samples(double time, bool has_time) {
  constexpr double kFarthestAhead = 1.0;  // s
  double after = last_time_;
  body_samples_.clear();
  std::size_t kept = 0;
  for (const reorient_sample& sample : samples_) {
    const double felt = has_time ? clock_.to_engine(sample.time) : time;
    if (felt > time) {
      if (felt <= time + kFarthestAhead) samples_[kept++] = sample;
    } else if (felt > after || !has_time) {
      body_samples_.push_back(with_load(body_sample(sample, felt), sample.has));
      after = felt;
    }
  }
  samples_.resize(kept);
  last_time_ = time;
}

/// Returns false if an image was overwritten.
bool Companion::take_images(const FrameMessage& message, double time, Observation& observation) {
  const bool told_attitude = message.has(REORIENT_HAS_ATTITUDE), told_head = message.has(REORIENT_HAS_HEAD);
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const reorient_image& which = message.frame.images[i];
    if (which.present == 0) continue;
    if (!shared_[i] || !shared_[i]->copy(which, images_[i])) return false;
    CameraFrame& camera = (i == 0 ? observation.upper : observation.lower).emplace();
    camera.time = time - which.age;
    camera.image = images_[i].view();
    camera.camera = camera_model(*handshake_->cameras[i], handshake_->lenses[i]);
    camera.odometry = clock_.odometry();
    if (which.present == 2) {
      camera.robot_from_camera = camera_pose_of(which.pose);
      continue;
    }
    const reorient_frame& frame = message.frame;
    const HeadAngles head = told_head ? HeadAngles{frame.head[0], frame.head[1]} : HeadAngles{};
    const TorsoAttitude torso = told_attitude ? TorsoAttitude{frame.attitude[0], frame.attitude[1]} : TorsoAttitude{};
    const RobotDimensions& dimensions = handshake_->body.dimensions;
    camera.robot_from_camera = robot_from_camera(dimensions, head, torso, dimensions.torso_height,
                                                 i == 0 ? HeadCamera::upper : HeadCamera::lower);
  }
  return true;
}

void Companion::answer(const Answer& answer) {
  const auto flag = [](bool set, std::uint32_t bit) { return set ? bit : 0u; };
  if (answer.reorientation && engine_for_ && engine_for_->own_localization) command_.grant(*answer.reorientation);
  reorient_answer message{};
  message.number = answered_;
  message.time = answered_time_;
  message.took = options_.now() - answered_at_;
  if (command_.waiting()) {
    message.command = command_.number();
    message.command_kind = kind_of(*command_.waiting());
  }
  message.current = answer.room.current;
  message.opposite = answer.room.opposite;
  message.evidence = answer.room.evidence;
  const Pose2& pose = answer.belief.pose;
  message.pose[0] = pose.position.x();
  message.pose[1] = pose.position.y();
  message.pose[2] = pose.rotation;
  set_covariance(answer.belief.covariance, message.covariance);
  const Request& request = answer.request;
  const bool head = request.head && handshake_ && handshake_->carries_out_head;
  const bool walk = handshake_ && handshake_->carries_out_walk;
  const bool get_up = request.get_up && handshake_ && handshake_->carries_out_get_up;
  if (head) {
    message.head[0] = request.head->angles.yaw;
    message.head[1] = request.head->angles.pitch;
    message.head[2] = request.head->speed;
  }
  if (walk) {
    message.walk[0] = request.walk.forward;
    message.walk[1] = request.walk.left;
    message.walk[2] = request.walk.turn;
  }
  message.has = flag(answer.belief.known, REORIENT_ANSWER_POSE) | flag(head, REORIENT_ANSWER_HEAD) |
                flag(walk, REORIENT_ANSWER_WALK) | flag(get_up, REORIENT_ANSWER_GET_UP) |
                flag(answer.room.usable, REORIENT_ANSWER_ROOM) |
                flag(answer.training_paused, REORIENT_ANSWER_TRAINING_PAUSED) |
                flag(answer.evaluation_paused, REORIENT_ANSWER_EVALUATION_PAUSED);
  message.frames = counts_.frames;
  message.superseded = counts_.superseded;
  message.unusable = counts_.unusable;
  if (handshake_ && !connection_.send(REORIENT_ANSWER, message)) ++counts_.unanswered;
  for (const StartedAction& started : answer.actions) {
    if (!engine_for_ || started.action >= engine_for_->application.actions.size()) continue;
    const DeclaredAction& declared = engine_for_->application.actions[started.action];
    if (const std::string problem = actions_.add(started, declared, options_.now()); !problem.empty())
      tell_note(NoteKind::fault, problem);
  }
  if (welcomed_) {
    for (const std::string& word : answer.messages) keep_note(words_, REORIENT_NOTE_MESSAGE, word);
  }
  send_waiting();
}

void Companion::tell_state(std::string_view behavior, std::string_view state) {
  auto known = states_.find(behavior);
  if (known == states_.end()) known = states_.emplace(behavior, std::pair{std::string(), false}).first;
  auto& [last, is_known] = known->second;
  if (last == state) return;
  last = state;
  is_known = false;
}

void Companion::tell_note(NoteKind kind, std::string_view text) {
  keep_note(notes_, static_cast<std::uint32_t>(kind), text);
}

void Companion::send_waiting() {
  if (!welcomed_) return;
  actions_.send(options_.now(),
                [&](const reorient_action& action) { return connection_.send(REORIENT_ACTION, action); });
  for (auto& [behavior, state] : states_) {
    if (state.second) continue;
    reorient_state message{};
    set_text(message.behavior, behavior);
    set_text(message.state, state.first);
    if (!connection_.send(REORIENT_STATE, message)) return;
    state.second = true;
  }
  for (std::vector<reorient_note>* const notes : {&words_, &notes_}) {
    std::size_t sent = 0;
    while (sent < notes->size() && connection_.send(REORIENT_NOTE, (*notes)[sent])) ++sent;
    notes->erase(notes->begin(), notes->begin() + static_cast<std::ptrdiff_t>(sent));
  }
}

}  // namespace reorient
