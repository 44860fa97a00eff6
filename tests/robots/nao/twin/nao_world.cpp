#include "tests/robots/nao/twin/nao_world.h"

#include <algorithm>
#include <array>

namespace reorient::nao {
namespace {

constexpr int kCyclesPerFrame = 3;

}  // namespace

SimulatorParameters NaoWorld::in_step(SimulatorParameters parameters) {
  parameters.frame_rate = 1.0 / (kCyclesPerFrame * kCycle);
  parameters.body_samples = kCyclesPerFrame;
  return parameters;
}

NaoWorld::NaoWorld(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field,
                   const Room& room, const Pose2& start, std::uint64_t seed)
    : simulator_(in_step(parameters), body, field, room, start, seed),
      shared_(std::make_unique<SharedBody>()),
      session_(*shared_) {
  session_.connected();
}

NaoSurroundings NaoWorld::surroundings(std::function<bool()> is_over) {
  NaoSurroundings around;
  around.now = [this] { return now_; };
  around.wait = [this](double seconds, std::span<const int> /*descriptors*/) {
    const std::uint64_t before = camera_.shown();
    for (const double end = now_ + seconds; now_ < end && camera_.shown() == before;) step();
  };
  around.is_over = std::move(is_over);
  around.body = [this] { return guard_is_hidden_ ? nullptr : shared_.get(); };
  around.upper = &camera_;
  return around;
}

/// The next frame of the simulator: what the body felt, and what was seen at its end.
void NaoWorld::look() {
  Answer answer;
  if (command_.stiffness[kHeadYaw] > 0.0f) {
    constexpr double kMotors = 7.0;  // rad/s
    answer.request.head = HeadRequest{{command_.position[kHeadYaw], command_.position[kHeadPitch]}, kMotors};
  }
  simulator_.answer(answer);
  Observation observation;
  simulator_.observe(observation);
  samples_.assign(observation.body_samples.begin(), observation.body_samples.end());
  const ImageView& image = observation.upper->image;
  picture_.clear();
  for (int y = 0; y < image.height; ++y)
    picture_.insert(picture_.end(), image.row(y), image.row(y) + static_cast<std::ptrdiff_t>(2) * image.width);
  picture_time_ = kStart + observation.upper->time;
}

void NaoWorld::step() {
  if (samples_.empty()) look();
  const BodySample felt = samples_.front();
  samples_.pop_front();
  now_ = std::max(now_, kStart + felt.time);
  body_.step();

  // Head, attitude and feet are the simulator's; all other joints are the twin's.
  const auto number = [](double value) { return static_cast<float>(value); };
  body_.set_head(number(felt.head.yaw), number(felt.head.pitch));
  Measurement measurement = body_.measurement();
  measurement.angles = {number(felt.torso.roll), number(felt.torso.pitch)};
  measurement.gyroscope = {number(felt.angular_velocity.x()), number(felt.angular_velocity.y()),
                           number(felt.angular_velocity.z())};
  measurement.accelerometer = {number(-felt.acceleration.x()), number(-felt.acceleration.y()),
                               number(-felt.acceleration.z())};
  measurement.fsr.fill(number(felt.foot_load / 8.0));
  std::array<std::byte, 2048> packet{};
  const std::size_t size = write_sensor_packet(measurement, body_.identity(), packet);
  std::copy_n(packet.begin(), size, session_.space().begin());
  session_.received(size, now_);
  while (!session_.to_send().empty()) {
    if (read_command_packet(session_.to_send(), command_)) body_.take(command_);
    session_.sent(session_.to_send().size(), now_);
  }
  if (samples_.empty()) camera_.expose(picture_, picture_time_);
}

}  // namespace reorient::nao
