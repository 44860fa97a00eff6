// SPDX-License-Identifier: MIT
// What a companion knew, in a file: the next process goes on from it, as if it had only been slow.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "program/background_writing.h"
#include "robots/companion/companion.h"

namespace reorient {

/// In a folder that is everybody's a link may be anybody's, and lead to what must not be written over. Throws
/// std::runtime_error with one line.
void require_no_link(const std::filesystem::path& file);

/// Saves once a second, and at once what a client says only once. A disk is slow: no frame waits for it.
class StateKeeper {
 public:
  /// `circumstances`: of two processes that shall go on from each other they are equal. Empty file: keeps nothing.
  StateKeeper(std::filesystem::path file, std::string circumstances);

  /// Between two frames; `now`: s, of a clock that only goes on. `is_urgent`: the frame before told what nobody will
  /// tell again; a client that tells with every frame is kept ten times a second.
  void keep(const FrameLoop& engine, Companion& companion, double now, bool is_urgent);
  /// The last of it, when the run ends.
  void finish(const FrameLoop& engine, Companion& companion);

  /// An engine that goes on, and a companion that knows it. Nothing: there is no such file, or `why_not` says in a few
  /// words what it is instead. What another robot knew is put aside with the first that is saved, as FILE.other, and
  /// looked for there.
  std::unique_ptr<FrameLoop> restore(Companion& companion, std::string& why_not);

 private:
  std::vector<std::byte> bytes_of(const FrameLoop& engine, Companion& companion) const;
  std::filesystem::path aside() const { return file_.string() + ".other"; }
  std::unique_ptr<FrameLoop> read(const std::filesystem::path& file, Companion& companion, std::string& why_not);
  void begin_writing(const FrameLoop& engine, Companion& companion);

  std::filesystem::path file_;
  std::string circumstances_;
  bool is_of_another_ = false;  // what is in the file, and has not been put aside yet
  double last_ = -1e9;          // s, when it was kept
  bool is_urgent_ = false;      // since then
  BackgroundWriting writing_;
};

}  // namespace reorient
