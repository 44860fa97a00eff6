#include "workbench/script_tools/check/name_resolution.h"

#include <algorithm>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

std::vector<std::string> listed(const std::set<std::string>& names) { return {names.begin(), names.end()}; }

std::string_view type_of(const LuaToken& literal) {
  if (literal.kind == Kind::text) return "string";
  if (literal.kind == Kind::number) return "number";
  return literal.text == "nil" ? "nil" : "boolean";
}

bool fits(const std::string& wanted, const LuaToken& literal) {
  if (wanted.ends_with('?')) return literal.text == "nil" || fits(wanted.substr(0, wanted.size() - 1), literal);
  // Lua turns numbers into text where text is wanted.
  return type_of(literal) == wanted || (wanted == "string" && literal.kind == Kind::number);
}

std::string count_text(std::size_t count) {
  return count == 0 ? "no argument" : std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

}  // namespace

/// To look for similar names takes long, and who has many mistakes reads the first ones.
std::string NameResolution::hint(const std::string& wanted, const std::vector<std::string>& names) {
  constexpr int kMost = 20;
  return ++hints_ <= kMost ? did_you_mean(wanted, names) : std::string();
}

Meaning* NameResolution::find_local(const std::string& name) {
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    for (auto local = scope->rbegin(); local != scope->rend(); ++local) {
      if (local->first == name) return &local->second;
    }
  }
  return nullptr;
}

void NameResolution::assign(const LuaToken& name) {
  if (Meaning* local = find_local(name.text)) {
    *local = Meaning{};
  } else if (known_.globals.contains(name.text)) {
    note(name, "'" + name.text + "' is read-only");
  } else {
    note(name, "'" + name.text + "' would be a global variable, which no reload keeps: write 'local " + name.text +
                   "', or keep { } for memory");
  }
}

void NameResolution::check_compared_name(const Expression& value, const Expression& text) {
  if (value.meaning.kind != Meaning::Kind::name || text.literal == nullptr) return;
  const std::set<std::string>& names = known_.names.at(value.meaning.name);
  if (text.literal->kind == Kind::text && names.contains(text.literal->text)) return;
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  note(*text.literal, value.meaning.name + " is never " +
                          (text.literal->kind == Kind::text ? "'" + text.literal->text + "'" : text.literal->text) +
                          "; it is one of " + all);
}

void NameResolution::check_compared_state(const Expression& state, const Expression& text) {
  if (state.meaning.kind != Meaning::Kind::machine_state || text.literal == nullptr) return;
  if (text.literal->kind != Kind::text) return;
  const std::set<std::string>& states = known_.states.at(state.meaning.name);
  if (states.contains(text.literal->text)) return;
  note(*text.literal,
       state.meaning.name + " has no state '" + text.literal->text + "'" + hint(text.literal->text, listed(states)));
}

void NameResolution::compare(const Expression& left, const Expression& right) {
  check_compared_state(left, right);
  check_compared_state(right, left);
  check_compared_name(left, right);
  check_compared_name(right, left);
}

Meaning NameResolution::call(const Meaning& function, const LuaToken& place, std::vector<Expression> arguments,
                             bool in_condition) {
  if (function.kind != Meaning::Kind::function) return {};
  if (function.function != nullptr) check_call(function, place, arguments, in_condition);
  if (function.name == "param" && arguments.size() == 1) {
    return {Meaning::Kind::params, "param", nullptr, nullptr, std::move(arguments.front().keys)};
  }
  if (function.name == "require" && arguments.size() == 1 && arguments.front().literal != nullptr) {
    const std::string& module = arguments.front().literal->text;
    const auto found = known_.modules.find(module);
    if (found != known_.modules.end()) return {Meaning::Kind::table, module, &found->second, nullptr, {}};
  }
  return {};
}

void NameResolution::check_call(const Meaning& called, const LuaToken& place, const std::vector<Expression>& arguments,
                                bool in_condition) {
  const FunctionSymbol& function = *called.function;
  if (function.acts && in_condition)
    note(place, called.name + " acts, and a condition only looks: call it in enter, update or exit");
  const std::vector<std::string>& types = function.argument_types;
  if (arguments.size() > types.size()) {
    note(place, called.name + " takes " + count_text(types.size()) + ", not " + std::to_string(arguments.size()));
    return;
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const LuaToken* literal = arguments[i].literal;
    if (literal != nullptr && !fits(types[i], *literal)) {
      note(*literal, "argument " + std::to_string(i + 1) + " of " + called.name + " is a " + types[i] + ", not a " +
                         std::string(type_of(*literal)));
    }
  }
  if (!arguments.empty() && arguments.back().is_open_ended) return;
  const auto needed = static_cast<std::size_t>(
      std::count_if(types.begin(), types.end(), [](const std::string& type) { return !type.ends_with('?'); }));
  if (arguments.size() < needed)
    note(place, called.name + " needs " + count_text(needed) + ", not " + std::to_string(arguments.size()));
}

Meaning NameResolution::of(const LuaToken& name) {
  if (const Meaning* local = find_local(name.text)) return *local;
  if (!known_.globals.contains(name.text)) {
    std::vector<std::string> candidates = listed(known_.globals);
    for (const Scope& scope : scopes_) {
      for (const auto& local : scope) candidates.push_back(local.first);
    }
    note(name, "there is no '" + name.text + "'" + hint(name.text, candidates));
    return {};
  }
  if (name.text == "published") return {Meaning::Kind::published, name.text, nullptr, nullptr, {}};
  if (name.text == "behaviors") return {Meaning::Kind::machines, name.text, nullptr, nullptr, {}};
  if (const auto table = known_.tables.find(name.text); table != known_.tables.end())
    return {Meaning::Kind::table, name.text, &table->second, nullptr, {}};
  const auto function = known_.functions.find(name.text);
  const FunctionSymbol* signature = function == known_.functions.end() ? nullptr : &function->second;
  return {Meaning::Kind::function, name.text, nullptr, signature, {}};
}

Meaning NameResolution::of_field(const Meaning& owner, const LuaToken& field) {
  const std::string full_name = owner.name + "." + field.text;
  switch (owner.kind) {
    case Meaning::Kind::table: {
      if (!owner.table->fields.contains(field.text)) {
        note(field, "there is no " + full_name + hint(field.text, listed(owner.table->fields)));
        return {};
      }
      const auto function = owner.table->functions.find(field.text);
      if (function == owner.table->functions.end()) {
        if (known_.names.contains(full_name)) return {Meaning::Kind::name, full_name, nullptr, nullptr, {}};
        return {};
      }
      return {Meaning::Kind::function, full_name, nullptr, &function->second, {}};
    }
    case Meaning::Kind::params:
      if (!owner.keys.contains(field.text))
        note(field, "there is no param '" + field.text + "'" + hint(field.text, listed(owner.keys)));
      return {};
    case Meaning::Kind::machines: {
      if (known_.states.empty()) return {};  // nobody told which machines there are
      if (known_.states.contains(field.text)) return {Meaning::Kind::machine, field.text, nullptr, nullptr, {}};
      std::vector<std::string> names;
      for (const auto& machine : known_.states) names.push_back(machine.first);
      note(field, "there is no behavior '" + field.text + "'" + hint(field.text, names));
      return {};
    }
    case Meaning::Kind::published:
      if (known_.published && !known_.published->contains(field.text))
        note(field, "no state publishes '" + field.text + "'" + hint(field.text, listed(*known_.published)));
      return {};
    case Meaning::Kind::machine:
      if (field.text == "state") return {Meaning::Kind::machine_state, owner.name, nullptr, nullptr, {}};
      if (field.text != "time_in_state") {
        const std::vector<std::string> fields{"state", "time_in_state"};
        note(field, "there is no behaviors." + full_name + hint(field.text, fields));
      }
      return {};
    default:
      return {};
  }
}

void NameResolution::assign_field(const Meaning& owner, const LuaToken& field) {
  const bool is_read_only = (owner.kind == Meaning::Kind::table && owner.table->is_read_only) ||
                            owner.kind == Meaning::Kind::params || owner.kind == Meaning::Kind::machines ||
                            owner.kind == Meaning::Kind::published || owner.kind == Meaning::Kind::machine;
  if (is_read_only) note(field, owner.name + "." + field.text + " is read-only");
}

std::vector<DeclarationError> NameResolution::take_errors() {
  std::stable_sort(errors_.begin(), errors_.end(),
                   [](const auto& left, const auto& right) { return is_before(left.position, right.position); });
  return std::move(errors_);
}

}  // namespace reorient
