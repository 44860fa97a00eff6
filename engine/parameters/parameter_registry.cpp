#include "engine/parameters/parameter_registry.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"

namespace reorient {

void ParameterRegistry::assign(Entry& entry, ParameterValue value, ParameterOrigin origin) {
  entry.parameter.value = std::move(value);
  entry.parameter.origin = origin;
  ++revision_;
  if (entry.apply) entry.apply(entry.parameter.value);
}

void ParameterRegistry::declare(ParameterDeclaration declaration, Apply apply) {
  const std::string name = declaration.name;
  if (entries_.contains(name)) throw std::runtime_error("parameter " + name + " is declared twice; rename one of them");
  ParameterValue value = declaration.default_value;
  ParameterOrigin origin = ParameterOrigin::default_value;
  if (const auto found = overrides_.find(name); found != overrides_.end()) {
    value = parse_parameter(declaration, found->second.text);
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
                               " already belongs to the program; rename the script or the parameter");
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
    if (overridden && to_text(value) != found->second.text) {
      try {
        parse_parameter(declaration, found->second.text);
      } catch (const std::runtime_error& error) {
        warnings.push_back(std::string(error.what()) + "; it is now " + to_text(value));
        found->second.text = to_text(value);
      }
    }
    assign(entry, std::move(value), overridden ? found->second.origin : ParameterOrigin::default_value);
  }
  return warnings;
}

ParameterValue ParameterRegistry::preview(const ParameterDeclaration& declaration) const {
  const auto found = overrides_.find(declaration.name);
  return found == overrides_.end() ? declaration.default_value : clamp_parameter(declaration, found->second.text);
}

void ParameterRegistry::check_override(const ParameterDeclaration& declaration) const {
  const auto found = overrides_.find(declaration.name);
  if (found != overrides_.end()) parse_parameter(declaration, found->second.text);
}

bool ParameterRegistry::belongs_to_program(std::string_view name) const {
  const auto found = entries_.find(name);
  return found != entries_.end() && found->second.owners.empty();
}

void ParameterRegistry::set(std::string_view name, std::string_view text, ParameterOrigin origin) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) {
    throw std::runtime_error("there is no parameter '" + std::string(name) + "'" + did_you_mean(name, names()));
  }
  Entry& entry = found->second;
  ParameterValue value = parse_parameter(entry.parameter, text);
  if (origin < entry.parameter.origin) return;
  overrides_[entry.parameter.name] = {std::string(text), origin};
  assign(entry, std::move(value), origin);
}

void ParameterRegistry::set_early(const std::string& name, std::string_view text, ParameterOrigin origin) {
  if (entries_.contains(name)) return set(name, text, origin);
  Override& kept = overrides_[name];
  if (origin >= kept.origin) kept = {std::string(text), origin};
}

const Parameter* ParameterRegistry::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second.parameter;
}

const ParameterValue& ParameterRegistry::value(std::string_view name) const {
  const Parameter* parameter = find(name);
  if (parameter == nullptr) throw std::runtime_error("there is no parameter '" + std::string(name) + "'");
  return parameter->value;
}

std::vector<Parameter> ParameterRegistry::list() const {
  std::vector<Parameter> all;
  for (const auto& [name, entry] : entries_) all.push_back(entry.parameter);
  return all;
}

std::vector<std::string> ParameterRegistry::unclaimed() const {
  std::vector<std::string> lines;
  for (const auto& [name, kept] : overrides_) {
    if (entries_.contains(name)) continue;
    lines.push_back("there is no parameter '" + name + "' (set by the " + std::string(to_string(kept.origin)) + ")" +
                    did_you_mean(name, names()));
  }
  return lines;
}

std::vector<std::string> ParameterRegistry::names() const {
  std::vector<std::string> all;
  for (const auto& [name, entry] : entries_) all.push_back(name);
  return all;
}

}  // namespace reorient
