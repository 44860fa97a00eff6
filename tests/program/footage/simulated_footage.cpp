// SPDX-License-Identifier: MIT
#include "tests/program/footage/simulated_footage.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/parameter.h"
#include "geometry/random.h"
#include "program/robots.h"
#include "workbench/views/pictures/canvas/png_file.h"

namespace reorient {
namespace {

/// BT.601, full range.
pictures::Picture rgb_of(const ImageView& image) {
  pictures::Picture picture{image.width, image.height, {}};
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); };
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Ycbcr color = image.at(x, y);
      const double cb = color.cb - 128.0, cr = color.cr - 128.0;
      for (const double value : {color.y + 1.402 * cr, color.y - 0.344136 * cb - 0.714136 * cr, color.y + 1.772 * cb})
        picture.bytes.push_back(byte(value));
    }
  }
  return picture;
}

}  // namespace

void write_image(const std::filesystem::path& file, const ImageView& image) {
  pictures::write_png(file, rgb_of(image));
}

void write_offset_footage(const std::filesystem::path& folder, const OffsetFootageOptions& options) {
  constexpr int kFramesForAnImage = 6;  // of 30 a second
  std::filesystem::create_directories(folder / "images");
  std::ofstream table(folder / "frames.csv");
  table << "image,time_s,x_m,y_m,rotation_rad,camera_height_m,roll_rad,pitch_rad,camera_yaw_rad\n";
  RobotOptions robot_options;
  robot_options.width = options.width;
  robot_options.seed = options.seed;
  robot_options.hall_seed = options.seed;
  for (const char* const name :
       {"body.attitude_bias", "body.attitude_noise", "body.head_noise", "simulator.tilt_error"})
    robot_options.parameters.push_back({name, "0", ParameterOrigin::file, "the test"});
  const RobotInstance robot = make_robot(kSimulator, robot_options);
  Random random(options.seed, 0x0ff5e7);
  const double x = random.uniform(-3.0, 3.0), y = random.uniform(-2.0, 2.0);
  robot.the_operator->put_down(Pose2(x, y, random.uniform(-kPi, kPi)));
  Observation observation;
  Answer answer;
  answer.request.walk = {0.1, 0.0, 0.4};
  for (int frame = 0, image = 0; image < options.images; ++frame) {
    if (!robot.robot->observe(observation)) return;
    answer.request.head = HeadRequest{{0.8 * std::sin(0.03 * frame), 0.2 + 0.2 * std::sin(0.07 * frame)}, 1.0};
    robot.robot->answer(answer);
    if (frame % kFramesForAnImage != 0) continue;
    const CameraFrame& upper = *observation.upper;
    const std::string name = fmt::format("images/{:04}.png", image++);
    write_image(folder / name, upper.image);
    const Isometry3& camera = upper.robot_from_camera;
    const Pose2 truth = robot.truth->truth()->pose;
    const Eigen::Vector2d below = truth * Eigen::Vector2d(camera.translation().head<2>());
    // turned() is undone: camera = recorded * offset.
    const Isometry3 offset = turned(Isometry3::Identity(), options.offset);
    const Eigen::Matrix3d recorded = camera.linear() * offset.linear().transpose();
    table << fmt::format("{},{},{},{},{},{},{},{},{}\n", name, upper.time, below.x(), below.y(), truth.rotation,
                         camera.translation().z() - options.offset.height, std::atan2(recorded(2, 1), recorded(2, 2)),
                         std::asin(-recorded(2, 0)), std::atan2(recorded(1, 0), recorded(0, 0)));
  }
}

void write_simulated_footage(const std::filesystem::path& folder, int images, int width, double head_pitch,
                             double lens_blur) {
  constexpr int kFramesForAnImage = 6;  // of 30 a second
  std::filesystem::create_directories(folder / "images");
  std::ofstream table(folder / "frames.csv");
  table << "image,time_s,x_m,y_m,rotation_rad,odometry_x_m,odometry_y_m,odometry_rotation_rad,camera_height_m,roll_rad,"
           "pitch_rad,camera_yaw_rad\n";
  RobotOptions options;
  options.width = width;
  options.parameters.push_back({"sensor.blur_angle", fmt::format("{}", lens_blur), ParameterOrigin::file, "the test"});
  const RobotInstance robot = make_robot(kSimulator, options);
  robot.the_operator->put_down(Pose2(1.0, 0.5, 0.3));
  Observation observation;
  Answer answer;
  answer.request.walk = {0.1, 0.0, 0.4};
  for (int frame = 0, image = 0; image < images; ++frame) {
    if (!robot.robot->observe(observation)) return;
    answer.request.head = HeadRequest{{0.8 * std::sin(0.1 * frame), head_pitch}, 2.0};
    robot.robot->answer(answer);
    if (frame % kFramesForAnImage != 0) continue;
    const CameraFrame& upper = *observation.upper;
    const std::string name = fmt::format("images/{:04}.png", image++);
    write_image(folder / name, upper.image);
    const Pose2 truth = robot.truth->truth()->pose;
    const Pose2& odometry = upper.odometry;
    const Eigen::Matrix3d camera = upper.robot_from_camera.linear();
    table << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", name, upper.time, truth.position.x(),
                         truth.position.y(), truth.rotation, odometry.position.x(), odometry.position.y(),
                         odometry.rotation, upper.robot_from_camera.translation().z(),
                         std::atan2(camera(2, 1), camera(2, 2)), std::asin(-camera(2, 0)),
                         std::atan2(camera(1, 0), camera(0, 0)));
  }
}

}  // namespace reorient
