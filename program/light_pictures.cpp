// SPDX-License-Identifier: MIT
// light_pictures OUT.png [ROOM...]: images of the upper camera in a room (a panorama; else the hall), under each light
// in assets/parameters/light and under the same light. A row for each light; four directions, and one image while the
// head turns. With several rooms, a row for each: two directions, the same light and both others.
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "geometry/angle.h"
#include "program/options.h"
#include "program/robots.h"
#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/pictures/canvas/ycbcr.h"

namespace reorient {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kLooks = 5;
constexpr double kLabel = 24.0;  // pixels

RobotInstance robot_in(const std::string& room, const std::string& light, std::uint64_t seed, RoomCache& rooms) {
  RobotOptions options;
  options.room = room;
  options.seed = seed;
  options.rooms = &rooms;
  if (light != "same") {
    ParameterOptions parameters;
    parameters.files.emplace_back("light/" + light);
    options.parameters = overrides_of(parameters);
  }
  return make_robot("simulator", options);
}

/// The robot faces one of four sides; in the last image its head moves.
Observation look_at_side(RobotInstance& robot, int look) {
  constexpr int kSettle = 75;  // frames, until the exposure has adapted
  Observation observation;
  robot.the_operator->put_down(Pose2(-0.5, 0.3, 0.5 * kPi * look));
  for (int frame = 0; frame < kSettle; ++frame) {
    Answer answer;
    const bool turns = look == kLooks - 1 && frame > kSettle - 10;
    answer.request.head = HeadRequest{{turns ? 1.5 : 0.0, -0.05}, 2.5};
    robot.robot->answer(answer);
    robot.robot->observe(observation);
  }
  return observation;
}

void draw_label(pictures::Canvas& canvas, double top, const std::string& text) {
  pictures::TextStyle style;
  style.size = 16.0;
  canvas.text({6.0, top + 0.7 * kLabel}, text, style);
}

void draw_row(RobotInstance& robot, double top, pictures::Canvas& canvas) {
  for (int look = 0; look < kLooks; ++look) {
    const Observation observation = look_at_side(robot, look);
    canvas.image(pictures::to_picture(observation.upper->image),
                 {static_cast<double>(look * kWidth), top, kWidth, kHeight});
  }
}

void draw_overview(const std::string& file, const std::vector<std::string>& rooms) {
  constexpr const char* kLights[] = {"same", "mild", "hard"};
  constexpr int kSides[] = {0, 1};
  constexpr double kSmall = 0.5;  // of the image
  constexpr double kStep = kSmall * kWidth;
  pictures::Canvas canvas(static_cast<int>(kStep * std::size(kLights) * std::size(kSides)),
                          static_cast<int>(static_cast<double>(rooms.size()) * (kSmall * kHeight + kLabel)));
  RoomCache cache;
  double top = 0.0;
  for (const std::string& room : rooms) {
    draw_label(canvas, top, std::filesystem::path(room).stem().string() + ": same, mild, hard");
    double left = 0.0;
    for (const char* light : kLights) {
      RobotInstance robot = robot_in(room, light, 1, cache);
      robot.the_operator->change_light();
      for (const int side : kSides) {
        const Observation observation = look_at_side(robot, side);
        canvas.image(pictures::to_picture(observation.upper->image), {left, top + kLabel, kStep, kSmall * kHeight});
        left += kStep;
      }
    }
    top += kSmall * kHeight + kLabel;
  }
  pictures::write_png(file, canvas.finish());
}

void draw_sheet(const std::string& file, const std::string& room) {
  struct Row {
    const char* light;
    std::uint64_t seed;
  };
  // The hard lights include one with all lamps and one with half of them.
  constexpr Row kRows[] = {{"same", 1}, {"mild", 1}, {"mild", 2}, {"hard", 1}, {"hard", 2}, {"hard", 3}};
  constexpr int kCount = static_cast<int>(std::size(kRows));
  pictures::Canvas canvas(kLooks * kWidth, static_cast<int>(kCount * (kHeight + kLabel)));
  RoomCache rooms;
  double top = 0.0;
  for (const Row& row : kRows) {
    RobotInstance robot = robot_in(room, row.light, row.seed, rooms);
    robot.the_operator->change_light();
    draw_label(canvas, top, std::string(row.light) + ", seed " + std::to_string(row.seed));
    draw_row(robot, top + kLabel, canvas);
    top += kHeight + kLabel;
  }
  pictures::write_png(file, canvas.finish());
}

}  // namespace
}  // namespace reorient

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "light_pictures: expected OUT.png [ROOM...] (the file to write, panoramas), found no arguments\n";
    return 2;
  }
  try {
    if (argc > 3) {
      reorient::draw_overview(argv[1], {argv + 2, argv + argc});
    } else {
      reorient::draw_sheet(argv[1], argc > 2 ? argv[2] : "");
    }
  } catch (const std::exception& error) {
    std::cerr << "light_pictures: " << error.what() << "\n";
    return 2;
  }
  return 0;
}
