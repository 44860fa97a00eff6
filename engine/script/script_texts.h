// SPDX-License-Identifier: MIT
// The texts of all scripts, as values: whoever runs the engine reads the files, and hands edits in with a frame's
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

/// Bytes. Lua's parser takes a quadratic time for some texts (thousands of `goto`s), and a reload happens within a
/// frame.
inline constexpr std::size_t kLargestScript = 64 * 1024;

/// What a file holds, or why it cannot be used.
struct ScriptText {
  std::string text;
  std::string problem;  ///< empty: none; "this is not a plain file ..."
  bool operator==(const ScriptText&) const = default;
};
template <typename Visit, ConstOr<ScriptText> T>
void fields(Visit&& visit, T& text) {
  visit(text.text, text.problem);
}

/// A file that was written, or removed.
struct ScriptEdit {
  std::string file;                ///< "behaviors/orientation.lua"
  std::optional<ScriptText> text;  ///< nothing: the file is gone
  bool again = false;              ///< to be read again even where this is the text that it had
};
template <typename Visit, ConstOr<ScriptEdit> T>
void fields(Visit&& visit, T& edit) {
  visit(edit.file, edit.text, edit.again);
}

/// Files by their path below the scripts' root, with '/'.
class ScriptTexts {
 public:
  /// `root`: how messages call the folder that the texts come from.
  explicit ScriptTexts(std::string root = "the scripts") : root_(std::move(root)) {}

  const std::string& root() const { return root_; }

  /// nullptr: there is no such file.
  const ScriptText* find(const std::string& file) const;
  /// A text that is longer than kLargestScript is kept as a file that cannot be used.
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
        check_bytes(text.text.size() <= kLargestScript, "a script is too long");
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

/// "lib.walk" as "lib/walk.lua"; nothing when it is not a name of that kind.
std::optional<std::string> module_file(std::string_view module);

/// "behaviors/orientation.lua" from "orientation"; a name that ends in .lua stays as it is.
std::string script_file(std::string_view folder, std::string_view name);

}  // namespace reorient
