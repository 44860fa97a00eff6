// SPDX-License-Identifier: MIT
#include "program/shell/catalog.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "engine/parameters/utf8.h"
#include "program/robots.h"
#include "program/run/venue.h"
#include "workbench/files/home.h"
#include "workbench/files/input_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

constexpr std::array<std::string_view, 1> kToml{".toml"};

std::vector<CatalogEntry> scripts_in(const std::filesystem::path& scripts, const char* folder) {
  std::vector<CatalogEntry> entries;
  const ScriptTexts texts = read_scripts(scripts);
  for (const std::string& file : texts.in_folder(folder)) {
    entries.push_back({std::filesystem::path(file).lexically_relative(folder).replace_extension().generic_string(),
                       first_sentence(texts.find(file)->text)});
  }
  return entries;
}

/// Empty for a file that cannot be read: the command that uses it reports it.
std::string sentence_of(const std::filesystem::path& file) try {
  return first_sentence(read_input(file, "a text"));
} catch (const std::runtime_error&) {
  return {};
}

std::vector<CatalogEntry> assets_in(const char* folder, std::span<const std::string_view> extensions) {
  std::vector<CatalogEntry> entries;
  for (const std::string& name : asset_names(folder, extensions))
    entries.push_back({name, sentence_of(asset_file(folder, name, extensions))});
  return entries;
}

/// The built-in hall, and the panoramas in assets/rooms by their paths, since rooms have no short names.
std::vector<CatalogEntry> rooms(const std::filesystem::path& /*scripts*/) {
  std::vector<CatalogEntry> entries{{std::string(kHall), "The built-in hall."}};
  const std::filesystem::path folder = find_home() / "assets" / "rooms";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string extension = entry.path().extension().string();
    if (std::find(kPanoramaExtensions.begin(), kPanoramaExtensions.end(), extension) != kPanoramaExtensions.end())
      entries.push_back({entry.path().string(), "A panorama."});
  }
  std::sort(entries.begin() + 1, entries.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return entries;
}

constexpr std::array<CatalogKind, 9> kKinds{{
    {"scenarios", "reorient run NAME", [](const auto& scripts) { return scripts_in(scripts, "scenarios"); }},
    {"behaviors", "reorient run --with NAME", [](const auto& scripts) { return scripts_in(scripts, "behaviors"); }},
    {"robots", "reorient run --robot NAME",
     [](const auto&) {
       std::vector<CatalogEntry> entries;
       for (const std::string& name : robot_names()) entries.push_back({name, robot_description(name)});
       return entries;
     }},
    {"bodies", "reorient run --body NAME", [](const auto&) { return assets_in("robots", kToml); }},
    {"fields", "reorient run --field NAME", [](const auto&) { return assets_in("fields", kToml); }},
    {"parameters", "reorient run --params NAME", [](const auto&) { return assets_in("parameters", kToml); }},
    {"rooms", "reorient experiment EXPERIMENT --rooms NAME", rooms},
    {"experiments", "reorient experiment NAME", [](const auto&) { return assets_in("experiments", kToml); }},
    {"conditions", "reorient experiment EXPERIMENT --mode NAME",
     [](const auto&) { return assets_in("conditions", kToml); }},
}};

/// A line of a comment in Lua or TOML, without its marks; nothing: another line.
std::optional<std::string> comment_of(const std::string& line) {
  for (const std::string_view mark : {"---", "--", "#"}) {
    if (!line.starts_with(mark)) continue;
    const std::size_t begin = line.find_first_not_of(' ', mark.size());
    return begin == std::string::npos ? std::string() : line.substr(begin);
  }
  return std::nullopt;
}

}  // namespace

std::span<const CatalogKind> catalog() { return kKinds; }

const CatalogKind* catalog_kind(const std::string& name) {
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const CatalogKind& kind) { return kind.name == name; });
  return found == kKinds.end() ? nullptr : &*found;
}

std::string first_sentence(const std::string& text) {
  constexpr std::string_view kTitle = "title = \"";
  std::istringstream lines{std::string(without_byte_order_mark(text))};
  std::string sentence;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with(kTitle)) return as_line(line.substr(kTitle.size(), line.rfind('"') - kTitle.size()));
    const std::optional<std::string> comment = comment_of(line);
    if (comment && comment->starts_with("SPDX")) continue;
    if (!comment || comment->empty()) break;
    sentence.append(sentence.empty() ? "" : " ").append(*comment);
    if (const std::size_t end = sentence.find(". "); end != std::string::npos)
      return as_line(sentence.substr(0, end + 1));
  }
  return as_line(sentence);
}

}  // namespace reorient
