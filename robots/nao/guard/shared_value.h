// SPDX-License-Identifier: MIT
// A value in memory that two processes share: one writes, the other reads the newest complete value. Neither waits for
// the other, so that each continues if the other ends.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace reorient::nao {

template <typename Value>
class SharedValue {
  static_assert(std::is_trivially_copyable_v<Value>);
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// Only one process may write. If it ends during a write, the value is unreadable until the next write.
  void write(const Value& value) {
    std::array<std::uint64_t, kWords> words{};
    std::memcpy(words.data(), &value, sizeof(Value));
    const std::uint64_t odd = sequence_.load(std::memory_order_relaxed) | 1u;
    sequence_.store(odd, std::memory_order_relaxed);
    // Release order, so that a reader that sees a new word also sees the odd number.
    for (std::size_t i = 0; i < kWords; ++i) words_[i].store(words[i], std::memory_order_release);
    sequence_.store(odd + 1, std::memory_order_release);
  }

  /// Returns false and leaves `value` unchanged if no value exists yet or it is being written.
  bool read(Value& value) const {
    constexpr int kAttempts = 4;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      if (before == 0) return false;
      if ((before & 1u) != 0) continue;
      std::array<std::uint64_t, kWords> words{};
      for (std::size_t i = 0; i < kWords; ++i) words[i] = words_[i].load(std::memory_order_acquire);
      if (sequence_.load(std::memory_order_relaxed) != before) continue;
      std::memcpy(static_cast<void*>(&value), words.data(), sizeof(Value));
      return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(Value) + 7) / 8;
  std::atomic<std::uint64_t> sequence_ = 0;
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace reorient::nao
