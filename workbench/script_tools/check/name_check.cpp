#include "workbench/script_tools/check/name_check.h"

#include <algorithm>
#include <set>
#include <utility>

#include "workbench/script_tools/check/name_resolution.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

/// More than Lua itself allows.
constexpr int kDeepest = 250;

bool is_condition_key(const std::string& key) { return key == "when" || key == "lasting" || key == "after"; }

/// Reads a script as Lua's own parser does, by recursive descent, and keeps of it only what names mean.
class NameCheck {
 public:
  NameCheck(std::string_view text, const SymbolTable& known) : tokens_(lua_tokens(text)), names_(known) {}

  std::vector<DeclarationError> run() {
    names_.open_scope();
    while (here().kind != Kind::end && !too_deep_) {
      read_block();
      if (here().kind != Kind::end) ++at_;  // an `end` too many: not valid Lua, go on
    }
    return names_.take_errors();
  }

 private:
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

  // ---- statements

  bool ends_block() const {
    return here().kind == Kind::end || sees("end") || sees("else") || sees("elseif") || sees("until");
  }

  void read_block() {
    const Depth depth(*this);
    while (!ends_block() && !too_deep_) read_statement();
  }

  void read_scoped_block() {
    names_.open_scope();
    read_block();
    names_.close_scope();
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
      names_.open_scope();  // `until` sees the locals of the block
      read_block();
      if (take("until")) read_expression();
      names_.close_scope();
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
    names_.open_scope();
    std::vector<std::string> names{take_any().text};
    while (take(",")) names.push_back(take_any().text);
    if (!take("=")) take("in");
    read_expressions();
    for (const std::string& name : names) names_.declare(name);
    take("do");
    read_block();
    take("end");
    names_.close_scope();
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
      names_.of(name);
    } else {
      names_.assign(name);
    }
    read_function_body(has_self, false);
  }

  void read_local() {
    if (take("function")) {
      names_.declare(take_any().text);
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
      names_.declare(names[i], i < values.size() ? std::move(values[i].meaning) : Meaning{});
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
      // What is put together is no state's name yet.
      if ((operation == "==" || operation == "~=") && !sees("..")) names_.compare(value, right);
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
    names_.open_scope();
    if (has_self) names_.declare("self");
    take("(");
    while (!sees(")") && here().kind != Kind::end) {
      const LuaToken& parameter = take_any();
      if (parameter.kind == Kind::name) names_.declare(parameter.text);
      if (!take(",")) break;
    }
    take(")");
    const bool was_condition = std::exchange(in_condition_, in_condition_ || is_condition);
    read_block();
    in_condition_ = was_condition;
    take("end");
    names_.close_scope();
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
        names_.assign(name);
      } else {
        value.meaning = names_.of(name);
      }
    } else {
      if (here().kind != Kind::end && !ends_block()) ++at_;  // not valid Lua; go on behind it
      return value;
    }
    while (!too_deep_) {
      if (take(".")) {
        const LuaToken& field = take_any();
        Expression part;
        if (sees("=")) {
          names_.assign_field(value.meaning, field);
        } else {
          part.meaning = names_.of_field(value.meaning, field);
        }
        value = std::move(part);
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
    return names_.call(function, first, std::move(arguments), in_condition_);
  }

  std::vector<LuaToken> tokens_;
  NameResolution names_;
  std::size_t at_ = 0;
  bool in_condition_ = false;
  int depth_ = 0;
  bool too_deep_ = false;
};

}  // namespace

std::vector<DeclarationError> check_names(std::string_view text, const SymbolTable& known) {
  return NameCheck(text, known).run();
}

}  // namespace reorient
