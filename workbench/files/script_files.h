// SPDX-License-Identifier: MIT
// The scripts on a disk: read as texts, and watched for edits.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/script/script_texts.h"
#include "workbench/files/file_watcher.h"

namespace reorient {

/// All files *.lua below the root, except what lies below tests/ and annotations/. Links are followed, since the
/// owner of the folder made them. A file that cannot be used is listed with the reason. Throws std::runtime_error with
/// one line if the folder does not exist, or if it contains too many files for a folder of scripts.
ScriptTexts read_scripts(const std::filesystem::path& root);

/// The text of one file below the root, or why it cannot be used; nothing: the file does not exist.
std::optional<ScriptText> read_script(const std::filesystem::path& root, const std::string& file);

/// The path from the root, with '/'; nothing if it is not below the root.
std::optional<std::string> path_below(const std::filesystem::path& root, const std::filesystem::path& path);

/// Whether the path is that of a file below the folder, also after links are followed. Does not look whether a file
/// outside of the folder exists.
bool is_below(const std::filesystem::path& folder, const std::filesystem::path& path);

/// The short name of a script: "orientation" for "behaviors/orientation.lua".
std::string short_script_name(const std::string& file);

/// Edits that load the scripts of a name again, also unchanged ones: a file, or a short name; an empty name: all.
std::vector<ScriptEdit> reloads_of(const ScriptTexts& texts, const std::string& name);

/// The engine's name of a script that the user names by "orientation", a file below the root, or a path to that file.
std::string script_named(const std::filesystem::path& root, const std::string& name);

/// The edits on the disk since the last call, below behaviors/, scenarios/ and lib/.
class ScriptFiles {
 public:
  explicit ScriptFiles(std::filesystem::path root);

  /// The scripts as last read.
  const ScriptTexts& texts() const { return texts_; }

  /// Takes as long as the disk takes, which may hang: no frame calls it. `time`: s, from any steady clock.
  std::vector<ScriptEdit> poll(double time);

 private:
  std::filesystem::path root_;
  FileWatcher watcher_;  ///< starts before the texts are read, so that no change is missed
  ScriptTexts texts_;
};

/// The edits that turn one set of texts into another.
std::vector<ScriptEdit> edits_between(const ScriptTexts& before, const ScriptTexts& after);

}  // namespace reorient
