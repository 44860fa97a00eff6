// SPDX-License-Identifier: MIT
// The parts of a NAO in this process: the guard's memory, two cameras, the referee's port, and their common clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "robots/nao/nao.h"
#include "robots/nao/udp_referee.h"

namespace reorient {

class NaoHardware {
 public:
  struct Options {
    std::filesystem::path guard;  ///< its shared memory; empty: its default
    bool both_cameras = false;
    bool hears_referee = false;
  };
  /// Throws std::runtime_error with one line if the referee's port cannot be opened.
  explicit NaoHardware(const Options& options);

  /// Valid as long as this object. `tell`: called with lines for the operator, such as a part that is missing
  /// for a while, with the fix.
  nao::NaoSurroundings surroundings(std::function<bool()> is_over, std::function<void(const std::string&)> tell);

 private:
  nao::SharedBody* guards_memory(double now);

  std::filesystem::path guard_;
  std::optional<nao::MappedBody> mapped_;
  nao::SharedBody* body_ = nullptr;  // nullptr: no guard
  std::uint64_t measured_ = 0;
  double next_look_ = 0.0;  // s
  nao::SystemVideoDevice upper_, lower_;
  bool both_cameras_;
  std::unique_ptr<nao::UdpReferee> referee_;
};

}  // namespace reorient
