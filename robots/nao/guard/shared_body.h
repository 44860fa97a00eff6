// SPDX-License-Identifier: MIT
// The memory that guard, engine and perhaps a walk share: the last 64 measurements on the one hand, the newest request
// and the walk's joints on the other. Each value has one writer.
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
  static constexpr std::uint64_t kLayout = 0x5265'6f72'6965'6e02u;  // the last byte counts its versions

  std::atomic<std::uint64_t> layout = 0;    ///< kLayout, once all else has begun
  std::atomic<std::uint64_t> measured = 0;  ///< how many measurements there ever were
  std::array<SharedValue<Measurement>, kMeasurements> measurements;
  SharedValue<GuardReport> report;
  SharedValue<BodyRequest> request;
  SharedValue<WalkTargets> walk;  ///< never written without a walk

  /// The guard's.
  void add(const Measurement& measurement);
  /// Reads the newest measurement. Returns false if none exists or it is being written.
  bool newest(Measurement& measurement) const;
  /// Appends those that came after the first `seen` ones, the oldest first; how many there ever were. What was
  /// overwritten meanwhile is left out.
  std::uint64_t news(std::uint64_t seen, std::vector<Measurement>& later) const;
};

/// A file in memory that both map. Its mode is 0600, and its name holds the user's number.
std::filesystem::path default_body_file();

/// A mapping of the file.
class MappedBody {
 public:
  enum class Side { guard, engine, walk };
  /// The guard creates the file if it is missing, and locks it; only one engine may send requests. Engine and walk open
  /// the file of a guard, and map nothing if it does not exist yet. Throws std::runtime_error with one line if another
  /// guard or engine uses the file, or if it is not a guard's file.
  MappedBody(const std::filesystem::path& file, Side side);

  ~MappedBody();
  MappedBody(const MappedBody&) = delete;
  MappedBody& operator=(const MappedBody&) = delete;

  explicit operator bool() const { return body_ != nullptr; }
  SharedBody& operator*() const { return *body_; }
  SharedBody* operator->() const { return body_; }

 private:
  void close_all();

  int file_ = -1;  // stays open as long as the mapping: the guard's and the engine's lock lie on it
  SharedBody* body_ = nullptr;
};

}  // namespace reorient::nao
