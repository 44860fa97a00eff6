// SPDX-License-Identifier: MIT
#include "workbench/files/parameter_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <toml++/toml.h>

#include "engine/parameters/utf8.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/input_file.h"
#include "workbench/files/table_reader.h"
#include "workbench/files/toml_text.h"

namespace reorient {
namespace {

constexpr int kDeepest = 16;  // nested tables
constexpr std::size_t kMostParameters = 10'000;

[[noreturn]] void fail(const std::string& source, std::string_view why) {
  throw std::runtime_error(as_line(source + ": " + std::string(why)));
}

std::string place(const std::string& name, const toml::source_region& where) {
  return name + ":" + std::to_string(where.begin.line);
}

std::optional<std::string> text_of(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* real = node.as_floating_point()) return to_text(real->get());
  if (const auto* yes = node.as_boolean()) return yes->get() ? "true" : "false";
  if (const auto* string = node.as_string()) return string->get();
  return std::nullopt;
}

/// The contents of a file, table by table.
class Reading {
 public:
  explicit Reading(std::string name) : name_(std::move(name)) {}

  void read(const toml::table& table, const std::string& prefix = "", int depth = 0) {
    for (const auto& [key, node] : table) {
      const std::string parameter = prefix + std::string(key.str());
      const std::string source = place(name_, node.source());
      if (const toml::table* inner = node.as_table()) {
        if (depth >= kDeepest)
          fail(source, "expected names such as orientation.lingering, found tables that are nested too deeply");
        read(*inner, parameter + ".", depth + 1);
        continue;
      }
      const std::optional<std::string> text = text_of(node);
      if (!text) fail(source, "expected a number, true, false or a name in quotes" + found_text(node));
      if (changes_.size() >= kMostParameters)
        fail(source, "expected at most " + std::to_string(kMostParameters) + " parameters, found more");
      changes_.push_back({parameter, *text, ParameterOrigin::file, source});
    }
  }
  std::vector<ParameterChange> changes() && { return std::move(changes_); }

 private:
  std::string name_;
  std::vector<ParameterChange> changes_;
};

bool is_bare(std::string_view key) {
  constexpr std::string_view kBare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !key.empty() && key.find_first_not_of(kBare) == std::string_view::npos;
}

/// A TOML string: unprintable characters as their code.
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

/// A value that is stored as text; writes it so that it reads as the same text.
std::string as_value(const std::string& text) {
  if (text == "true" || text == "false") return text;
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  const bool reads_the_same = is_number && to_text(number) == text && text != "-0";  // TOML reads it as 0
  return reads_the_same ? text : as_string(text);
}

/// A comment must contain neither line breaks nor other control characters.
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
  std::string text;
  try {
    text = read_toml_text(file, "a parameter file");
  } catch (const std::runtime_error& reason) {
    fail(file.string(), reason.what());
  }
  return parse_parameters(text, file.string());
}

std::vector<ParameterChange> parse_parameters(std::string_view text, const std::string& name) {
  if (const std::optional<TomlExcess> excess = excess_in_toml(text))
    fail(name + ":" + std::to_string(excess->line), excess->why);
  Reading reading(name);
  try {
    reading.read(toml::parse(text));
  } catch (const toml::parse_error& error) {
    fail(place(name, error.source()), error.description());
  }
  return std::move(reading).changes();
}

std::string parameter_text(const std::vector<Parameter>& parameters, const std::vector<ParameterChange>& kept) {
  std::string text;
  for (const Parameter& parameter : parameters) {
    if (parameter.value == parameter.default_value) continue;
    const std::string value = to_text(parameter.value);
    text += as_key(parameter.name) + " = " + (parameter.kind == ParameterKind::choice ? as_string(value) : value) +
            "  # " + as_comment(range_text(parameter) + ": " + parameter.description) + "\n";
  }
  for (const ParameterChange& change : kept)
    text += as_key(change.name) + " = " + as_value(change.value) + "  # not used in the run that saved this\n";
  return text;
}

std::filesystem::path save_parameters(const std::vector<Parameter>& parameters,
                                      const std::vector<ParameterChange>& kept, const std::filesystem::path& file) {
  const std::string text = parameter_text(parameters, kept);
  std::filesystem::path backup;
  std::error_code failed;
  if (std::filesystem::is_regular_file(file, failed)) {
    const std::string before = read_named_input(file, "a parameter file");
    if (!before.empty() && before != text) {
      backup = file.string() + ".bak";
      write_whole_file(backup, before);
    }
  }
  write_whole_file(file, text);
  return backup;
}

}  // namespace reorient
