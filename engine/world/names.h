// SPDX-License-Identifier: MIT
// Names as small numbers, so that records contain no text of scripts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/bytes.h"

namespace reorient {

/// A name in a script: a machine, the path of a state, a reason.
using NameId = std::uint16_t;
inline constexpr NameId kNoName = 0;
inline constexpr NameId kStartName = 1;     ///< the reason of a machine's first state
inline constexpr NameId kReloadedName = 2;  ///< the reason of a state that a reload entered

/// The names of the numbers. Immutable: a script with new names creates a new table, in which the old names
/// have the same numbers.
struct NameTable {
  std::vector<std::string> names{"", "start", "the script was reloaded"};

  const std::string& operator[](NameId id) const {
    static const std::string kUnknown;
    return id < names.size() ? names[id] : kUnknown;
  }
  std::optional<NameId> find(std::string_view name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<NameId>(found - names.begin()));
  }
};
/// The number of the same name in another table; kNoName: it is not there.
inline NameId renumbered(NameId id, const NameTable& before, const NameTable& now) {
  return now.find(before[id]).value_or(kNoName);
}
template <typename Visit, ConstOr<NameTable> T>
void fields(Visit&& visit, T& table) {
  visit(table.names);
}

/// The table while it grows.
class Names {
 public:
  /// The number of a name, new or known; 0 if all numbers are in use.
  NameId intern(std::string_view name) {
    if (const std::optional<NameId> known = table_->find(name)) return *known;
    if (size() > kMost) return 0;
    auto more = std::make_shared<NameTable>(*table_);
    more->names.emplace_back(name);
    table_ = std::move(more);
    return static_cast<NameId>(table_->names.size() - 1);
  }

  const std::string& operator[](NameId id) const { return (*table_)[id]; }
  const std::shared_ptr<const NameTable>& table() const { return table_; }
  std::size_t size() const { return table_->names.size(); }

  /// For a script host that renumbers all names, because after many edits most names belong to removed states.
  void clear() { table_ = std::make_shared<NameTable>(); }
  static constexpr std::size_t kMany = 8192;  ///< number of names at which to renumber
  static constexpr std::size_t kMost = 65535;

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    NameTable table = *self.table_;
    archive(table);
    if constexpr (Archive::kReads) {
      if (table.names.size() < NameTable().names.size()) throw BadBytes("table of names: too short");
      self.table_ = std::make_shared<NameTable>(std::move(table));
    }
  }

 private:
  std::shared_ptr<const NameTable> table_ = std::make_shared<NameTable>();
};

}  // namespace reorient
