// SPDX-License-Identifier: MIT
#include "tests/robots/nao/twin/twin_nao.h"

#include "robots/nao/guard/postures.h"
#include "robots/nao/lola/command_packet.h"
#include "robots/nao/lola/sensor_packet.h"

namespace reorient::nao {
namespace {

constexpr int kCyclesPerFrame = 3;

/// Three cycles per frame, the nearest to 30 images per second.
SimulatorParameters in_step(SimulatorParameters parameters) {
  parameters.frame_rate = 1.0 / (kCyclesPerFrame * kCycle);
  parameters.body_samples = kCyclesPerFrame;
  return parameters;
}

}  // namespace

TwinNao::TwinNao(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field, const Room& room,
                 const Pose2& start, std::uint64_t seed)
    : simulator_(in_step(parameters), body, field, room, start, seed) {}

/// Simulates the next frame: samples of the body, and the image at its end.
void TwinNao::look() {
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
  picture_lead_ = observation.upper->time - samples_.back().time;
}

std::size_t TwinNao::feel(std::span<std::byte> packet) {
  if (samples_.empty()) look();
  const BodySample felt = samples_.front();
  samples_.pop_front();
  body_.step();

  const auto number = [](double value) { return static_cast<float>(value); };
  body_.set_head(number(felt.head.yaw), number(felt.head.pitch));
  Measurement measurement = body_.measurement();
  measurement.angles = {number(felt.torso.roll), number(felt.torso.pitch)};
  measurement.gyroscope = {number(felt.angular_velocity.x()), number(felt.angular_velocity.y()),
                           number(felt.angular_velocity.z())};
  measurement.accelerometer = {number(-felt.acceleration.x()), number(-felt.acceleration.y()),
                               number(-felt.acceleration.z())};
  measurement.fsr.fill(number(felt.foot_load / 8.0));
  return write_sensor_packet(measurement, body_.identity(), packet);
}

bool TwinNao::take(std::span<const std::byte> packet) {
  Command command;
  if (!read_command_packet(packet, command)) return false;
  take(command);
  return true;
}

void TwinNao::take(const Command& command) {
  command_ = command;
  body_.take(command);
}

void TwinNao::show(double now) {
  if (samples_.empty()) camera_.expose(picture_, now + picture_lead_);
}

}  // namespace reorient::nao
