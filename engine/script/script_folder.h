// The files under the scripts' root, and nothing else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Bytes. Lua's parser takes a quadratic time for some texts (thousands of `goto`s), and a reload happens between
/// frames.
inline constexpr std::uintmax_t kLargestScript = 64 * 1024;

class ScriptFolder {
 public:
  explicit ScriptFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  /// The text of "behaviors/orientation.lua"; nothing where there is no such file below the root, it is not a plain
  /// file, or it is larger than kLargestScript.
  std::optional<std::string> read(const std::string& relative) const;

  /// From now on this text stands in place of the file: tests edit scripts without touching the disk.
  void replace(const std::string& relative, std::string text) { replaced_[relative] = std::move(text); }

 private:
  std::filesystem::path root_;
  std::map<std::string, std::string> replaced_;
};

/// The path from the root, with '/'; nothing where it does not lie below the root.
std::optional<std::string> path_below(const std::filesystem::path& root, const std::filesystem::path& path);

/// The files *.lua below root/folder, by name, from the root; of "tests" only *_test.lua.
std::vector<std::string> scripts_in(const std::filesystem::path& root, const std::string& folder);

/// FNV-1a, 64 bits.
std::uint64_t content_hash(std::string_view text);

/// "lib.walk" as "lib/walk.lua"; nothing when it is not a name of that kind.
std::optional<std::string> module_file(std::string_view module);

}  // namespace reorient
