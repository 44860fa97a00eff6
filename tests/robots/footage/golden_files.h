// SPDX-License-Identifier: MIT
// The messages in tests/robots/footage/golden.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>

#include "robots/footage/messages/messages.h"
#include "tests/paths.h"

namespace reorient {

inline messages::Bytes golden_message(const std::string& name) {
  std::ifstream file(std::filesystem::path(kSourceFolder) / "tests/robots/footage/golden" / name, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read the golden message " + name);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

}  // namespace reorient
