#include "program/recording/run_recording.h"

#include <charconv>
#include <ctime>
#include <ostream>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include "workbench/files/atomic_file.h"

namespace reorient {

int images_every(const std::string& option) {
  if (option == "lossless") return 1;
  if (option == "none") return 0;
  constexpr std::string_view kEvery = "every:";
  int every = 0;
  if (option.starts_with(kEvery)) {
    const char* const end = option.data() + option.size();
    const auto [stop, error] = std::from_chars(option.data() + kEvery.size(), end, every);
    if (stop == end && error == std::errc() && every >= 1) return every;
  }
  throw std::runtime_error("--record-images " + option + ": it is lossless, every:N (each Nth frame) or none");
}

namespace {

/// "500MB", "2GB", "90s", "10min".
void read_rotation(const std::string& option, RecorderOptions& recorder) {
  const char* const end = option.data() + option.size();
  double number = 0.0;
  const auto [stop, error] = std::from_chars(option.data(), end, number);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const bool is_sound = error == std::errc() && number >= 1.0 && number <= 1e6;
  if (is_sound && (unit == "MB" || unit == "GB")) {
    recorder.rotate_bytes = static_cast<std::uint64_t>(number * (unit == "MB" ? 1e6 : 1e9));
  } else if (is_sound && (unit == "s" || unit == "min")) {
    recorder.rotate_seconds = number * (unit == "s" ? 1.0 : 60.0);
  } else {
    throw std::runtime_error("--record-rotate " + option + ": it is a size or a time, as in 500MB, 2GB, 90s or 10min");
  }
}

}  // namespace

RunRecording::RunRecording(const RunOptions& options, const std::string& venue,
                           std::function<void(const std::string&)> tell, int part)
    : file_(options.record) {
  const int every = images_every(options.record_images);
  if (file_.empty()) return;
  if (part > 1) file_.replace_filename(fmt::format("{}-{}{}", file_.stem().string(), part, file_.extension().string()));
  require_writable_file(file_, "--record");
  RecorderOptions recorder;
  recorder.file = file_;
  recorder.images_every = every;
  if (!options.record_rotate.empty()) read_rotation(options.record_rotate, recorder);
  recorder.about = {{"version", REORIENT_VERSION},
                    {"robot", options.robot},
                    {"venue", venue},
                    {"seed", std::to_string(options.seed)},
                    {"images", options.record_images},
                    {"begun", fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(std::time(nullptr)))}};
  if (options.robot == "simulator") recorder.about.emplace("scenario", options.scenario);
  recorder_.emplace(std::move(recorder), std::move(tell));
}

void RunRecording::end(std::ostream& out) {
  if (!recorder_) return;
  recorder_->end();
  const Recorder::Counts counts = recorder_->counts();
  out << fmt::format("recording: {}{}, {} frames, {:.1f} MB\n", file_.string(),
                     counts.files > 1 ? fmt::format(" and {} more", counts.files - 1) : "", counts.frames,
                     1e-6 * static_cast<double>(counts.bytes));
  if (counts.images_left_out > 0) {
    out << fmt::format("  {} frames lack images, since the disk was slow; from {:.1f} s on not all can be replayed\n",
                       counts.images_left_out, counts.exact_until);
  }
}

}  // namespace reorient
