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

/// Throws as read_input().
std::string read_toml_text(const std::filesystem::path& file, const std::string& what);

struct TomlExcess {
  int line = 1;
  std::string why;
};
/// The limit that the text exceeds; nothing: it may be parsed.
std::optional<TomlExcess> excess_in_toml(std::string_view text);

/// Parses a text within the limits. Throws toml::parse_error.
toml::table parse_toml(std::string_view text);

}  // namespace reorient
