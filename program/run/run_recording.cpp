// SPDX-License-Identifier: MIT
#include "program/run/run_recording.h"

#include <cerrno>
#include <charconv>
#include <ctime>
#include <ostream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/robots.h"
#include "workbench/files/atomic_file.h"
#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/source.h"

namespace reorient {
namespace {

/// The number behind `key` in "every:5"; nothing for another text or a number outside 1 to `most`.
std::optional<int> number_behind(std::string_view key, const std::string& option, int most) {
  if (!option.starts_with(key)) return std::nullopt;
  const char* const end = option.data() + option.size();
  int number = 0;
  const auto [stop, error] = std::from_chars(option.data() + key.size(), end, number);
  if (stop != end || error != std::errc() || number < 1 || number > most) return std::nullopt;
  return number;
}

constexpr int kMostFrames = 1000000;

/// "lossless": 1, "every:5": 5, "none": 0.
int images_every(const std::string& option) {
  if (option == "lossless") return 1;
  if (option == "none") return 0;
  if (const auto every = number_behind("every:", option, kMostFrames)) return *every;
  throw std::runtime_error("--record-images: expected lossless, every:N (each Nth frame) or none, found '" + option +
                           "'");
}

int particles_every(const std::string& option) {
  if (option == "none") return 0;
  if (const auto every = number_behind("every:", option, kMostFrames)) return *every;
  throw std::runtime_error("--view-particles: expected every:N (each Nth frame) or none, found '" + option + "'");
}

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
    throw std::runtime_error("--record-rotate: expected a size or a time, as in 500MB, 2GB, 90s or 10min, found '" +
                             option + "'");
  }
}

/// A further file of a rotated recording: run.2.mcap. Nothing if none exists.
std::optional<std::filesystem::path> further_part(const std::filesystem::path& first) {
  const std::string stem = first.stem().string() + ".", extension = first.extension().string();
  std::error_code error;
  const std::filesystem::path folder = first.has_parent_path() ? first.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.size() <= stem.size() + extension.size() || !name.starts_with(stem) || !name.ends_with(extension))
      continue;
    const std::string number = name.substr(stem.size(), name.size() - stem.size() - extension.size());
    if (number.find_first_not_of("0123456789") == std::string::npos) return entry.path();
  }
  return std::nullopt;
}

/// Creates an empty file with the first name for which neither a file nor a further part exists: two programs that
/// start together must not choose the same name. If that is not possible, the recorder reports why.
std::filesystem::path reserved_name(const std::filesystem::path& first) {
  std::error_code error;
  if (std::filesystem::is_other(first, error)) return first;  // a pipe has no earlier recording
  std::filesystem::path file = first;
  for (int number = 2;; ++number) {
    if (!further_part(file)) {
      const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0) close(descriptor);
      if (descriptor >= 0 || errno != EEXIST) return file;
    }
    file.replace_filename(fmt::format("{}-{}{}", first.stem().string(), number, first.extension().string()));
  }
}

}  // namespace

void require_new_or_recording(const std::filesystem::path& file, const std::string& option) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) == 0) return;
  if (mcap::is_mcap(mcap::FileSource(file))) return;
  throw std::runtime_error(
      option + " " + file.string() +
      ": expected a new file or a recording, found another file, which was not changed; name another one");
}

int viewer_image_quality(const std::string& mode, const std::string& option) {
  if (mode == "none") return 0;
  if (const auto quality = number_behind("jpeg:", mode, 100)) return *quality;
  throw std::runtime_error(option + ": expected jpeg:Q (a quality from 1 to 100) or none, found '" + mode + "'");
}

RecorderOptions recorder_options(const RecordOptions& options, const std::filesystem::path& file,
                                 bool further_parts_are_refused) {
  RecorderOptions recorder;
  recorder.images_every = images_every(options.record_images);
  recorder.jpeg_quality = viewer_image_quality(options.view_images, "--view-images");
  recorder.particles_every = particles_every(options.view_particles);
  recorder.file = file;
  if (file.empty()) return recorder;
  require_writable_file(file, "--record");
  require_new_or_recording(file, "--record");
  if (!options.record_rotate.empty()) {
    read_rotation(options.record_rotate, recorder);
    // The user did not name the further files: they must not be overwritten, nor seem to belong to this run.
    if (const auto part = further_part(file); part && further_parts_are_refused) {
      throw std::runtime_error(
          "--record-rotate: " + part->string() +
          ": expected no part of an earlier run, found one; move it away, or name another file with "
          "--record");
    }
  }
  return recorder;
}

std::optional<RecorderOptions> recorder_options(const RunOptions& options, const std::string& venue) {
  const bool is_simulated = options.robot == kSimulator || options.robot == kFootage;
  RecorderOptions recorder = recorder_options(options, options.record, is_simulated);
  if (options.record.empty()) return std::nullopt;
  recorder.about = {{"version", REORIENT_VERSION},
                    {"robot", options.robot},
                    {"venue", venue},
                    {"seed", std::to_string(options.seed)},
                    {"images", options.record_images}};
  if (is_simulated) recorder.about.emplace("scenario", options.scenario);
  return recorder;
}

RunRecording::RunRecording(std::optional<RecorderOptions> options, std::function<void(const std::string&)> tell,
                           EarlierRecording earlier) {
  if (!options) return;
  if (earlier == EarlierRecording::stays) options->file = reserved_name(options->file);
  options->about.emplace("begun", fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(std::time(nullptr))));
  file_ = options->file;
  recorder_.emplace(*std::move(options), std::move(tell));
}

void RunRecording::end(std::ostream& out, const std::string& digest) {
  if (!recorder_) return;
  recorder_->end();
  const Recorder::Counts counts = recorder_->counts();
  out << fmt::format("recording: {}{}, {}, {:.1f} MB{}\n", as_line(file_.string()),
                     counts.files > 1 ? fmt::format(" and {} more", counts.files - 1) : "",
                     counted(counts.frames, "frame"), 1e-6 * static_cast<double>(counts.bytes),
                     digest.empty() ? "" : ", digest " + digest);
  if (counts.views_left_out > 0)
    out << fmt::format("  {} without images for viewers, because the disk or processor was too slow\n",
                       counted(counts.views_left_out, "frame"));
  if (counts.images_left_out > 0) {
    out << fmt::format(
        "  {} without images, because the disk or processor was too slow; after {:.1f} s not all frames can be "
        "replayed\n",
        counted(counts.images_left_out, "frame"), counts.exact_until);
  }
}

}  // namespace reorient
