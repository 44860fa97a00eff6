// SPDX-License-Identifier: MIT
#include "program/run/venue.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "engine/parameters/nearest_name.h"
#include "workbench/files/home.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

constexpr std::string_view kTomlFiles[] = {".toml"};

/// The candidate files of a folder.
std::vector<std::string> candidates(const std::filesystem::path& folder, std::span<const std::string_view> extensions) {
  constexpr std::size_t kMost = 10'000;
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string extension = entry.path().extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
      names.push_back(entry.path().filename().string());
    if (names.size() >= kMost) break;
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Throws if the file is missing, with a suggestion.
std::filesystem::path existing_file(std::string_view what, std::string_view assets, const std::filesystem::path& named,
                                    std::span<const std::string_view> extensions) {
  std::error_code error;
  std::filesystem::path file = asset_file(assets, named, extensions);
  if (std::filesystem::is_directory(file, error)) {
    const std::vector<std::string> files = candidates(file, extensions);
    throw std::runtime_error(std::string(what) + " '" + named.string() + "': expected a file, found a folder" +
                             (files.empty() ? "" : "; name a file in it, as in " + (file / files.front()).string()));
  }
  if (std::filesystem::exists(file, error)) return file;
  std::vector<std::string> known = candidates(file.has_parent_path() ? file.parent_path() : ".", extensions);
  const std::vector<std::string> shipped = asset_names(assets, extensions);
  known.insert(known.end(), shipped.begin(), shipped.end());
  std::string meant = did_you_mean(file.filename().string(), known);
  if (meant.empty() && !shipped.empty()) meant = " (expected a file, or one of " + list_of(shipped) + ")";
  throw std::runtime_error("unknown " + std::string(what) + " '" + named.string() + "'" + meant);
}

std::string named_by_script(std::string_view what, std::string_view folder, const std::filesystem::path& scripts,
                            const std::string& named, std::span<const std::string_view> extensions) {
  if (named.empty()) return named;
  const std::filesystem::path assets = find_home() / "assets";
  if (is_asset_name(named)) {
    for (const std::string_view extension : extensions) {
      std::filesystem::path shipped = assets / folder / named;
      shipped += extension;
      std::error_code error;
      if (is_below(assets, shipped) && std::filesystem::is_regular_file(shipped, error)) return shipped.string();
    }
  }
  const std::filesystem::path file = (scripts / named).lexically_normal();
  if (is_below(scripts, file) || is_below(assets, file)) return file.string();
  throw std::runtime_error(std::string(what) + " of a script: expected a file below the root of the scripts, or the " +
                           "name of a shipped one, found '" + named + "'; copy the file there");
}

}  // namespace

std::string Venue::name() const { return room.empty() ? "procedural hall " + std::to_string(hall_seed) : room; }

std::string room_named_by_script(const std::filesystem::path& scripts, const std::string& named) {
  return named_by_script("room", "rooms", scripts, named, kPanoramaExtensions);
}

std::string field_named_by_script(const std::filesystem::path& scripts, const std::string& named) {
  return named_by_script("field", "fields", scripts, named, kTomlFiles);
}

std::string interface_named_by_script(const std::filesystem::path& scripts, const std::string& named) {
  return named_by_script("interface", "interfaces", scripts, named, kTomlFiles);
}

ApplicationInterface interface_named(const std::filesystem::path& named) {
  if (named.empty()) return {};
  return load_interface(existing_file("interface", "interfaces", named, kTomlFiles));
}

std::string room_file(const std::string& named) {
  return existing_file("room", "rooms", named, kPanoramaExtensions).string();
}

std::filesystem::path body_file(const std::filesystem::path& named) {
  return existing_file("body", "robots", named.empty() ? "nao-v6" : named, kTomlFiles);
}

std::filesystem::path field_file(const std::filesystem::path& named) {
  return existing_file("field", "fields", named, kTomlFiles);
}

std::filesystem::path field_file(const std::filesystem::path& named, const RobotBody& body) {
  return field_file(named.empty() ? std::filesystem::path(body.field) : named);
}

std::string known_bodies() try {
  return list_of(asset_names("robots", kTomlFiles));
} catch (const std::runtime_error&) {  // a help page does not report a missing home folder
  return "none found";
}

Venue venue_of(const SimulationOptions& options, const ScenarioSetting& setting, const RobotBody& body) {
  Venue venue;
  const bool room_is_told = !options.room.empty() || options.hall_seed;
  const std::string room = room_is_told ? options.room : room_named_by_script(options.scripts, setting.room);
  if (!room.empty()) venue.room = room_file(room);
  venue.hall_seed = (room_is_told ? options.hall_seed : setting.hall_seed).value_or(1);
  const std::string field =
      options.field.empty() ? field_named_by_script(options.scripts, setting.field) : options.field.string();
  venue.field = field_file(field, body);
  return venue;
}

}  // namespace reorient
