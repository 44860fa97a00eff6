// SPDX-License-Identifier: MIT
#include "workbench/files/home.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace reorient {
namespace {

bool is_home(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_directory(folder / "scripts" / "behaviors", error) &&
         std::filesystem::is_directory(folder / "assets", error);
}

}  // namespace

std::filesystem::path find_home() {
  if (const char* named = std::getenv("REORIENT_HOME")) {
    if (is_home(named)) return named;
    throw std::runtime_error(
        "REORIENT_HOME: expected the project's folder, with scripts/behaviors and assets/, found '" +
        std::string(named) + "'");
  }
  std::error_code no_link;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", no_link).parent_path();
  while (true) {
    for (const std::filesystem::path& home : {folder, folder / "share" / "reorient"}) {
      if (is_home(home)) return home;
    }
    if (folder == folder.parent_path()) {
      throw std::runtime_error(
          "expected scripts/behaviors and assets/ in a folder above this program, found neither; name the folder with "
          "REORIENT_HOME=FOLDER");
    }
    folder = folder.parent_path();
  }
}

std::filesystem::path other_home_around(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path home = find_home();
  for (std::filesystem::path around = folder; !around.empty(); around = around.parent_path()) {
    if (is_home(around)) return std::filesystem::equivalent(around, home, error) ? std::filesystem::path() : around;
    if (around == around.parent_path()) break;
  }
  return {};
}

bool is_asset_name(const std::filesystem::path& named) {
  if (named.empty() || named.is_absolute() || named.has_extension()) return false;
  return named.begin()->native().front() != '.';
}

std::filesystem::path asset_file(std::string_view folder, const std::filesystem::path& named,
                                 std::span<const std::string_view> extensions) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(named, error);
  const bool is_file = std::filesystem::exists(status) && !std::filesystem::is_directory(status);
  if (!is_asset_name(named) || is_file) return named;
  for (const std::string_view extension : extensions) {
    std::filesystem::path asset = find_home() / "assets" / folder / named;
    asset += extension;
    if (std::filesystem::is_regular_file(asset, error)) return asset;
  }
  return named;
}

std::vector<std::string> asset_names(std::string_view folder, std::span<const std::string_view> extensions) {
  std::vector<std::string> names;
  std::error_code error;
  const std::filesystem::path root = find_home() / "assets" / folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root, error)) {
    const std::string extension = entry.path().extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
      names.push_back(entry.path().lexically_relative(root).replace_extension().generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace reorient
