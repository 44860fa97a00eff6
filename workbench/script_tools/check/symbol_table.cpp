// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/symbol_table.h"

#include <utility>

#include "engine/script/language/behavior_language.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/check/type_symbols.h"
#include "workbench/script_tools/reference/vocabulary.h"

namespace reorient {
namespace {

std::shared_ptr<const std::set<std::string>> shared(std::set<std::string> names) {
  return std::make_shared<const std::set<std::string>>(std::move(names));
}

std::shared_ptr<TableSymbol> new_table(const std::string& name) {
  return std::make_shared<TableSymbol>(TableSymbol{name, name + " has no field '", {}, true});
}

/// A text that must be one of `names`.
Symbol one_of(std::set<std::string> names) { return {kString, nullptr, nullptr, shared(std::move(names))}; }

Symbol field_symbol(const WorldField& field) {
  if (field.type == WorldField::Type::name) return one_of({field.names.begin(), field.names.end()});
  Symbol symbol{field.type == WorldField::Type::boolean ? kBoolean : kNumber};
  symbol.replacement = field.replacement;
  return symbol;
}

/// Collects the tables, then moves them into the globals.
class Vocabulary {
 public:
  explicit Vocabulary(const DeclaredNames& declared) : declared_(declared) {
    for (const NameType& type : name_types())
      named_[std::string(type.type)] =
          type.names.empty() ? Symbol{kString} : one_of({type.names.begin(), type.names.end()});
    named_[std::string(kWorldType)] = world_changes();
    for (const auto* machines : {&declared.behaviors, &declared.scenarios})
      states_.insert(machines->begin(), machines->end());
    std::set<std::string> machines;
    for (const auto& machine : states_) machines.insert(machine.first);
    named_["reorient.MachineName"] = one_of(std::move(machines));
    named_["reorient.BehaviorScript"] = one_of(declared.behavior_scripts);
    named_["reorient.ScenarioScript"] = one_of(declared.scenario_scripts);
    named_["reorient.ParameterName"] = one_of(declared.parameters);
    named_["reorient.InputValues"] = {kTable, values_table(nullptr)};
    std::set<std::string> actions;
    for (const ApplicationInterface& interface : declared.interfaces) {
      for (const DeclaredAction& action : interface.actions) actions.insert(action.name);
    }
    named_["reorient.ApplicationAction"] = one_of(std::move(actions));
  }

  void add_library() {
    for (const LibraryRow& row : library_rows()) {
      for (const std::string_view text : row.signatures) add_signature(text);
    }
  }

  void add_words(std::span<const ScriptWord> words) {
    for (const ScriptWord& word : words) {
      if (word.is_function()) add_signature(word.signature);
    }
  }

  /// Functions without a result are called for their effect, so a condition must not call them.
  void add_language(const ScriptLanguage& language) {
    for (const WorldField& field : language.world())
      table(std::string(field.table)).fields[std::string(field.name)] = field_symbol(field);
    for (const ScriptFunction& function : language.functions()) {
      FunctionSymbol symbol =
          symbol_of_function({function.table, function.name, function.arguments, function.result}, named_);
      symbol.acts = function.result.empty();
      add(function.table, function.name, std::move(symbol));
    }
    for (const FormerTable& former : language.former_tables()) former_.push_back(former);
  }

  void add_machines() {
    auto machines = new_table("behaviors");
    machines->missing = "unknown behavior '";
    for (const auto& [name, states] : declared_.behaviors) {
      auto machine = new_table("behaviors." + name);
      machine->fields = {{"state", states.empty() ? Symbol{kString} : one_of(states)}, {"time_in_state", {kNumber}}};
      machines->fields[name] = {kTable, std::move(machine)};
    }
    add_called();
    auto flags = new_table("published");
    flags->missing = "no state publishes '";
    for (const std::string& flag : declared_.published) flags->fields[flag] = {kBoolean};
    globals_.fields["behaviors"] = {kTable, std::move(machines)};
    globals_.fields["published"] = {kTable, std::move(flags)};
  }

  /// `called`: the behaviors that others run, whose machines are named "caller/behavior".
  void add_called() {
    auto all = new_table("called");
    all->missing = "no behavior runs '";
    std::map<std::string, std::set<std::string>> states;
    for (const auto& [name, paths] : declared_.behaviors) {
      if (const std::size_t slash = name.rfind('/'); slash != std::string::npos)
        states[name.substr(slash + 1)].insert(paths.begin(), paths.end());
    }
    for (const auto& [name, paths] : states) {
      auto one = new_table("called." + name);
      one->fields = {{"outcome", one_of({"running", "done", "failed"})},
                     {"reason", {kString}},
                     {"state", one_of(paths)},
                     {"time_in_state", {kNumber}}};
      all->fields[name] = {kTable, std::move(one)};
    }
    globals_.fields["called"] = {kTable, std::move(all)};
  }

  /// `input` and `action`: the values and actions of all interfaces. A value that two of them declare differently may
  /// have either type.
  void add_application() {
    auto input = values_table(nullptr);
    const Symbol age{kNumber}, valid{kBoolean};
    input->fields["age"] = {kTable, values_table(&age)};
    input->fields["valid"] = {kTable, values_table(&valid)};
    globals_.fields["input"] = {kTable, std::move(input)};
    auto actions = new_table("action");
    actions->missing = "the application has no action '";
    for (const ApplicationInterface& interface : declared_.interfaces) {
      for (const DeclaredAction& action : interface.actions) actions->fields[action.name] = action_symbol(action);
    }
    globals_.fields["action"] = {kTable, std::move(actions)};
  }

  void forget(const std::string& word) { globals_.fields.erase(word); }

  SymbolTable take() {
    for (auto& [name, table] : tables_) globals_.fields[name] = {kTable, std::move(table)};
    for (const FormerTable& former : former_) {
      Symbol symbol = globals_.fields[std::string(former.replacement)];
      symbol.replacement = former.replacement;
      globals_.fields[std::string(former.name)] = std::move(symbol);
    }
    return {std::move(globals_), {}, std::move(states_), false};
  }

 private:
  TableSymbol& table(const std::string& name) {
    std::shared_ptr<TableSymbol>& found = tables_[name];
    if (found == nullptr) found = new_table(name);
    return *found;
  }

  void add(const std::string& table_name, const std::string& name, FunctionSymbol function) {
    TableSymbol& owner = table_name.empty() ? globals_ : table(table_name);
    owner.fields[name] = {kFunction, nullptr, std::make_shared<const FunctionSymbol>(std::move(function))};
  }

  /// Takes the signature of a function, or "math.pi: number".
  void add_signature(std::string_view text) {
    if (text.find('(') != std::string_view::npos) {
      const Signature signature = read_signature(text);
      add(signature.table, signature.name, symbol_of_function(signature, named_));
      return;
    }
    const std::size_t dot = text.find('.');
    const std::size_t colon = text.find(':');
    table(std::string(text.substr(0, dot))).fields[std::string(text.substr(dot + 1, colon - dot - 1))] =
        symbol_of_type(text.substr(colon + 1), named_);
  }

  static Symbol content_symbol(const DeclaredField& field) {
    const auto coordinates = [&](std::initializer_list<const char*> names) {
      auto table = new_table(field.name.empty() ? "the value" : field.name);
      for (const char* const name : names) table->fields[name] = {kNumber};
      return Symbol{kTable, std::move(table)};
    };
    switch (field.type) {
      case FieldType::boolean:
        return {kBoolean};
      case FieldType::text:
        return field.choices.empty() ? Symbol{kString} : one_of({field.choices.begin(), field.choices.end()});
      case FieldType::point:
        return coordinates({"x", "y"});
      case FieldType::pose:
        return coordinates({"x", "y", "rotation"});
      case FieldType::number:
      case FieldType::integer:
        break;
    }
    return {kNumber};
  }

  /// `all`: the symbol of each value; nullptr: its content.
  std::shared_ptr<TableSymbol> values_table(const Symbol* all) const {
    auto table = new_table("input");
    table->missing = "input has no value '";
    std::map<std::string, std::shared_ptr<TableSymbol>> groups;
    const auto add_value = [](TableSymbol& owner, const std::string& name, Symbol symbol) {
      const auto [place, is_new] = owner.fields.emplace(name, symbol);
      if (!is_new && place->second.types != symbol.types) place->second = Symbol{};
    };
    for (const ApplicationInterface& interface : declared_.interfaces) {
      for (const DeclaredValue& value : interface.values) {
        const Symbol symbol = all != nullptr    ? *all
                              : value.is_list() ? Symbol{kTable}
                                                : content_symbol(value.fields.front());
        const std::size_t dot = value.name.find('.');
        if (dot == std::string::npos) {
          add_value(*table, value.name, symbol);
          continue;
        }
        std::shared_ptr<TableSymbol>& group = groups[value.name.substr(0, dot)];
        if (group == nullptr) group = new_table("input." + value.name.substr(0, dot));
        add_value(*group, value.name.substr(dot + 1), symbol);
      }
    }
    for (auto& [name, group] : groups) table->fields[name] = {kTable, std::move(group)};
    return table;
  }

  static Symbol action_symbol(const DeclaredAction& action) {
    auto arguments = new_table("action." + action.name);
    ArgumentSymbol argument{"arguments", {}, true};
    for (const DeclaredField& field : action.arguments) {
      arguments->fields[field.name] = content_symbol(field);
      argument.may_be_left_out = argument.may_be_left_out && !field.is_required;
    }
    argument.value = {kTable, std::move(arguments)};
    FunctionSymbol call;
    call.arguments.push_back(std::move(argument));
    call.most_results = 0;
    call.acts = true;
    auto status = new_table("action." + action.name);
    std::set<std::string> states;
    for (int i = 0; i < enum_count(ActionState()); ++i) states.emplace(to_string(static_cast<ActionState>(i)));
    status->fields = {{"state", one_of(std::move(states))}, {"reason", {kString}}, {"time_in_state", {kNumber}}};
    return {static_cast<ValueTypes>(kTable | kFunction), std::move(status),
            std::make_shared<const FunctionSymbol>(std::move(call))};
  }

  /// The argument of `set_world`: any of the tables with any of their fields.
  static Symbol world_changes() {
    auto world = std::make_shared<TableSymbol>(TableSymbol{"the world", "unknown world table '", {}, true});
    std::map<std::string_view, std::shared_ptr<TableSymbol>> tables;
    const ScenarioLanguage language;
    for (const WorldField& field : language.world()) {
      std::shared_ptr<TableSymbol>& table = tables[field.table];
      if (table == nullptr) table = new_table(std::string(field.table));
      table->fields[std::string(field.name)] = field_symbol(field);
    }
    for (auto& [name, table] : tables) world->fields[std::string(name)] = {kTable, std::move(table)};
    return {kTable, std::move(world)};
  }

  const DeclaredNames& declared_;
  NamedTypes named_;
  std::vector<FormerTable> former_;
  TableSymbol globals_{"", "unknown name '", {}, true};
  std::map<std::string, std::shared_ptr<TableSymbol>> tables_;
  std::map<std::string, std::set<std::string>> states_;
};

}  // namespace

SymbolTable symbol_table(ScriptRole role, const DeclaredNames& declared) {
  Vocabulary known(declared);
  known.add_library();
  if (role == ScriptRole::test) {
    known.add_words(test_words());
    for (const ScriptWord& word : language_words()) {  // the only word of behaviors that tests have
      if (word.name() == "print") known.add_words({&word, 1});
    }
    return known.take();
  }
  known.add_words(language_words());
  known.add_machines();
  if (role == ScriptRole::behavior) known.forget("scenario");
  if (role == ScriptRole::scenario) {
    for (const char* const word : {"behavior", "args", "run", "done", "failed", "called"}) known.forget(word);
  }
  // Behaviors and scenarios may both load a library, so it knows the names of both.
  if (role != ScriptRole::scenario) known.add_language(BehaviorLanguage());
  if (role != ScriptRole::scenario) known.add_application();
  if (role != ScriptRole::behavior) known.add_language(ScenarioLanguage());
  return known.take();
}

}  // namespace reorient
