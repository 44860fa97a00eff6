// SPDX-License-Identifier: MIT
// Limits of a TOML text for the parser. The parser follows any depth and any length of the text, so excessive texts
// must be refused before.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace reorient {

/// At most a little more than what may be parsed. Nothing: the file cannot be read.
std::optional<std::string> read_toml_text(const std::filesystem::path& file);

struct TomlExcess {
  int line = 1;
  std::string why;
};
/// What keeps the text from being parsed; nothing: it may be.
std::optional<TomlExcess> excess_in_toml(std::string_view text);

/// Of a text without such. Throws toml::parse_error.
toml::table parse_toml(std::string_view text);

}  // namespace reorient
