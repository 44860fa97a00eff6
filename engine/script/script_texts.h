// SPDX-License-Identifier: MIT
// The texts of all scripts as values: the caller of the engine reads the files and passes edits with a frame's
// inputs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/bytes.h"

namespace reorient {

/// Bytes. A limit is necessary because a reload happens within a frame, and Lua's parser takes quadratic time for some
/// texts (thousands of `goto`s).
inline constexpr std::size_t kLargestScript = 64 * 1024;

/// The content of a file, or why it cannot be used.
struct ScriptText {
  std::string text;
  std::string problem;  ///< empty: usable
  bool operator==(const ScriptText&) const = default;
};
template <typename Visit, ConstOr<ScriptText> T>
void fields(Visit&& visit, T& text) {
  visit(text.text, text.problem);
}

/// A file that was written or removed.
struct ScriptEdit {
  std::string file;                ///< "behaviors/orientation.lua"
  std::optional<ScriptText> text;  ///< nothing: the file was removed
  bool again = false;              ///< reload even if the text is unchanged
};
template <typename Visit, ConstOr<ScriptEdit> T>
void fields(Visit&& visit, T& edit) {
  visit(edit.file, edit.text, edit.again);
}

/// Files by their path below the scripts' root, with '/'.
class ScriptTexts {
 public:
  /// `root`: the name of the texts' folder in messages.
  explicit ScriptTexts(std::string root = "the scripts") : root_(std::move(root)) {}

  const std::string& root() const { return root_; }

  /// nullptr: unknown file.
  const ScriptText* find(const std::string& file) const;
  /// A text longer than kLargestScript becomes a file that cannot be used.
  void apply(const ScriptEdit& edit);

  /// All files, by name.
  std::vector<std::string> files() const;
  /// The files *.lua in this folder and below, by name; of "tests" only *_test.lua.
  std::vector<std::string> in_folder(std::string_view folder) const;

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.root_, self.files_);
    if constexpr (Archive::kReads) {
      for (const auto& [file, text] : self.files_)
        check_bytes(text.text.size() <= kLargestScript, "script: text is too long");
    }
  }

 private:
  std::string root_;
  std::map<std::string, ScriptText> files_;
};

/// FNV-1a, 64 bits.
std::uint64_t content_hash(std::string_view text);
/// The same of all scripts, with their names.
std::uint64_t content_hash(const ScriptTexts& texts);

/// "lib.walk" as "lib/walk.lua"; nothing if it is not a module name.
std::optional<std::string> module_file(std::string_view module);

/// "behaviors/orientation.lua" from "orientation"; a name that ends in .lua is returned unchanged.
std::string script_file(std::string_view folder, std::string_view name);

}  // namespace reorient
