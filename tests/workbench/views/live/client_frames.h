// SPDX-License-Identifier: MIT
// WebSocket frames as a client sends them: masked.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace reorient::live {

inline constexpr int kContinuation = 0, kTextFrame = 1, kBinaryFrame = 2, kCloseFrame = 8, kPingFrame = 9,
                     kPongFrame = 10;

inline std::string client_frame(int opcode, std::string_view data, bool is_last = true) {
  constexpr std::string_view kMask("\x01\x80\xFF\x2A", 4);
  std::string frame(1, static_cast<char>((is_last ? 0x80 : 0) | opcode));
  const std::size_t size = data.size();
  if (size <= 125) {
    frame += static_cast<char>(0x80 | size);
  } else {
    const int bytes = size <= 0xFFFF ? 2 : 8;
    frame += static_cast<char>(bytes == 2 ? 0xFE : 0xFF);
    for (int i = bytes - 1; i >= 0; --i) frame += static_cast<char>(size >> (8 * i) & 0xFF);
  }
  frame += kMask;
  for (std::size_t i = 0; i < size; ++i) frame += static_cast<char>(data[i] ^ kMask[i % kMask.size()]);
  return frame;
}

}  // namespace reorient::live
