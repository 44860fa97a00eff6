// SPDX-License-Identifier: MIT
// The button on the chest: a short press says one thing, a long one another.
#pragma once

#include <optional>

namespace reorient::nao {

class ChestButton {
 public:
  enum class Press { none, brief, lasting };

  /// Whether it is down at `time` (s). A long press is told while it lasts, a short one when it ends.
  Press feel(bool is_down, double time) {
    constexpr double kLasting = 3.0, kBounce = 0.03;  // s
    if (!is_down) {
      const bool counts = since_ && !told_ && time - *since_ > kBounce;
      since_.reset();
      told_ = false;
      return counts ? Press::brief : Press::none;
    }
    if (!since_) since_ = time;
    if (told_ || time - *since_ < kLasting) return Press::none;
    told_ = true;
    return Press::lasting;
  }

 private:
  std::optional<double> since_;  // s, down
  bool told_ = false;
};

}  // namespace reorient::nao
