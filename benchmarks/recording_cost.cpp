// SPDX-License-Identifier: MIT
// recording_cost FILE [SECONDS] [WIDTH]: measures the time that a recording adds to a frame, in real time with 30
// images of 640x480 pixels per second, in turn with an engine that records to FILE and with one that does not record.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <thread>
#include <vector>

#include "benchmarks/learned_session.h"
#include "workbench/recording/recorder.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

struct Times {
  std::vector<double> frames;  // ms
  double quantile(double share) {
    std::sort(frames.begin(), frames.end());
    return frames[static_cast<std::size_t>(share * static_cast<double>(frames.size() - 1))];
  }
};

void measure(const char* file, double seconds, int width) {
  LearnedSession plain(width), recorded(width);
  RecorderOptions options;
  options.file = file;
  Recorder recorder(options, [](const std::string& trouble) { std::fprintf(stderr, "%s\n", trouble.c_str()); });
  Times without, with;
  const auto plain_frame = [&] {
    plain.seen.observe(plain.inputs.observation);
    const auto begin = Clock::now();
    plain.engine.step(plain.inputs);
    without.frames.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  };
  const auto recorded_frame = [&] {
    recorded.seen.observe(recorded.inputs.observation);
    const auto begin = Clock::now();
    recorder.before(recorded.inputs, recorded.engine);
    const FrameRecord& record = recorded.engine.step(recorded.inputs, recorder.wanted());
    recorder.observe(record, {});
    with.frames.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  };
  constexpr std::chrono::microseconds kHalfFrame{16'667};
  auto next = Clock::now();
  for (int i = 0; i < static_cast<int>(30.0 * seconds); ++i) {
    // Half a frame apart, so that the second engine does not wait for the recorder's thread of the first.
    plain_frame();
    std::this_thread::sleep_until(next += kHalfFrame);
    recorded_frame();
    std::this_thread::sleep_until(next += kHalfFrame);
  }
  recorder.end();
  const Recorder::Counts counts = recorder.counts();
  const auto row = [](const char* name, Times& times) {
    std::printf("%-12s %8.3f %8.3f %8.3f\n", name, times.quantile(0.5), times.quantile(0.99), times.quantile(1.0));
  };
  std::printf("%-12s %8s %8s %8s\n", "ms", "median", "99 %", "longest");
  row("without", without);
  row("with", with);
  std::printf("above        %8.3f %8.3f\n%llu frames, %.0f MB a minute\n", with.quantile(0.5) - without.quantile(0.5),
              with.quantile(0.99) - without.quantile(0.99), static_cast<unsigned long long>(counts.frames),
              1e-6 * static_cast<double>(counts.bytes) * 60.0 / seconds);
}

}  // namespace
}  // namespace reorient

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "recording_cost FILE [SECONDS] [WIDTH]\n");
    return 2;
  }
  try {
    reorient::measure(words[1], count > 2 ? std::atof(words[2]) : 30.0, count > 3 ? std::atoi(words[3]) : 640);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "recording_cost: %s\n", error.what());
    return 2;
  }
}
