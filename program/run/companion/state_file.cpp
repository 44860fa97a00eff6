// SPDX-License-Identifier: MIT
#include "program/run/companion/state_file.h"

#include <chrono>
#include <ctime>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/record/digest.h"
#include "geometry/bytes.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

constexpr std::uint64_t kMagic = 0x33706d6f43725272ull;  // "rRrComp3": another layout gets another number
constexpr double kPeriod = 1.0, kUrgentPeriod = 0.1;     // s
constexpr double kOldest = 600.0;                        // s; a robot that was not tracked for longer may be anywhere

/// When a state was saved. A clock that is set, as often after a robot started without a network, must not make the
/// state old or new: within one start of the computer, only the time since that start counts.
struct SavingTime {
  double wall = 0.0;   ///< s, of the clock that can be set
  std::string start;   ///< identity of the computer's last start; empty: unknown
  double since = 0.0;  ///< s since that start
};
template <typename Visit, ConstOr<SavingTime> T>
void fields(Visit&& visit, T& time) {
  visit(time.wall, time.start, time.since);
}

SavingTime saving_time() {
  static const std::string start = [] {
    std::string identity;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> identity;
    return identity;
  }();
  SavingTime now;
  now.wall = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  now.start = start;
  timespec since{};
  clock_gettime(CLOCK_BOOTTIME, &since);
  now.since = static_cast<double>(since.tv_sec) + 1e-9 * static_cast<double>(since.tv_nsec);
  return now;
}

void require_recent(const SavingTime& saved) {
  const SavingTime now = saving_time();
  const bool is_one_start = !now.start.empty() && saved.start == now.start;
  const double age = is_one_start ? now.since - saved.since : now.wall - saved.wall;
  check_bytes(age <= kOldest, "saved more than 10 minutes ago");
  check_bytes(age >= -kPeriod, "saved later than now, by the clock of the computer");
}

std::uint64_t digest_of(std::span<const std::byte> bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.value();
}

/// Reads the file only if it belongs to this user: its content becomes scripts that run, its digest is not secret, and
/// in a folder such as /tmp each user may write. Returns nothing if the file is missing, or, with `why_not`, another
/// user's or too large.
std::optional<std::string> read_own_file(const std::filesystem::path& file, std::string& why_not) {
  const OwnedDescriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!opened || fstat(opened.get(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  if (status.st_uid != geteuid()) {
    why_not = "the file belongs to another user";
    return std::nullopt;
  }
  try {
    return read_input("/proc/self/fd/" + std::to_string(opened.get()), "a saved state");
  } catch (const std::runtime_error& reason) {
    why_not = reason.what();
    return std::nullopt;
  }
}

}  // namespace

void require_no_link(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_symlink(file, error))
    throw std::runtime_error("--state " + file.string() +
                             ": expected a file, found a symbolic link; name the file itself");
}

std::filesystem::path aside_of(const std::filesystem::path& file) { return file.string() + ".other"; }

StateKeeper::StateKeeper(std::filesystem::path file, std::string circumstances)
    : file_(std::move(file)), circumstances_(std::move(circumstances)) {}

/// The digest comes first, and covers everything after it.
std::vector<std::byte> StateKeeper::bytes_of(const FrameLoop& engine, Companion& companion) const {
  std::vector<std::byte> state;
  engine.save(state);
  std::vector<std::byte> rest;
  ByteWriter out(rest);
  out(circumstances_, saving_time(), state, companion);
  std::vector<std::byte> all;
  ByteWriter whole(all);
  whole(kMagic, digest_of(rest));
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

void StateKeeper::keep(const FrameLoop& engine, Companion& companion, double now, bool is_urgent) {
  is_urgent_ |= is_urgent;
  release_command(companion);
  const bool is_due = companion.unstored_command() || now - last_ >= (is_urgent_ ? kUrgentPeriod : kPeriod);
  if (!is_due || writing_.is_busy()) return;  // the next frame tries again
  last_ = now;
  is_urgent_ = false;
  begin_writing(engine, companion);
}

void StateKeeper::release_command(Companion& companion) {
  if (!writing_command_ || writing_.is_busy()) return;
  companion.set_stored(*writing_command_);
  writing_command_.reset();
}

void StateKeeper::finish(const FrameLoop& engine, Companion& companion) {
  begin_writing(engine, companion);
  writing_.end();
}

void StateKeeper::begin_writing(const FrameLoop& engine, Companion& companion) {
  writing_command_ = companion.unstored_command();
  if (std::exchange(is_of_another_, false)) {
    std::error_code failed;
    std::filesystem::rename(file_, aside(), failed);
    // The robot that is connected needs the file more than the other one.
    if (failed)
      spdlog::warn("{}: cannot be written, so the state of the other robot is lost: {}", aside().string(),
                   failed.message());
  }
  writing_.start([bytes = bytes_of(engine, companion), file = file_] {
    require_no_link(file);
    write_whole_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
}

std::unique_ptr<FrameLoop> StateKeeper::restore(Companion& companion, std::string& why_not) {
  why_not.clear();
  is_of_another_ = false;
  std::unique_ptr<FrameLoop> engine = read(file_, companion, why_not);
  if (!is_of_another_) return engine;
  std::string why_not_aside;
  engine = read(aside(), companion, why_not_aside);
  is_of_another_ = true;  // whatever the second file contains
  if (engine) why_not.clear();
  return engine;
}

std::unique_ptr<FrameLoop> StateKeeper::read(const std::filesystem::path& file, Companion& companion,
                                             std::string& why_not) {
  const std::optional<std::string> text = read_own_file(file, why_not);
  if (!text) return nullptr;
  const auto bytes = std::as_bytes(std::span(*text));
  constexpr std::size_t kHeader = 2 * sizeof(std::uint64_t);
  try {
    ByteReader in(bytes);
    std::uint64_t magic = 0, digest = 0;
    in(magic, digest);
    check_bytes(magic == kMagic, "saved by another version");
    check_bytes(digest == digest_of(bytes.subspan(kHeader)), "damaged (digest mismatch)");
    std::string circumstances;
    SavingTime saved;
    in(circumstances, saved);
    require_recent(saved);
    is_of_another_ = circumstances != circumstances_;
    if (is_of_another_) {
      const auto version = [](const std::string& all) { return all.substr(0, all.find(' ')); };
      why_not = version(circumstances) == version(circumstances_)
                    ? "saved for another robot, field, set of behaviors, parameters or options"
                    : "saved by another version";
      return nullptr;
    }
    std::vector<std::byte> state;
    in(state);
    auto engine = std::make_unique<FrameLoop>(state);
    in(companion);
    in.finish();
    return engine;
  } catch (const BadBytes& bad) {
    why_not = bad.what();
    return nullptr;
  }
}

}  // namespace reorient
