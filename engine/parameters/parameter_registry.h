// SPDX-License-Identifier: MIT
// All parameters of the program: listed, and overridden by a file, the command line or live.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/parameters/parameter.h"

namespace reorient {

class ParameterRegistry {
 public:
  using Apply = std::function<void(const ParameterValue&)>;

  /// Declares every member that `describe(parameters, visit)` visits as "prefix.name" and writes later changes to
  /// `parameters`, which must outlive the registry. Throws if a name is in use or an override is invalid.
  template <typename Parameters>
  void bind(const std::string& prefix, Parameters& parameters);

  /// Calls `apply` with the value at once and with each later one. Throws as bind() does.
  void declare(ParameterDeclaration declaration, Apply apply = {});

  /// Replaces the declarations of one script; several scripts may declare the same name (of a shared
  /// library). Clamps overrides that are out of range and returns one line about each.
  std::vector<std::string> declare_for(const std::string& owner, const std::vector<ParameterDeclaration>& declarations);

  /// Returns false if the value has an origin with precedence (ParameterOrigin) and stays. Throws std::runtime_error
  /// with one line if the name is unknown, or the text is of a wrong type or out of range.
  bool set(std::string_view name, std::string_view text, ParameterOrigin origin);

  /// As set(), but returns the result instead of throwing. The origin default_value removes what was set, whatever its
  /// origin, so that the parameter has its default again, also if that changes later.
  ParameterOutcome change(const ParameterChange& change);

  /// As set(), but stores the value of an undeclared name until it is declared. The message begins with the source.
  void set_early(const ParameterChange& change);

  const Parameter* find(std::string_view name) const;
  const ParameterValue& value(std::string_view name) const;  ///< throws on an unknown name
  std::vector<Parameter> list() const;                       ///< by name
  /// All values set so far, by name, including undeclared names: set_early() of each restores them.
  std::vector<ParameterChange> overrides() const;

  /// The value that `declaration` would get now: an override, clamped to its range, or the default.
  ParameterValue preview(const ParameterDeclaration& declaration) const;

  /// Throws with one line if an override of this name does not fit the declaration.
  void check_override(const ParameterDeclaration& declaration) const;
  /// Whether the program itself declared this name, so that a script must not declare it.
  bool belongs_to_program(std::string_view name) const;

  /// Changes with each change of a value.
  std::uint64_t revision() const { return revision_; }

 private:
  struct Entry {
    Parameter parameter;
    Apply apply;
    std::set<std::string> owners;  ///< scripts; empty: the program itself
  };
  struct Binder;

  std::vector<std::string> names() const;
  void assign(Entry& entry, ParameterValue value, ParameterOrigin origin);
  void forget(const std::string& owner, const std::vector<ParameterDeclaration>& kept);

  std::map<std::string, Entry, std::less<>> entries_;
  std::map<std::string, ParameterChange, std::less<>> overrides_;
  std::uint64_t revision_ = 1;
};

/// The visitor for describe().
struct ParameterRegistry::Binder {
  ParameterRegistry& registry;
  std::string prefix;

  void operator()(const char* name, double& value, double minimum, double maximum, const char* unit,
                  const char* description) const {
    registry.declare({prefix + name, ParameterKind::real, value, minimum, maximum, unit, description, {}},
                     [&value](const ParameterValue& set) { value = std::get<double>(set); });
  }
  void operator()(const char* name, int& value, int minimum, int maximum, const char* unit,
                  const char* description) const {
    const auto low = static_cast<double>(minimum);
    const auto high = static_cast<double>(maximum);
    registry.declare({prefix + name, ParameterKind::integer, value, low, high, unit, description, {}},
                     [&value](const ParameterValue& set) { value = std::get<int>(set); });
  }
  void operator()(const char* name, bool& value, const char* description) const {
    registry.declare({prefix + name, ParameterKind::boolean, value, 0.0, 0.0, "", description, {}},
                     [&value](const ParameterValue& set) { value = std::get<bool>(set); });
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* name, Enum& value, std::initializer_list<const char*> choices,
                  const char* description) const {
    const std::vector<std::string> list(choices.begin(), choices.end());
    registry.declare({prefix + name, ParameterKind::choice, list.at(static_cast<std::size_t>(value)), 0.0, 0.0, "",
                      description, list},
                     [&value, list](const ParameterValue& set) {
                       for (std::size_t i = 0; i < list.size(); ++i) {
                         if (list[i] == std::get<std::string>(set)) value = static_cast<Enum>(i);
                       }
                     });
  }
};

template <typename Parameters>
void ParameterRegistry::bind(const std::string& prefix, Parameters& parameters) {
  describe(parameters, Binder{*this, prefix + "."});
}

}  // namespace reorient
