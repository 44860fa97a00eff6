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

/// The same the other way round, for whoever stands in for a robot: keys that the packet does not hold leave `command`
/// as it is. False: it is no map, or something in it is not as it should be.
bool read_command_packet(std::span<const std::byte> packet, Command& command);

}  // namespace reorient::nao
