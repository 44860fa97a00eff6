// SPDX-License-Identifier: MIT
#include "tests/workbench/script_tools/seeded_mistakes.h"

#include <algorithm>
#include <set>

#include "engine/script/language/world_fields.h"
#include "engine/script/source/lua_tokens.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

/// Replaces the bytes [begin, end).
struct Edit {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

class Seeder {
 public:
  Seeder(std::string_view script, const std::vector<std::string>& names, Random& random)
      : script_(script), tokens_(lua_tokens(script)), names_(names.begin(), names.end()), random_(random) {
    lines_.push_back(0);
    for (std::size_t i = 0; i < script.size(); ++i) {
      if (script[i] == '\n') lines_.push_back(i + 1);
    }
  }

  std::optional<SeededMistake> seed(Mistake mistake) {
    std::vector<Edit> all;
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) collect(mistake, i, all);
    if (all.empty()) return std::nullopt;
    const Edit edit = all[random_.below(all.size())];
    SeededMistake made;
    made.before = script_.substr(edit.begin, edit.end - edit.begin);
    made.after = edit.text;
    made.line =
        1 + static_cast<int>(std::count(script_.begin(), script_.begin() + static_cast<long>(edit.begin), '\n'));
    made.text = std::string(script_.substr(0, edit.begin)) + edit.text + std::string(script_.substr(edit.end));
    return made;
  }

 private:
  std::size_t offset(std::size_t i) const {
    const TextPosition& position = tokens_[i].position;
    return lines_[static_cast<std::size_t>(position.line) - 1] + static_cast<std::size_t>(position.column) - 1;
  }
  /// The byte after the token, including the quotes of a text.
  std::size_t end_of(std::size_t i) const {
    return offset(i) + tokens_[i].text.size() + (tokens_[i].kind == Kind::text ? 2 : 0);
  }
  bool is(std::size_t i, std::string_view symbol) const { return i < tokens_.size() && tokens_[i].is_symbol(symbol); }
  bool is_quoted(std::size_t i) const {
    return tokens_[i].kind == Kind::text && (script_[offset(i)] == '"' || script_[offset(i)] == '\'');
  }
  bool is_field(std::size_t i) const { return i > 0 && tokens_[i].kind == Kind::name && is(i - 1, "."); }

  /// Whether it is the bracket of a call, not of a function's declaration.
  bool opens_call(std::size_t i) const {
    if (i == 0 || !is(i, "(") || tokens_[i - 1].kind != Kind::name) return false;
    std::size_t first = i - 1;
    while (first >= 2 && (is(first - 1, ".") || is(first - 1, ":"))) first -= 2;
    return first == 0 || !tokens_[first - 1].is_keyword("function");
  }
  std::size_t closing(std::size_t open) const {
    std::size_t i = open + 1;
    while (i + 1 < tokens_.size() && !(is(i, ")") && tokens_[i].depth == tokens_[open].depth)) ++i;
    return i;
  }

  std::string with_other_letter(std::string word) {
    const std::size_t at = random_.below(word.size());
    if (at + 1 < word.size() && word[at] != word[at + 1] && random_.uniform() < 0.5) {
      std::swap(word[at], word[at + 1]);
      return word;
    }
    const char letter = static_cast<char>('a' + random_.below(26));
    word[at] = word[at] == letter ? 'q' : letter;
    return word;
  }

  void collect(Mistake mistake, std::size_t i, std::vector<Edit>& all) {
    const LuaToken& token = tokens_[i];
    switch (mistake) {
      case Mistake::letter_in_a_name:
        if (token.kind == Kind::name && token.text != "_")
          all.push_back({offset(i), end_of(i), with_other_letter(token.text)});
        return;
      case Mistake::letter_in_a_text:
        if (is_quoted(i) && names_.contains(token.text))
          all.push_back({offset(i) + 1, end_of(i) - 1, with_other_letter(token.text)});
        return;
      case Mistake::argument_dropped:
        if (opens_call(i)) drop_an_argument(i, all);
        return;
      case Mistake::argument_added:
        if (opens_call(i)) {
          const std::size_t end = closing(i);
          all.push_back({offset(end), offset(end), end == i + 1 ? "1" : ", 1"});
        }
        return;
      case Mistake::type_swapped:
        if (token.kind == Kind::number) all.push_back({offset(i), end_of(i), "\"" + token.text + "\""});
        if (is_quoted(i) || token.is_keyword("true") || token.is_keyword("false"))
          all.push_back({offset(i), end_of(i), "1"});
        return;
      case Mistake::state_renamed:
        if (is_quoted(i) && i > 0 && tokens_[i - 1].is(Kind::name, "state"))
          all.push_back({offset(i) + 1, end_of(i) - 1, token.text + "_renamed"});
        return;
      case Mistake::brackets_forgotten:
        if (opens_call(i) && is(i + 1, ")") && is_a_value(i)) all.push_back({offset(i), end_of(i + 1), ""});
        return;
      case Mistake::brackets_added:
        if (is_field(i) && !is(i + 1, "(") && !is(i + 1, ".") && !is(i + 1, "=") && !is(i + 1, ",") &&
            !is_in_declared_name(i))
          all.push_back({end_of(i), end_of(i), "()"});
        return;
      case Mistake::colon_for_dot:
        if (is_field(i) && opens_call(i + 1)) all.push_back({offset(i - 1), end_of(i - 1), ":"});
        return;
      case Mistake::other_table:
        if (is_field(i) && is_world_table(tokens_[i - 2].text))
          all.push_back({offset(i - 2), end_of(i - 2), other_table(i)});
        return;
    }
  }

  /// Removes an argument with the comma before or after it.
  void drop_an_argument(std::size_t open, std::vector<Edit>& all) const {
    const std::size_t end = closing(open);
    std::size_t begin = open + 1;
    for (std::size_t i = begin; i <= end && begin < end; ++i) {
      const bool is_separator = is(i, ",") && tokens_[i].depth == tokens_[open].depth + 1;
      if (!is_separator && i != end) continue;
      const std::size_t from = begin == open + 1 ? offset(begin) : offset(begin - 1);
      all.push_back({from, begin == open + 1 && i != end ? offset(i + 1) : offset(i), ""});
      begin = i + 1;
    }
  }

  /// Whether the value of the call is used. A call that is a whole statement is invalid without its brackets.
  bool is_a_value(std::size_t open) const {
    std::size_t first = open - 1;
    while (first >= 2 && (is(first - 1, ".") || is(first - 1, ":"))) first -= 2;
    if (first == 0) return false;
    const LuaToken& before = tokens_[first - 1];
    const bool is_operator =
        before.kind == Kind::symbol && before.text != ")" && before.text != "}" && before.text != ";";
    const bool is_keyword = before.is_keyword("return") || before.is_keyword("and") || before.is_keyword("or") ||
                            before.is_keyword("not") || before.is_keyword("if");
    return is_operator || is_keyword;
  }

  /// Whether it is part of `function a.b()`, or of the left side of a multiple assignment.
  bool is_in_declared_name(std::size_t i) const {
    for (std::size_t j = i + 1; j < tokens_.size() && tokens_[j].position.line == tokens_[i].position.line; ++j) {
      if (is(j, "=") && tokens_[j].depth == tokens_[i].depth) return true;
    }
    return false;
  }

  static bool is_world_table(std::string_view name) {
    const auto tables = world_tables();
    return std::any_of(tables.begin(), tables.end(), [&](const WorldTable& table) { return table.name == name; });
  }

  /// Another table without such a field.
  std::string other_table(std::size_t field) {
    const auto tables = world_tables();
    for (;;) {
      std::string name(tables[random_.below(tables.size())].name);
      const bool has_it = std::any_of(world_fields().begin(), world_fields().end(), [&](const WorldField& one) {
        return one.table == name && one.name == tokens_[field].text;
      });
      if (!has_it && name != tokens_[field - 2].text) return name;
    }
  }

  std::string_view script_;
  std::vector<LuaToken> tokens_;
  std::set<std::string> names_;
  Random& random_;
  std::vector<std::size_t> lines_;
};

}  // namespace

std::string_view to_string(Mistake mistake) {
  constexpr std::string_view kNames[] = {"a letter changed in a name",
                                         "a letter changed in a text that names something",
                                         "an argument removed",
                                         "an argument added",
                                         "a literal of another type",
                                         "a state renamed where it is declared",
                                         "the brackets of a call forgotten",
                                         "brackets after a field",
                                         "a colon for a dot in a call",
                                         "a field of another table of the world"};
  return kNames[static_cast<std::size_t>(mistake)];
}

std::optional<SeededMistake> seed_mistake(Mistake mistake, std::string_view script,
                                          const std::vector<std::string>& names, Random& random) {
  return Seeder(script, names, random).seed(mistake);
}

}  // namespace reorient
