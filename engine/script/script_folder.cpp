#include "engine/script/script_folder.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace reorient {
namespace {

bool is_below(const std::filesystem::path& file, const std::filesystem::path& root) {
  const auto [end, rest] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  return end == root.end() || (std::next(end) == root.end() && end->empty());
}

}  // namespace

std::optional<std::string> ScriptFolder::read(const std::string& relative) const {
  if (const auto found = replaced_.find(relative); found != replaced_.end()) return found->second;
  std::error_code error;
  const std::filesystem::path root = std::filesystem::canonical(root_, error);
  if (error) return std::nullopt;
  // Symbolic links are followed first, so that none leads out of the root.
  const std::filesystem::path file = std::filesystem::canonical(root / relative, error);
  if (error || !is_below(file, root) || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  if (std::filesystem::file_size(file, error) > kLargestScript || error) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || text.str().size() > kLargestScript) return std::nullopt;
  return std::move(text).str();
}

std::optional<std::string> path_below(const std::filesystem::path& root, const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path relative = std::filesystem::relative(path, root, error);
  if (error || relative.empty() || *relative.begin() == "..") return std::nullopt;
  return relative.generic_string();
}

std::vector<std::string> scripts_in(const std::filesystem::path& root, const std::string& folder) {
  const std::string ending = folder == "tests" ? "_test.lua" : ".lua";
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator entry(root / folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().ends_with(ending))
      files.push_back(entry->path().lexically_relative(root).generic_string());
  }
  std::sort(files.begin(), files.end());
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

}  // namespace reorient
