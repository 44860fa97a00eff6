// SPDX-License-Identifier: MIT
// The input of a terminal, key by key.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace reorient {

/// Bytes become keys: a letter in UTF-8, a control character, or an escape sequence as a whole. Other input (bytes
/// that are not UTF-8, unknown sequences) is left out.
class KeyQueue {
 public:
  /// `sequences`: the known sequences, each beginning with ESC.
  explicit KeyQueue(std::set<std::string, std::less<>> sequences) : sequences_(std::move(sequences)) {}

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// Nothing if no key is complete yet.
  std::optional<std::string> next();
  /// Takes the incomplete key if its rest does not arrive: the Escape key alone sends only ESC.
  void drop_begun() { bytes_.clear(); }
  bool empty() const { return bytes_.empty(); }

 private:
  std::string bytes_;
  std::set<std::string, std::less<>> sequences_;
};

}  // namespace reorient
