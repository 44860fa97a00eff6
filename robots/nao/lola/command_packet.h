// SPDX-License-Identifier: MIT
// A command as LoLA's packet of eleven keys.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "robots/nao/lola/command.h"

namespace reorient::nao {

inline constexpr std::size_t kCommandBytes = 786;

std::array<std::byte, kCommandBytes> command_packet(const Command& command);

/// The inverse, for a simulated robot: keys that the packet does not contain leave `command` unchanged. Returns false
/// if the packet is not a map or a value is invalid.
bool read_command_packet(std::span<const std::byte> packet, Command& command);

}  // namespace reorient::nao
