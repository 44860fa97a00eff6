#include "workbench/files/parameter_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <toml++/toml.h>

#include "engine/parameters/utf8.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

std::string place(const std::filesystem::path& file, const toml::source_region& where) {
  return file.string() + ":" + std::to_string(where.begin.line);
}

std::optional<std::string> text_of(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* real = node.as_floating_point()) return to_text(real->get());
  if (const auto* yes = node.as_boolean()) return yes->get() ? "true" : "false";
  if (const auto* string = node.as_string()) return string->get();
  return std::nullopt;
}

void read_table(const std::filesystem::path& file, const toml::table& table, const std::string& prefix,
                std::vector<ParameterChange>& changes) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    const std::string source = place(file, node.source());
    if (const toml::table* inner = node.as_table()) {
      read_table(file, *inner, name + ".", changes);
      continue;
    }
    const std::optional<std::string> text = text_of(node);
    if (!text) throw std::runtime_error(source + ": a parameter is a number, true, false or a name in quotes");
    changes.push_back({name, *text, ParameterOrigin::file, source});
  }
}

bool is_bare(std::string_view key) {
  constexpr std::string_view kBare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !key.empty() && key.find_first_not_of(kBare) == std::string_view::npos;
}

/// A TOML string: what is no printable letter as its code.
std::string as_string(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      out.append(1, '\\').append(1, letter);
    } else if (code < ' ' || code == 0x7F) {
      out += "\\u00" + written_out({&letter, 1}).substr(2);
    } else {
      out += letter;
    }
  }
  return out + '"';
}

/// A value of which only the text is known, so that it is read as this text again.
std::string as_value(const std::string& text) {
  if (text == "true" || text == "false") return text;
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  return is_number && to_text(number) == text ? text : as_string(text);
}

/// A comment ends with its line, and holds no other control characters either.
std::string as_comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char code) { return code < ' ' || code == 0x7F; }, ' ');
  return as_utf8(text);
}

/// A dotted name as a TOML key.
std::string as_key(std::string_view name) {
  std::string key;
  while (true) {
    const std::size_t dot = name.find('.');
    const std::string_view part = name.substr(0, dot);
    key += is_bare(part) ? std::string(part) : as_string(part);
    if (dot == std::string_view::npos) return key;
    key += '.';
    name.remove_prefix(dot + 1);
  }
}

}  // namespace

std::vector<ParameterChange> read_parameters(const std::filesystem::path& file) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(file, missing)) {
    throw std::runtime_error(file.string() + ": there is no such parameter file");
  }
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(place(file, error.source()) + ": " + std::string(error.description()));
  }
  std::vector<ParameterChange> changes;
  read_table(file, table, "", changes);
  return changes;
}

void save_parameters(const std::vector<Parameter>& parameters, const std::vector<ParameterChange>& kept,
                     const std::filesystem::path& file) {
  std::string text;
  for (const Parameter& parameter : parameters) {
    if (parameter.origin == ParameterOrigin::default_value) continue;
    const std::string value = to_text(parameter.value);
    text += as_key(parameter.name) + " = " + (parameter.kind == ParameterKind::choice ? as_string(value) : value) +
            "  # " + as_comment(range_text(parameter) + ": " + parameter.description) + "\n";
  }
  for (const ParameterChange& change : kept)
    text += as_key(change.name) + " = " + as_value(change.value) + "  # not used in the run that saved this\n";
  write_whole_file(file, text);
}

}  // namespace reorient
