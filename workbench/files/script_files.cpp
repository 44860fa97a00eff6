// SPDX-License-Identifier: MIT
#include "workbench/files/script_files.h"

#include <algorithm>
#include <stdexcept>

#include "workbench/files/folder_tree.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

constexpr std::size_t kMostEntries = 20'000;  // files and folders; a folder with more is not a folder of scripts

bool is_script(const std::string& file) {
  return file.ends_with(".lua") && !file.starts_with("tests/") && !file.starts_with("annotations/");
}

}  // namespace

std::optional<ScriptText> read_script(const std::filesystem::path& root, const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(root / file, error))) return std::nullopt;
  try {
    return ScriptText{read_input(root / file, "a script", kLargestScript), ""};
  } catch (const std::runtime_error& reason) {
    return ScriptText{"", reason.what()};
  }
}

ScriptTexts read_scripts(const std::filesystem::path& root) {
  std::error_code error;
  if (!std::filesystem::is_directory(root, error))
    throw std::runtime_error(root.string() + ": expected a folder of scripts, found none");
  ScriptTexts texts(root.string());
  std::size_t entries = 0;
  error = visit_below(root, [&](const std::filesystem::directory_entry& entry) {
    if (++entries > kMostEntries)
      throw std::runtime_error(root.string() + ": expected at most " + std::to_string(kMostEntries) +
                               " files and folders, found more; name the folder that contains only scripts");
    const std::string file = entry.path().lexically_relative(root).generic_string();
    if (!is_script(file)) return;
    if (std::optional<ScriptText> text = read_script(root, file)) texts.apply({file, std::move(text)});
  });
  if (error) throw std::runtime_error(root.string() + ": the folder cannot be read completely: " + error.message());
  return texts;
}

std::optional<std::string> path_below(const std::filesystem::path& root, const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path relative = std::filesystem::relative(path, root, error);
  if (error || relative.empty() || *relative.begin() == "..") return std::nullopt;
  return relative.generic_string();
}

bool is_below(const std::filesystem::path& folder, const std::filesystem::path& path) {
  const auto leads_out = [](const std::filesystem::path& from, const std::filesystem::path& to) {
    const std::filesystem::path relative = to.lexically_relative(from);
    return relative.empty() || *relative.begin() == "..";
  };
  std::error_code error;
  const std::filesystem::path plain = std::filesystem::absolute(folder, error).lexically_normal();
  const std::filesystem::path file = std::filesystem::absolute(path, error).lexically_normal();
  if (error || leads_out(plain, file)) return false;
  const std::filesystem::path real_folder = std::filesystem::weakly_canonical(plain, error);
  if (error) return false;
  const std::filesystem::path real_file = std::filesystem::weakly_canonical(file, error);
  return !error && !leads_out(real_folder, real_file);
}

std::string short_script_name(const std::string& file) {
  const std::size_t begin = file.find('/') + 1;  // of npos: 0
  return file.substr(begin, file.rfind(".lua") - begin);
}

std::vector<ScriptEdit> reloads_of(const ScriptTexts& texts, const std::string& name) {
  std::vector<ScriptEdit> edits;
  for (const std::string& file : texts.files()) {
    if (name.empty() || file == name || short_script_name(file) == name)
      edits.push_back({file, *texts.find(file), true});
  }
  return edits;
}

std::string script_named(const std::filesystem::path& root, const std::string& name) {
  std::error_code error;
  const std::filesystem::path path = name;
  if (path.extension() != ".lua" || !std::filesystem::exists(path, error)) return name;
  return path_below(root, path).value_or(path.generic_string());
}

std::vector<ScriptEdit> edits_between(const ScriptTexts& before, const ScriptTexts& after) {
  std::vector<ScriptEdit> edits;
  for (const std::string& file : after.files()) {
    const ScriptText* const old = before.find(file);
    const ScriptText* const text = after.find(file);
    if (old == nullptr || *old != *text) edits.push_back({file, *text});
  }
  for (const std::string& file : before.files()) {
    if (after.find(file) == nullptr) edits.push_back({file, std::nullopt});
  }
  return edits;
}

ScriptFiles::ScriptFiles(std::filesystem::path root)
    : root_(std::move(root)),
      watcher_(root_, FileWatcher::Means::automatic, {"behaviors", "scenarios", "lib"}),
      texts_(read_scripts(root_)) {}

std::vector<ScriptEdit> ScriptFiles::poll(double time) {
  if (!watcher_.poll(time)) return {};
  ScriptTexts now(root_.string());
  try {
    now = read_scripts(root_);
  } catch (const std::runtime_error&) {
    return {};  // editors and version control may remove the folder for a moment: keep the scripts
  }
  std::vector<ScriptEdit> edits = edits_between(texts_, now);
  texts_ = std::move(now);
  return edits;
}

}  // namespace reorient
