// SPDX-License-Identifier: MIT
#include "workbench/files/folder_tree.h"

#include <algorithm>
#include <vector>

namespace reorient {

std::error_code visit_below(const std::filesystem::path& folder,
                            const std::function<void(const std::filesystem::directory_entry&)>& visit) {
  using Options = std::filesystem::directory_options;
  std::error_code error;
  std::vector<std::filesystem::path> around{std::filesystem::canonical(folder, error)};  // of the entry, from outside
  if (error) return error;
  for (std::filesystem::recursive_directory_iterator
           entry(folder, Options::skip_permission_denied | Options::follow_directory_symlink, error),
       end;
       !error && entry != end; entry.increment(error)) {
    visit(*entry);
    std::error_code gone;
    if (!entry->is_directory(gone)) continue;
    around.resize(static_cast<std::size_t>(entry.depth()) + 1);
    around.push_back(std::filesystem::canonical(entry->path(), gone));
    if (gone || std::find(around.begin(), std::prev(around.end()), around.back()) != std::prev(around.end()))
      entry.disable_recursion_pending();
  }
  return error;
}

}  // namespace reorient
