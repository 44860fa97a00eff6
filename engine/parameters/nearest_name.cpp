// SPDX-License-Identifier: MIT
#include "engine/parameters/nearest_name.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace reorient {

int edit_distance(std::string_view left, std::string_view right) {
  const std::size_t columns = right.size() + 1;
  std::vector<int> before(columns);
  std::vector<int> previous(columns);
  std::vector<int> row(columns);
  for (std::size_t j = 0; j < columns; ++j) previous[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= left.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < columns; ++j) {
      const int replaced = previous[j - 1] + (left[i - 1] == right[j - 1] ? 0 : 1);
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, previous);
    std::swap(previous, row);
  }
  return previous[columns - 1];
}

namespace {

/// The shortest known name with this prefix: "flip_pose" for "flip".
std::optional<std::string> longer_name(std::string_view text, std::span<const std::string> known) {
  constexpr std::size_t kShortest = 3;
  if (text.size() < kShortest) return std::nullopt;
  const std::string* best = nullptr;
  for (const std::string& name : known) {
    const bool is_longer = name.size() > text.size() && name.starts_with(text);
    if (is_longer && (best == nullptr || name.size() < best->size())) best = &name;
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view text, std::span<const std::string> known) {
  constexpr std::size_t kLongest = 80;  // longer texts are not typing errors
  if (text.empty() || text.size() > kLongest) return std::nullopt;
  constexpr int kFar = std::numeric_limits<int>::max();
  const int tolerated = std::max(1, static_cast<int>(text.size()) / 3);
  const std::string* best = nullptr;
  int best_distance = tolerated + 1;
  const auto length_difference = [text](const std::string& name) {
    return std::max(name.size(), text.size()) - std::min(name.size(), text.size());
  };
  for (const std::string& name : known) {
    if (name.size() > kLongest) continue;
    // A difference in length is a lower bound of the distance.
    const bool may_be_near = length_difference(name) <= static_cast<std::size_t>(tolerated);
    int distance = may_be_near ? edit_distance(text, name) : kFar;
    // Recognize a name without its prefix: "lingering" for "orientation.lingering".
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && text.find('.') == std::string_view::npos) {
      distance = std::min(distance, edit_distance(text, std::string_view(name).substr(dot + 1)));
    }
    // Of two equally near names, prefer the one of equal length.
    const bool is_better = distance < best_distance || (best != nullptr && distance == best_distance &&
                                                        length_difference(name) < length_difference(*best));
    if (is_better) {
      best_distance = distance;
      best = &name;
    }
  }
  if (best != nullptr) return *best;
  return longer_name(text, known);
}

std::string did_you_mean(std::string_view text, std::span<const std::string> known) {
  const std::optional<std::string> name = nearest_name(text, known);
  return name ? " (did you mean '" + *name + "'?)" : std::string();
}

std::string list_of(std::span<const std::string> names) {
  constexpr std::size_t kMost = 12;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i) list += (i > 0 ? ", " : "") + names[i];
  return list + (names.size() > kMost ? ", ..." : "");
}

}  // namespace reorient
