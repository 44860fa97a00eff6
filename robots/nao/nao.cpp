// SPDX-License-Identifier: MIT
#include "robots/nao/nao.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "robots/nao/guard/guard.h"
#include "robots/nao/lights.h"

namespace reorient::nao {
namespace {

VideoSettings video_settings(const CameraModel& camera, HeadCamera which) {
  VideoSettings settings;
  settings.path = which == HeadCamera::upper ? "/dev/video-top" : "/dev/video-bottom";
  settings.width = camera.width;
  settings.height = camera.height;
  settings.upside_down = which == HeadCamera::upper;
  return settings;
}

CameraModel camera_of_width(const CameraOptics& optics, int width) {
  return camera_model(optics, width, width * optics.height / optics.width);
}

/// The posture that the guard reports. While the robot stands, the engine finds its posture by itself.
ReportedPosture reported(GuardState state) {
  switch (state) {
    case GuardState::standing:
      return ReportedPosture::unknown;
    case GuardState::fallen:
      return ReportedPosture::fallen;
    case GuardState::waiting:
    case GuardState::soft:
    case GuardState::standing_up:
    case GuardState::sitting_down:
    case GuardState::sitting:
      return ReportedPosture::getting_up;  // do not use the images: the camera is lower than the engine assumes
  }
  return ReportedPosture::unknown;
}

}  // namespace

Nao::Nao(NaoOptions options, NaoSurroundings surroundings)
    : options_(std::move(options)),
      around_(std::move(surroundings)),
      start_(around_.now()),
      game_(options_.team, options_.player),
      stands_when_possible_(options_.stands_at_once) {
  const RobotBody& body = options_.body;
  upper_.emplace(*around_.upper, camera_of_width(body.upper_camera, options_.width), HeadCamera::upper,
                 around_.run_errand);
  if (around_.lower != nullptr && body.lower_camera)
    lower_.emplace(*around_.lower, camera_of_width(*body.lower_camera, options_.width), HeadCamera::lower,
                   around_.run_errand);
}

Nao::Eye::Eye(VideoDevice& device, const CameraModel& optics, HeadCamera which, const RunErrand& run_errand)
    : model(optics), camera(device, video_settings(optics, which), run_errand) {}

Nao::~Nao() {
  posture_ = WantedPosture::sit;
  paused_ = true;
  try {
    send_request(around_.now());
  } catch (const std::exception&) {  // the guard was replaced by another one; without requests it sits down, too
  }
}

bool Nao::observe(Observation& observation) {
  constexpr double kPatience = 0.02;  // s; the guard needs a request at least every 100 ms
  while (true) {
    const double now = around_.now();
    const bool has_body = read_body(now);
    read_referee(now);
    read_image(HeadCamera::upper, now);
    if (lower_) read_image(HeadCamera::lower, now);
    if (ends_ || (around_.is_over && around_.is_over())) return false;
    if (has_body && pairing_.is_due(engine_time(now))) break;
    if (has_body) note_missing(Missing::images, now);
    send_request(now);
    const std::array<int, 2> descriptors{upper_->camera.descriptor(), lower_ ? lower_->camera.descriptor() : -1};
    around_.wait(kPatience, descriptors);
  }
  note_missing(Missing::nothing, around_.now());
  ++counts_.frames;
  observation = {};
  pairing_.take(observation);
  const BodyHistory::Moment moment = *history_.newest();
  // Samples after the image wait for the next frame.
  const auto later = std::find_if(body_samples_.begin(), body_samples_.end(),
                                  [&](const BodySample& sample) { return sample.time > observation.time; });
  given_.assign(body_samples_.begin(), later);
  body_samples_.erase(body_samples_.begin(), later);
  observation.body_samples = given_;
  observation.body = given_.empty() ? moment.body : given_.back();
  observation.odometry = observation.upper ? observation.upper->odometry : observation.lower->odometry;
  observation.reported_posture = reported(guard_.state);
  observation.external = std::exchange(external_, {});
  return true;
}

/// Reads the measurements since the last call. Returns false if none has arrived for a while.
bool Nao::read_body(double now) {
  SharedBody* const body = around_.body();
  if (body == nullptr) {
    note_missing(Missing::guard, now);
    return false;
  }
  body->report.read(guard_);
  news_.clear();
  seen_ = body->news(seen_, news_);
  for (const Measurement& measurement : news_) {
    if (!measurement.has(SensorKey::position) || !measurement.has(SensorKey::angles)) continue;
    Measurement moved = measurement;
    moved.time = engine_time(measurement.time);
    history_.add(moved);
    press_button(moved);
    constexpr std::size_t kMostSamples = 100;
    if (body_samples_.size() >= kMostSamples) body_samples_.erase(body_samples_.begin());
    body_samples_.push_back(history_.newest()->body);
  }
  const bool is_guarded = std::fabs(now - guard_.time) <= Guard::kHolds;
  const bool is_up = guard_.state == GuardState::standing_up || guard_.state == GuardState::standing;
  if (stands_when_possible_ && is_guarded && (is_up || (guard_.warnings & kNoRequest) == 0)) {
    stands_when_possible_ = false;
    posture_ = WantedPosture::stand;
  }
  // It sat down while this process was stopped or the guard restarted: stay down until the button is pressed.
  if ((guard_.warnings & kStandRefused) != 0 && posture_ == WantedPosture::stand) posture_ = WantedPosture::sit;
  if (guard_.state == GuardState::fallen && posture_ == WantedPosture::stand)
    posture_ = WantedPosture::soft;  // until the operator puts it on its feet and presses the button
  // Stay seated when the battery is charged again or a joint that was given up is free. A motor that was too hot does
  // not change the request, so that the robot stands up when it has cooled.
  if ((guard_.warnings & (kBatteryEmpty | kJointGivenUp)) != 0 && posture_ == WantedPosture::stand)
    posture_ = WantedPosture::sit;
  const std::optional<BodyHistory::Moment> newest = history_.newest();
  const bool has_body = newest && engine_time(now) - newest->body.time < BodyHistory::kGap;
  if (!has_body) note_missing(Missing::measurements, now);
  return has_body;
}

void Nao::press_button(const Measurement& measurement) {
  // A robot that lies on its front presses the button with its weight.
  constexpr float kOnItsFront = 1.0f;  // rad
  const bool is_down =
      measurement.has(SensorKey::touch) && measurement.touch[kChest] > 0.5f && measurement.angles[1] < kOnItsFront;
  switch (chest_.update(is_down, measurement.time)) {
    case ChestButton::Press::none:
      return;
    case ChestButton::Press::brief:
      paused_ = posture_ == WantedPosture::stand && !paused_;
      posture_ = WantedPosture::stand;
      return;
    case ChestButton::Press::lasting:
      ends_ = true;
      return;
  }
}

void Nao::read_referee(double now) {
  if (around_.referee == nullptr) return;
  constexpr int kAtOnce = 20;
  constexpr double kReturnPeriod = 1.0;  // s
  for (int i = 0; i < kAtOnce; ++i) {
    const std::span<const std::byte> datagram = around_.referee->receive();
    if (datagram.empty()) return;
    const bool is_used = game_.read(datagram, external_);
    if (const std::string complaint = game_.take_complaint(); !complaint.empty() && around_.tell)
      around_.tell(complaint);
    if (!is_used) continue;
    around_.referee->accept_sender();
    if (now < next_return_) continue;
    next_return_ = now + kReturnPeriod;
    around_.referee->answer(
        return_datagram({game_.team(), game_.player(), guard_.state == GuardState::fallen, answer_.belief.pose}));
  }
}

/// Reads the newest image of a camera and pairs it with the head angles at its exposure.
void Nao::read_image(HeadCamera which, double now) {
  Eye& eye = which == HeadCamera::upper ? *upper_ : *lower_;
  const std::optional<VideoCamera::Image> image = eye.camera.look(now);
  const bool is_upper = which == HeadCamera::upper;
  if (image || eye.camera.state() == VideoState::closed) is_upper ? pairing_.drop_upper() : pairing_.drop_lower();
  if (!image || eye.camera.state() != VideoState::running) return;  // do not train while the colors still change
  const double time = engine_time(image->time) + options_.image_delay;
  const std::optional<BodyHistory::Moment> moment = history_.at(time);
  if (!moment) {
    ++counts_.unplaced;
    return;
  }
  CameraFrame frame;
  frame.time = time;
  frame.image = {image->yuyv.data(), eye.model.width, eye.model.height, 2 * eye.model.width};
  frame.camera = eye.model;
  frame.odometry = moment->odometry;
  const RobotDimensions& dimensions = options_.body.dimensions;
  frame.robot_from_camera =
      turned(robot_from_camera(dimensions, moment->body.head, moment->body.torso, dimensions.torso_height, which),
             options_.offsets[is_upper ? 0 : 1]);
  if (is_upper) {
    pairing_.put_upper(frame);
  } else {
    pairing_.put_lower(frame, engine_time(now));
  }
}

void Nao::answer(const Answer& answer) {
  answer_ = answer;
  answered_ = around_.now();
  send_request(*answered_);
}

void Nao::send_request(double now) {
  SharedBody* const body = around_.body();
  if (body == nullptr) return;
  BodyRequest request;
  request.time = now;
  request.posture = posture_;
  // Without images the engine decides nothing, so its last decision neither moves the robot nor is shown.
  constexpr double kCurrent = 1.0;  // s
  const bool is_current = answered_ && now - *answered_ <= kCurrent;
  const bool moves = is_current && !paused_;
  const std::optional<HeadRequest>& head = answer_.request.head;
  if (head && moves) {
    const HeadAngles angles = options_.body.neck.clamp(head->angles);
    request.moves_head = 1;
    request.head_yaw = static_cast<float>(angles.yaw);
    request.head_pitch = static_cast<float>(angles.pitch);
    request.head_speed = static_cast<float>(std::min(head->speed, options_.body.head_speed));
  }
  if (moves && options_.body.gait) {
    const WalkVelocity& walk = answer_.request.walk;
    request.walk_forward = static_cast<float>(walk.forward);
    request.walk_left = static_cast<float>(walk.left);
    request.walk_turn = static_cast<float>(walk.turn);
  }
  request.lights = lights_of(is_current ? &answer_ : nullptr, guard_.state == GuardState::standing);
  body->request.write(request);
}

void Nao::note_missing(Missing what, double now) {
  if (what != missing_) missing_since_ = now;
  missing_ = what;
  missing_for_ = what == Missing::nothing ? 0.0 : now - missing_since_;
  if (what == Missing::nothing) reported_missing_ = what;
  constexpr double kReportAfter = 2.0;  // s
  if (missing_for_ <= kReportAfter || what == reported_missing_) return;
  reported_missing_ = what;
  if (around_.tell_missing) around_.tell_missing(what);
}

Nao::Counts Nao::counts() const {
  Counts all = counts_;
  for (const std::optional<Eye>* const eye : {&upper_, &lower_}) {
    if (!*eye) continue;
    const VideoCamera::Counts camera = (*eye)->camera.counts();
    all.superseded += camera.superseded;
    all.damaged += camera.damaged;
    all.restarts += camera.restarts;
  }
  return all;
}

}  // namespace reorient::nao
