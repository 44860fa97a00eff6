// SPDX-License-Identifier: MIT
#include "engine/script/script_texts.h"

#include <cctype>

namespace reorient {

const ScriptText* ScriptTexts::find(const std::string& file) const {
  const auto found = files_.find(file);
  return found == files_.end() ? nullptr : &found->second;
}

void ScriptTexts::apply(const ScriptEdit& edit) {
  if (!edit.text) {
    files_.erase(edit.file);
  } else if (edit.text->text.size() > kLargestScript) {
    files_[edit.file] = {"", "script is longer than " + std::to_string(kLargestScript / 1024) + " KiB"};
  } else {
    files_[edit.file] = *edit.text;
  }
}

std::vector<std::string> ScriptTexts::files() const {
  std::vector<std::string> all;
  for (const auto& [file, text] : files_) all.push_back(file);
  return all;
}

std::vector<std::string> ScriptTexts::in_folder(std::string_view folder) const {
  const std::string prefix = std::string(folder) + "/";
  const std::string_view ending = folder == "tests" ? "_test.lua" : ".lua";
  std::vector<std::string> files;
  for (auto file = files_.lower_bound(prefix); file != files_.end() && file->first.starts_with(prefix); ++file) {
    if (file->first.ends_with(ending)) files.push_back(file->first);
  }
  return files;
}

std::uint64_t content_hash(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325ull;
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 0x100000001B3ull;
  }
  return hash;
}

std::uint64_t content_hash(const ScriptTexts& texts) {
  std::string all;
  for (const std::string& file : texts.files())
    all.append(file).append(1, '\0').append(texts.find(file)->text).append(1, '\0');
  return content_hash(all);
}

std::optional<std::string> module_file(std::string_view module) {
  constexpr std::size_t kLongest = 100;
  if (module.empty() || module.size() > kLongest) return std::nullopt;
  std::string file;
  char before = '.';
  for (const char letter : module) {
    const bool in_name = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
    if (!in_name && (letter != '.' || before == '.')) return std::nullopt;
    file += letter == '.' ? '/' : letter;
    before = letter;
  }
  if (before == '.') return std::nullopt;
  return file + ".lua";
}

std::string script_file(std::string_view folder, std::string_view name) {
  if (name.ends_with(".lua")) return std::string(name);
  return std::string(folder) + "/" + std::string(name) + ".lua";
}

}  // namespace reorient
