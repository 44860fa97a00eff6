// SPDX-License-Identifier: MIT
#include "program/named_files.h"

#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "workbench/files/atomic_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

/// Compares the files behind links and different spellings, also of missing files. Several outputs may share a device.
bool is_same(const std::filesystem::path& one, const std::filesystem::path& other) {
  std::error_code error;
  if (std::filesystem::is_other(one, error)) return false;
  if (std::filesystem::equivalent(one, other, error)) return true;
  const std::filesystem::path plain = std::filesystem::weakly_canonical(std::filesystem::absolute(one, error), error);
  return plain == std::filesystem::weakly_canonical(std::filesystem::absolute(other, error), error);
}

}  // namespace

void NamedFiles::reads(const std::filesystem::path& file, const std::string& name) {
  std::error_code error;  // an asset's name is not a path, so no such file exists
  if (std::filesystem::exists(file, error)) named_.emplace_back(file, name);
}

void NamedFiles::reads_scripts(const std::filesystem::path& root) { roots_.push_back(root); }

void NamedFiles::writes(const std::filesystem::path& file, const std::string& option) {
  if (file.empty()) return;
  for (const auto& [other, name] : named_) {
    if (is_same(other, file))
      throw std::runtime_error(
          fmt::format("{0} and {1}: expected two files, found the same one: {2}; name another file with {1}", name,
                      option, file.string()));
  }
  for (const std::filesystem::path& root : roots_) {
    const std::optional<std::string> below = path_below(root, file);
    if (file.extension() == ".lua" && below && !below->starts_with("annotations/"))  // annotations are not scripts
      throw std::runtime_error(fmt::format(
          "{0} {1}: expected a file outside the folder of scripts, found one in it; name another file with {0}", option,
          file.string()));
  }
  named_.emplace_back(file, option);
}

void NamedFiles::require_writable(const std::filesystem::path& file, const std::string& option) {
  writes(file, option);
  if (!file.empty()) require_writable_file(file, option);
}

void require_writable_output(const std::filesystem::path& file, const std::string& option,
                             const std::filesystem::path& scripts) {
  NamedFiles files;
  files.reads_scripts(scripts);
  files.require_writable(file, option);
}

}  // namespace reorient
