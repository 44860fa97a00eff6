// SPDX-License-Identifier: MIT
// companion_latency PROGRAM [SECONDS]: measures the time from an image at a client of the companion to the answer, in
// real time with 30 images of 640x480 pixels per second, which are rendered before. PROGRAM is `reorient`.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#define REORIENT_COMPANION_CLIENT
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>

#include "robots/companion/reorient_companion.h"
#include "robots/simulator/simulator.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

struct Shot {
  Image image;
  HeadAngles head;
  Pose2 odometry;
  CameraModel camera;
};

/// A robot that walks and scans with its head.
std::vector<Shot> rendered(int count) {
  SimulatorParameters parameters;
  parameters.width = 640;
  const FieldDimensions field;
  Simulator simulator(parameters, RobotBody(), field, procedural_hall(1, RoomShape()), Pose2(-2.0, 0.5, 0.3), 1);
  std::vector<Shot> shots;
  Observation seen;
  Answer answer;
  for (int i = 0; i < count; ++i) {
    simulator.observe(seen);
    Shot shot{Image(640, 480), seen.body.head, seen.odometry, seen.upper->camera};
    for (int y = 0; y < 480; ++y) std::memcpy(shot.image.row(y), seen.upper->image.row(y), 2 * 640);
    shots.push_back(std::move(shot));
    answer.request.head = HeadRequest{{1.1 * std::sin(0.05 * i), 0.0}, 2.0};
    answer.request.walk = {0.15, 0.0, 0.1};
    simulator.answer(answer);
  }
  return shots;
}

reorient_hello hello_of(const CameraModel& camera) {
  reorient_hello hello{};
  std::random_device lot;
  hello.client = (static_cast<std::uint64_t>(lot()) << 32) | lot();
  hello.way = REORIENT_OUR_LOCALIZATION;
  hello.wants = REORIENT_WANT_HEAD | REORIENT_WANT_WALK;
  std::strcpy(hello.body.name, "nao-v6");
  hello.cameras[0].width = 640;
  hello.cameras[0].height = 480;
  hello.cameras[0].format = REORIENT_YUYV;
  const RobotDimensions nao;
  for (int i = 0; i < 2; ++i) {
    hello.cameras[0].focal[i] = camera.focal[i];
    hello.cameras[0].center[i] = camera.center[i];
  }
  for (int i = 0; i < 3; ++i) hello.cameras[0].position[i] = nao.upper.position[i];
  hello.cameras[0].tilt = nao.upper.tilt;
  return hello;
}

/// ms; negative: no answer within a second.
double exchanged(reorient_client& client, const Shot& shot, double time, bool first) {
  reorient_frame frame{};
  const Clock::time_point begin = Clock::now();
  unsigned char* const pixels = reorient_image_begin(&client, 0);
  std::memcpy(pixels, shot.image.bytes().data(), shot.image.bytes().size());
  reorient_image_written(&client, 0, &frame);
  frame.time = time;
  frame.has = REORIENT_HAS_TIME | REORIENT_HAS_HEAD;
  frame.head[0] = shot.head.yaw;
  frame.head[1] = shot.head.pitch;
  frame.odometry[0] = shot.odometry.position.x();
  frame.odometry[1] = shot.odometry.position.y();
  frame.odometry[2] = shot.odometry.rotation;
  if (first) {
    frame.has |= REORIENT_HAS_TOLD_POSE;
    frame.told_pose[0] = -2.0;
    frame.told_pose[1] = 0.5;
    frame.told_pose[2] = 0.3;
    frame.told_deviation[0] = frame.told_deviation[1] = 0.1;
  }
  if (reorient_send_frame(&client, &frame, nullptr, nullptr) == 0) return -1.0;
  while (Clock::now() - begin < std::chrono::seconds(1)) {
    reorient_event event;
    while (const int kind = reorient_receive(&client, &event)) {
      if (kind == REORIENT_ANSWER && event.answer.number == frame.number)
        return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    }
    pollfd wait{client.socket, POLLIN, 0};
    poll(&wait, 1, 100);
  }
  return -1.0;
}

int measure(const char* program, double seconds) {
  const std::vector<Shot> shots = rendered(150);
  const std::string socket = "/tmp/reorient-latency-" + std::to_string(getpid());
  const pid_t server = fork();
  if (server == 0) {
    execl(program, program, "--log", "off", "run", "--robot", "companion", "--fresh", "--socket", socket.c_str(),
          nullptr);
    _exit(127);
  }
  static reorient_client client;
  const reorient_hello hello = hello_of(shots.front().camera);
  const Clock::time_point latest = Clock::now() + std::chrono::seconds(30);
  while (reorient_open(&client, socket.c_str(), &hello) != 0) {  // the server does not listen yet
    if (Clock::now() > latest) return std::perror("companion_latency"), 2;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::vector<double> times;
  int lost = 0;
  const Clock::time_point begin = Clock::now();
  const int frames = static_cast<int>(30.0 * seconds);
  for (int i = 0; i < frames; ++i) {
    std::this_thread::sleep_until(begin + std::chrono::duration<double>(i / 30.0));
    // Forward and backward, so that the views do not jump.
    const auto last = static_cast<int>(shots.size()) - 1;
    const int place = i % (2 * last);
    const double time =
        exchanged(client, shots[static_cast<std::size_t>(place <= last ? place : 2 * last - place)], i / 30.0, i == 0);
    if (time < 0.0) {
      ++lost;
    } else if (i > 30) {  // not the first second, in which the companion creates the engine
      times.push_back(time);
    }
  }
  reorient_close(&client);
  kill(server, SIGTERM);
  waitpid(server, nullptr, 0);
  if (times.empty()) return std::fprintf(stderr, "companion_latency: no answers\n"), 1;
  std::sort(times.begin(), times.end());
  const auto share = [&](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  std::printf("%zu answers to images of 640x480 at 30 Hz: median %.2f ms, 99 %% %.2f ms, longest %.2f ms; %d lost\n",
              times.size(), share(0.5), share(0.99), times.back(), lost);
  return 0;
}

}  // namespace
}  // namespace reorient

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "companion_latency PROGRAM [SECONDS]\n"), 2;
  return reorient::measure(argv[1], argc > 2 ? std::atof(argv[2]) : 30.0);
}
