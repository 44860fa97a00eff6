// SPDX-License-Identifier: MIT
#include "program/run/venue.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "engine/parameters/nearest_name.h"
#include "workbench/files/home.h"

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

}  // namespace

std::string Venue::name() const { return room.empty() ? "procedural hall " + std::to_string(hall_seed) : room; }

std::string file_named_by_script(const std::filesystem::path& scripts, const std::string& named) {
  const std::filesystem::path path = named;
  const bool is_name = !path.has_parent_path() && !path.has_extension();
  return named.empty() || is_name || path.is_absolute() ? named : (scripts / path).lexically_normal().string();
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
  const std::string room = room_is_told ? options.room : file_named_by_script(options.scripts, setting.room);
  if (!room.empty()) venue.room = existing_file("room", "rooms", room, kPanoramaExtensions).string();
  venue.hall_seed = (room_is_told ? options.hall_seed : setting.hall_seed).value_or(1);
  const std::string field =
      options.field.empty() ? file_named_by_script(options.scripts, setting.field) : options.field.string();
  venue.field = field_file(field, body);
  return venue;
}

}  // namespace reorient
