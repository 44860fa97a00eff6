// SPDX-License-Identifier: MIT
// What a terminal sends, key by key.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace reorient {

/// Bytes become keys: a letter in UTF-8, a control character, or an escape sequence as a whole. What is no key (bytes
/// that are no UTF-8, unknown sequences) is left out.
class KeyQueue {
 public:
  /// `sequences`: those that mean something, each beginning with ESC.
  explicit KeyQueue(std::set<std::string, std::less<>> sequences) : sequences_(std::move(sequences)) {}

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// Nothing: no key is whole yet.
  std::optional<std::string> next();
  /// What is there of a key, since its rest does not come: the Escape key alone sends as much.
  void drop_begun() { bytes_.clear(); }
  bool empty() const { return bytes_.empty(); }

 private:
  std::string bytes_;
  std::set<std::string, std::less<>> sequences_;
};

}  // namespace reorient
