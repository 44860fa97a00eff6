#include "engine/script/check/name_check.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/script/source/lua_tokens.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

/// What an expression stands for, as far as that is plain from the text.
struct Meaning {
  enum class Kind { anything, table, function, params, machines, machine, machine_state };

  Kind kind = Kind::anything;
  std::string name;                         ///< as it is called in messages; of a machine: its name
  const KnownTable* table = nullptr;        ///< of a table
  const KnownFunction* function = nullptr;  ///< of a function
  std::set<std::string> keys;               ///< of params
};

struct Expression {
  Meaning meaning;
  const LuaToken* literal = nullptr;  ///< where it is one token: a text, a number, true, false or nil
  bool is_open_ended = false;         ///< a call or ..., which may stand for several values
  std::set<std::string> keys;         ///< of a table constructor
};

/// More than Lua itself allows.
constexpr int kDeepest = 250;

bool is_condition_key(const std::string& key) { return key == "when" || key == "lasting" || key == "after"; }

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

/// Reads a script as Lua's own parser does, by recursive descent, and keeps of it only what names mean.
class NameCheck {
 public:
  NameCheck(std::string_view text, const KnownNames& known) : tokens_(lua_tokens(text)), known_(known) {}

  std::vector<DeclarationError> run() {
    open_scope();
    while (here().kind != Kind::end && !too_deep_) {
      read_block();
      if (here().kind != Kind::end) ++at_;  // an `end` too many: not valid Lua, go on
    }
    std::stable_sort(errors_.begin(), errors_.end(),
                     [](const auto& left, const auto& right) { return is_before(left.position, right.position); });
    return std::move(errors_);
  }

 private:
  using Scope = std::vector<std::pair<std::string, Meaning>>;

  /// One level deeper while it lives; beyond kDeepest reading ends, however the text goes on.
  struct Depth {
    explicit Depth(NameCheck& owner) : check(owner) { check.too_deep_ |= ++check.depth_ > kDeepest; }
    ~Depth() { --check.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    NameCheck& check;
  };

  // ---- tokens

  const LuaToken& here() const { return tokens_[std::min(at_, tokens_.size() - 1)]; }
  const LuaToken& after() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  bool sees(std::string_view text) const {
    return (here().kind == Kind::symbol || here().kind == Kind::keyword) && here().text == text;
  }
  bool take(std::string_view text) {
    if (!sees(text)) return false;
    ++at_;
    return true;
  }
  const LuaToken& take_any() {
    const LuaToken& token = here();
    if (token.kind != Kind::end) ++at_;
    return token;
  }

  void note(const LuaToken& token, const std::string& message) { errors_.push_back({token.position, message}); }

  // ---- scopes

  void open_scope() { scopes_.emplace_back(); }
  void close_scope() { scopes_.pop_back(); }
  void declare(const std::string& name, Meaning meaning = {}) { scopes_.back().emplace_back(name, std::move(meaning)); }
  Meaning* find_local(const std::string& name) {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
      for (auto local = scope->rbegin(); local != scope->rend(); ++local) {
        if (local->first == name) return &local->second;
      }
    }
    return nullptr;
  }

  // ---- statements

  bool ends_block() const {
    return here().kind == Kind::end || sees("end") || sees("else") || sees("elseif") || sees("until");
  }

  void read_block() {
    const Depth depth(*this);
    while (!ends_block() && !too_deep_) read_statement();
  }

  void read_scoped_block() {
    open_scope();
    read_block();
    close_scope();
  }

  void read_statement() {
    if (take(";") || take("break")) return;
    if (take("::")) {
      take_any();
      take("::");
    } else if (take("goto")) {
      take_any();
    } else if (take("do")) {
      read_scoped_block();
      take("end");
    } else if (take("while")) {
      read_expression();
      take("do");
      read_scoped_block();
      take("end");
    } else if (take("repeat")) {
      open_scope();  // `until` sees the locals of the block
      read_block();
      if (take("until")) read_expression();
      close_scope();
    } else if (take("if")) {
      read_if();
    } else if (take("for")) {
      read_for();
    } else if (take("function")) {
      read_function_statement();
    } else if (take("local")) {
      read_local();
    } else if (take("return")) {
      if (!ends_block() && !sees(";")) read_expressions();
    } else {
      read_assignment_or_call();
    }
  }

  void read_if() {
    do {
      read_expression();
      take("then");
      read_scoped_block();
    } while (take("elseif"));
    if (take("else")) read_scoped_block();
    take("end");
  }

  void read_for() {
    open_scope();
    std::vector<std::string> names{take_any().text};
    while (take(",")) names.push_back(take_any().text);
    if (!take("=")) take("in");
    read_expressions();
    for (const std::string& name : names) declare(name);
    take("do");
    read_block();
    take("end");
    close_scope();
  }

  void read_function_statement() {
    const LuaToken& name = take_any();
    const bool is_field = sees(".") || sees(":");
    bool has_self = false;
    while (sees(".") || sees(":")) {
      has_self = take(":") || (take("."), false);
      take_any();
    }
    if (is_field) {
      look_up(name);
    } else {
      check_assigned_name(name);
    }
    read_function_body(has_self, false);
  }

  void read_local() {
    if (take("function")) {
      declare(take_any().text);
      read_function_body(false, false);
      return;
    }
    std::vector<std::string> names;
    do {
      names.push_back(take_any().text);
      if (take("<")) {
        take_any();
        take(">");
      }
    } while (take(","));
    std::vector<Expression> values;
    if (take("=")) values = read_expressions();
    for (std::size_t i = 0; i < names.size(); ++i) {
      declare(names[i], i < values.size() ? std::move(values[i].meaning) : Meaning{});
    }
  }

  /// What stands left of `=`: the last name or field of it is written, not read.
  void read_assignment_or_call() {
    const std::size_t start = at_;
    do read_suffixed(is_plain_assignment());
    while (take(","));
    if (take("=")) {
      read_expressions();
    } else if (at_ == start) {
      ++at_;  // not valid Lua; go on behind it
    }
  }

  /// Whether a statement begins here whose first left side is a plain name.
  bool is_plain_assignment() const {
    return here().kind == Kind::name && (after().is_symbol("=") || after().is_symbol(","));
  }

  void check_assigned_name(const LuaToken& name) {
    if (Meaning* local = find_local(name.text)) {
      *local = Meaning{};
    } else if (known_.globals.contains(name.text)) {
      note(name, "'" + name.text + "' is read-only");
    } else {
      note(name, "'" + name.text + "' would be a global variable, which no reload keeps: write 'local " + name.text +
                     "', or keep { } for memory");
    }
  }

  // ---- expressions

  std::vector<Expression> read_expressions() {
    std::vector<Expression> all;
    do all.push_back(read_expression());
    while (take(",") && !too_deep_);
    return all;
  }

  static bool is_operator(const LuaToken& token) {
    static const std::set<std::string> kOperators{"+",  "-",  "*",  "/",  "//", "%",  "^",  "&", "|", "~",
                                                  ">>", "<<", "..", "==", "~=", "<=", ">=", "<", ">"};
    return token.kind == Kind::symbol ? kOperators.contains(token.text)
                                      : token.is_keyword("and") || token.is_keyword("or");
  }

  Expression read_expression() {
    const Depth depth(*this);
    if (too_deep_) return {};
    bool is_compound = false;
    Expression value = read_operand(is_compound);
    while (is_operator(here()) && !too_deep_) {
      const std::string operation = take_any().text;
      Expression right = read_operand(is_compound);
      if (operation == "==" || operation == "~=") {
        check_compared_state(value, right);
        check_compared_state(right, value);
      }
      value = std::move(right);
      is_compound = true;
    }
    return is_compound ? Expression{} : value;
  }

  Expression read_operand(bool& is_compound) {
    while (sees("-") || sees("#") || sees("~") || sees("not")) {
      ++at_;
      is_compound = true;
    }
    return read_simple();
  }

  /// behaviors.NAME.state == "a state that it does not have"
  void check_compared_state(const Expression& state, const Expression& text) {
    if (state.meaning.kind != Meaning::Kind::machine_state || text.literal == nullptr) return;
    if (text.literal->kind != Kind::text || sees("..")) return;
    const std::set<std::string>& states = known_.states.at(state.meaning.name);
    if (states.contains(text.literal->text)) return;
    note(*text.literal, state.meaning.name + " has no state '" + text.literal->text + "'" +
                            did_you_mean(text.literal->text, listed(states)));
  }

  Expression read_simple() {
    const LuaToken& token = here();
    if (token.kind == Kind::number || token.kind == Kind::text || sees("nil") || sees("true") || sees("false")) {
      ++at_;
      return {{}, &token, false, {}};
    }
    if (take("...")) return {{}, nullptr, true, {}};
    if (sees("{")) return read_table();
    if (take("function")) {
      read_function_body(false, false);
      return {};
    }
    return read_suffixed(false);
  }

  Expression read_table() {
    const Depth depth(*this);
    Expression table;
    take("{");
    while (!sees("}") && here().kind != Kind::end && !too_deep_) {
      if (take("[")) {
        read_expression();
        take("]");
        take("=");
        read_expression();
      } else if (here().kind == Kind::name && after().is_symbol("=")) {
        const std::string key = take_any().text;
        table.keys.insert(key);
        take("=");
        if (sees("function") && is_condition_key(key)) {
          take("function");
          read_function_body(false, true);
        } else {
          read_expression();
        }
      } else {
        read_expression();
      }
      if (!take(",") && !take(";") && !sees("}")) break;
    }
    take("}");
    return table;
  }

  void read_function_body(bool has_self, bool is_condition) {
    open_scope();
    if (has_self) declare("self");
    take("(");
    while (!sees(")") && here().kind != Kind::end) {
      const LuaToken& parameter = take_any();
      if (parameter.kind == Kind::name) declare(parameter.text);
      if (!take(",")) break;
    }
    take(")");
    const bool was_condition = std::exchange(in_condition_, in_condition_ || is_condition);
    read_block();
    in_condition_ = was_condition;
    take("end");
    close_scope();
  }

  Expression read_suffixed(bool is_written) {
    Expression value;
    if (take("(")) {
      value = read_expression();
      take(")");
      value.is_open_ended = false;
    } else if (here().kind == Kind::name) {
      const LuaToken& name = take_any();
      if (is_written) {
        check_assigned_name(name);
      } else {
        value.meaning = look_up(name);
      }
    } else {
      if (here().kind != Kind::end && !ends_block()) ++at_;  // not valid Lua; go on behind it
      return value;
    }
    while (!too_deep_) {
      if (take(".")) {
        const LuaToken& field = take_any();
        const bool is_assigned = sees("=");
        value = {is_assigned ? check_assigned_field(value.meaning, field) : field_of(value.meaning, field),
                 nullptr,
                 false,
                 {}};
      } else if (take("[")) {
        read_expression();
        take("]");
        value = Expression{};
      } else if (take(":")) {
        take_any();
        read_arguments({});
        value = {{}, nullptr, true, {}};
      } else if (sees("(") || sees("{") || here().kind == Kind::text) {
        value = {read_arguments(value.meaning), nullptr, true, {}};
      } else {
        break;
      }
    }
    return value;
  }

  /// What a call gives, of which only that of `param` and `require` is known.
  Meaning read_arguments(const Meaning& function) {
    const LuaToken& first = here();
    std::vector<Expression> arguments;
    if (take("(")) {
      if (!sees(")")) arguments = read_expressions();
      take(")");
    } else if (sees("{")) {
      arguments.push_back(read_table());
    } else {
      arguments.push_back({{}, &take_any(), false, {}});
    }
    if (function.kind != Meaning::Kind::function) return {};
    if (function.function != nullptr) check_call(function, first, arguments);
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

  void check_call(const Meaning& called, const LuaToken& place, const std::vector<Expression>& arguments) {
    const KnownFunction& function = *called.function;
    if (function.acts && in_condition_)
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

  static std::string count_text(std::size_t count) {
    return count == 0 ? "no argument" : std::to_string(count) + (count == 1 ? " argument" : " arguments");
  }

  // ---- names

  Meaning look_up(const LuaToken& name) {
    if (const Meaning* local = find_local(name.text)) return *local;
    if (!known_.globals.contains(name.text)) {
      std::vector<std::string> candidates = listed(known_.globals);
      for (const Scope& scope : scopes_) {
        for (const auto& local : scope) candidates.push_back(local.first);
      }
      note(name, "there is no '" + name.text + "'" + did_you_mean(name.text, candidates));
      return {};
    }
    if (name.text == "behaviors") return {Meaning::Kind::machines, name.text, nullptr, nullptr, {}};
    if (const auto table = known_.tables.find(name.text); table != known_.tables.end())
      return {Meaning::Kind::table, name.text, &table->second, nullptr, {}};
    const auto function = known_.functions.find(name.text);
    const KnownFunction* signature = function == known_.functions.end() ? nullptr : &function->second;
    return {Meaning::Kind::function, name.text, nullptr, signature, {}};
  }

  Meaning field_of(const Meaning& owner, const LuaToken& field) {
    const std::string full_name = owner.name + "." + field.text;
    switch (owner.kind) {
      case Meaning::Kind::table: {
        if (!owner.table->fields.contains(field.text)) {
          note(field, "there is no " + full_name + did_you_mean(field.text, listed(owner.table->fields)));
          return {};
        }
        const auto function = owner.table->functions.find(field.text);
        if (function == owner.table->functions.end()) return {};
        return {Meaning::Kind::function, full_name, nullptr, &function->second, {}};
      }
      case Meaning::Kind::params:
        if (!owner.keys.contains(field.text))
          note(field, "there is no param '" + field.text + "'" + did_you_mean(field.text, listed(owner.keys)));
        return {};
      case Meaning::Kind::machines: {
        if (known_.states.empty()) return {};  // nobody told which machines there are
        if (known_.states.contains(field.text)) return {Meaning::Kind::machine, field.text, nullptr, nullptr, {}};
        std::vector<std::string> names;
        for (const auto& machine : known_.states) names.push_back(machine.first);
        note(field, "there is no behavior '" + field.text + "'" + did_you_mean(field.text, names));
        return {};
      }
      case Meaning::Kind::machine:
        if (field.text == "state") return {Meaning::Kind::machine_state, owner.name, nullptr, nullptr, {}};
        if (field.text != "time_in_state") {
          const std::vector<std::string> fields{"state", "time_in_state"};
          note(field, "there is no behaviors." + full_name + did_you_mean(field.text, fields));
        }
        return {};
      default:
        return {};
    }
  }

  Meaning check_assigned_field(const Meaning& owner, const LuaToken& field) {
    const bool is_read_only = (owner.kind == Meaning::Kind::table && owner.table->is_read_only) ||
                              owner.kind == Meaning::Kind::params || owner.kind == Meaning::Kind::machines ||
                              owner.kind == Meaning::Kind::machine;
    if (is_read_only) note(field, owner.name + "." + field.text + " is read-only");
    return {};
  }

  std::vector<LuaToken> tokens_;
  const KnownNames& known_;
  std::size_t at_ = 0;
  std::vector<Scope> scopes_;
  std::vector<DeclarationError> errors_;
  bool in_condition_ = false;
  int depth_ = 0;
  bool too_deep_ = false;
};

}  // namespace

std::vector<DeclarationError> check_names(std::string_view text, const KnownNames& known) {
  return NameCheck(text, known).run();
}

}  // namespace reorient
