// SPDX-License-Identifier: MIT
// The memory that guard, engine and perhaps a walk share: the last 64 measurements, the newest request, and the joints
// of the walk. Each value has one writer.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "robots/nao/guard/body_request.h"
#include "robots/nao/guard/shared_value.h"

namespace reorient::nao {

inline constexpr std::size_t kMeasurements = 64;

struct SharedBody {
  static constexpr std::uint64_t kLayout = 0x5265'6f72'6965'6e03u;  // the last byte is the version

  std::atomic<std::uint64_t> layout = 0;    ///< kLayout, written after all other values are initialized
  std::atomic<std::uint64_t> measured = 0;  ///< number of measurements since the start
  std::array<SharedValue<Measurement>, kMeasurements> measurements;
  SharedValue<GuardReport> report;
  SharedValue<BodyRequest> request;
  SharedValue<WalkTargets> walk;  ///< never written without a walk

  /// Adds a measurement; only the guard may call it.
  void add(const Measurement& measurement);
  /// Reads the newest measurement. Returns false if none exists or it is being written.
  bool newest(Measurement& measurement) const;
  /// Appends the measurements after the first `seen` ones, the oldest first, without those that were overwritten.
  /// Returns the number of measurements since the start.
  std::uint64_t news(std::uint64_t seen, std::vector<Measurement>& later) const;
};

/// Default path of the file that all map. Its mode is 0600, and its name contains the user's number. A guard removes it
/// when it ends.
std::filesystem::path default_body_file();

/// A mapping of the file.
class MappedBody {
 public:
  enum class Side { guard, engine, walk };
  /// The guard creates the file if it is missing, and locks it; only one engine may send requests. Engine and walk open
  /// the file of a guard, and map nothing if it does not exist yet. Throws std::runtime_error with one line if another
  /// guard or engine uses the file, if it is not a guard's file, or if other users may write to it. From then on the
  /// process survives that another program truncates the file: the values are then those of a new file.
  MappedBody(const std::filesystem::path& file, Side side);

  /// The guard removes its file.
  ~MappedBody();
  MappedBody(const MappedBody&) = delete;
  MappedBody& operator=(const MappedBody&) = delete;

  explicit operator bool() const { return body_ != nullptr; }
  SharedBody& operator*() const { return *body_; }
  SharedBody* operator->() const { return body_; }

  /// For the guard, in each cycle: makes a file usable again that another program truncated. Returns whether it was.
  bool restore();

 private:
  void close_all();

  std::filesystem::path path_;
  Side side_;
  int file_ = -1;  // stays open as long as the mapping, because guard and engine hold locks on it
  SharedBody* body_ = nullptr;
};

}  // namespace reorient::nao
