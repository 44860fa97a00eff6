// SPDX-License-Identifier: MIT
#include "engine/parameters/parameter_registry.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

/// Throws std::runtime_error with the source of the value.
ParameterValue parse_change(const ParameterDeclaration& declaration, const ParameterChange& change) {
  try {
    return parse_parameter(declaration, change.value);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error((change.source.empty() ? "" : change.source + ": ") + error.what());
  }
}

}  // namespace

void ParameterRegistry::assign(Entry& entry, ParameterValue value, ParameterOrigin origin) {
  entry.parameter.value = std::move(value);
  entry.parameter.origin = origin;
  ++revision_;
  if (entry.apply) entry.apply(entry.parameter.value);
}

void ParameterRegistry::declare(ParameterDeclaration declaration, Apply apply) {
  const std::string name = declaration.name;
  if (entries_.contains(name))
    throw std::runtime_error("parameter " + name + " is declared twice (rename one of them)");
  ParameterValue value = declaration.default_value;
  ParameterOrigin origin = ParameterOrigin::default_value;
  if (const auto found = overrides_.find(name); found != overrides_.end()) {
    value = parse_change(declaration, found->second);
    origin = found->second.origin;
  }
  Entry& entry = entries_[name];
  static_cast<ParameterDeclaration&>(entry.parameter) = std::move(declaration);
  entry.apply = std::move(apply);
  assign(entry, std::move(value), origin);
}

void ParameterRegistry::forget(const std::string& owner, const std::vector<ParameterDeclaration>& kept) {
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    const bool stays = std::any_of(kept.begin(), kept.end(), [&](const auto& one) { return one.name == entry->first; });
    const bool removed = !stays && entry->second.owners.erase(owner) == 1 && entry->second.owners.empty();
    entry = removed ? entries_.erase(entry) : std::next(entry);
  }
}

std::vector<std::string> ParameterRegistry::declare_for(const std::string& owner,
                                                        const std::vector<ParameterDeclaration>& declarations) {
  for (const ParameterDeclaration& declaration : declarations) {
    if (belongs_to_program(declaration.name)) {
      throw std::runtime_error("parameter " + declaration.name + " of script " + owner +
                               ": name is used by the program (rename the script or the parameter)");
    }
  }
  forget(owner, declarations);
  std::vector<std::string> warnings;
  for (const ParameterDeclaration& declaration : declarations) {
    Entry& entry = entries_[declaration.name];
    entry.owners.insert(owner);
    static_cast<ParameterDeclaration&>(entry.parameter) = declaration;
    const auto found = overrides_.find(declaration.name);
    const bool overridden = found != overrides_.end();
    ParameterValue value = preview(declaration);
    if (overridden && to_text(value) != found->second.value) {
      try {
        parse_change(declaration, found->second);
      } catch (const std::runtime_error& error) {
        warnings.push_back(std::string(error.what()) + "; clamped to " + to_text(value));
        found->second.value = to_text(value);
      }
    }
    assign(entry, std::move(value), overridden ? found->second.origin : ParameterOrigin::default_value);
  }
  return warnings;
}

ParameterValue ParameterRegistry::preview(const ParameterDeclaration& declaration) const {
  const auto found = overrides_.find(declaration.name);
  return found == overrides_.end() ? declaration.default_value : clamp_parameter(declaration, found->second.value);
}

void ParameterRegistry::check_override(const ParameterDeclaration& declaration) const {
  const auto found = overrides_.find(declaration.name);
  if (found != overrides_.end()) parse_change(declaration, found->second);
}

bool ParameterRegistry::belongs_to_program(std::string_view name) const {
  const auto found = entries_.find(name);
  return found != entries_.end() && found->second.owners.empty();
}

bool ParameterRegistry::set(std::string_view name, std::string_view text, ParameterOrigin origin) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) {
    throw std::runtime_error("unknown parameter '" + as_line(name) + "'" + did_you_mean(name, names()));
  }
  Entry& entry = found->second;
  ParameterValue value = parse_parameter(entry.parameter, text);
  if (origin < entry.parameter.origin) return false;
  overrides_[entry.parameter.name] = {entry.parameter.name, std::string(text), origin, {}};
  assign(entry, std::move(value), origin);
  return true;
}

ParameterOutcome ParameterRegistry::change(const ParameterChange& change) {
  ParameterOutcome outcome{change.name, {}, {}};
  const auto found = entries_.find(change.name);
  try {
    if (change.origin == ParameterOrigin::default_value && found != entries_.end()) {
      overrides_.erase(change.name);
      assign(found->second, found->second.parameter.default_value, ParameterOrigin::default_value);
    } else if (!set(change.name, change.value, change.origin))
      outcome.refusal = "parameter " + change.name + " is unchanged: a change from '" +
                        std::string(to_string(change.origin)) + "' does not replace one from '" +
                        std::string(to_string(find(change.name)->origin)) + "'";
  } catch (const std::runtime_error& error) {
    outcome.refusal = error.what();
  }
  if (const Parameter* const parameter = find(change.name)) outcome.value = to_text(parameter->value);
  return outcome;
}

void ParameterRegistry::set_early(const ParameterChange& change) {
  if (!entries_.contains(change.name)) {
    const auto [kept, is_new] = overrides_.try_emplace(change.name, change);
    if (!is_new && change.origin >= kept->second.origin) kept->second = change;
    return;
  }
  try {
    set(change.name, change.value, change.origin);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(change.source.empty() ? error.what() : change.source + ": " + error.what());
  }
}

const Parameter* ParameterRegistry::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second.parameter;
}

const ParameterValue& ParameterRegistry::value(std::string_view name) const {
  const Parameter* parameter = find(name);
  if (parameter == nullptr) throw std::runtime_error("unknown parameter '" + as_line(name) + "'");
  return parameter->value;
}

std::vector<Parameter> ParameterRegistry::list() const {
  std::vector<Parameter> all;
  for (const auto& [name, entry] : entries_) all.push_back(entry.parameter);
  return all;
}

std::vector<ParameterChange> ParameterRegistry::overrides() const {
  std::vector<ParameterChange> all;
  for (const auto& [name, change] : overrides_) all.push_back(change);
  return all;
}

std::vector<std::string> ParameterRegistry::names() const {
  std::vector<std::string> all;
  for (const auto& [name, entry] : entries_) all.push_back(name);
  return all;
}

}  // namespace reorient
