// SPDX-License-Identifier: MIT
// The button on the chest: distinguishes short and long presses.
#pragma once

#include <optional>

namespace reorient::nao {

class ChestButton {
 public:
  enum class Press { none, brief, lasting };

  /// Call in each cycle with the state of the button at `time` (s). Returns a long press while it lasts, a short press
  /// when it ends.
  Press update(bool is_down, double time) {
    constexpr double kLasting = 3.0, kBounce = 0.03;  // s
    if (!is_down) {
      const bool counts = since_ && !reported_ && time - *since_ > kBounce;
      since_.reset();
      reported_ = false;
      return counts ? Press::brief : Press::none;
    }
    if (!since_) since_ = time;
    if (reported_ || time - *since_ < kLasting) return Press::none;
    reported_ = true;
    return Press::lasting;
  }

 private:
  std::optional<double> since_;  // s, when the press started
  bool reported_ = false;        // the long press was returned
};

}  // namespace reorient::nao
