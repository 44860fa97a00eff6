// SPDX-License-Identifier: MIT
#include "engine/script/source/lua_tokens.h"

#include <algorithm>
#include <array>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

constexpr std::array<std::string_view, 22> kKeywords{
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

// The longest symbols first.
constexpr std::array<std::string_view, 11> kLongSymbols{
    "...", "..", "==", "~=", "<=", ">=", "//", "::", "<<", ">>", "->"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {
    if (text_.starts_with('#')) skip_line();  // as in Lua: for scripts that a shell starts
  }

  std::vector<LuaToken> all() {
    std::vector<LuaToken> tokens;
    do {
      tokens.push_back(next());
    } while (tokens.back().kind != Kind::end);
    return tokens;
  }

 private:
  char at(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool is_over() const { return at_ >= text_.size(); }

  void advance(std::size_t count) {
    for (; count > 0 && !is_over(); --count) {
      if (text_[at_++] == '\n') {
        ++position_.line;
        line_start_ = at_;
      }
    }
    position_.column = static_cast<int>(at_ - line_start_) + 1;
  }

  void skip_line() {
    while (!is_over() && at(0) != '\n') advance(1);
  }

  /// Number of = in the long bracket that opens here; -1: no bracket.
  int long_bracket() const {
    if (at(0) != '[') return -1;
    std::size_t level = 0;
    while (at(1 + level) == '=') ++level;
    return at(1 + level) == '[' ? static_cast<int>(level) : -1;
  }

  std::string take_long_text(int level) {
    const std::string closing = "]" + std::string(static_cast<std::size_t>(level), '=') + "]";
    advance(closing.size());
    const std::size_t begin = at_;
    const std::size_t end = std::min(text_.find(closing, begin), text_.size());
    advance(end - begin + closing.size());
    return std::string(text_.substr(begin, end - begin));
  }

  std::string take_text() {
    const char quote = at(0);
    advance(1);
    const std::size_t begin = at_;
    while (!is_over() && at(0) != quote && at(0) != '\n') advance(at(0) == '\\' ? 2 : 1);
    const std::size_t end = at_;
    if (at(0) == quote) advance(1);
    return std::string(text_.substr(begin, end - begin));
  }

  void skip_blanks_and_comments() {
    while (!is_over()) {
      if (is_blank(at(0))) {
        advance(1);
      } else if (at(0) == '-' && at(1) == '-') {
        advance(2);
        if (const int level = long_bracket(); level >= 0) {
          take_long_text(level);
        } else {
          skip_line();
        }
      } else {
        return;
      }
    }
  }

  std::string take_while(bool (*belongs)(char)) {
    const std::size_t begin = at_;
    while (!is_over() && belongs(at(0))) advance(1);
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string take_number() {
    const std::size_t begin = at_;
    while (!is_over()) {
      const bool exponent = at(0) == 'e' || at(0) == 'E' || at(0) == 'p' || at(0) == 'P';
      const bool hexadecimal = text_.substr(begin, 2) == "0x" || text_.substr(begin, 2) == "0X";
      const bool is_sign_next = at(1) == '+' || at(1) == '-';
      const bool takes_sign = exponent && is_sign_next && (hexadecimal == (at(0) == 'p' || at(0) == 'P'));
      if (takes_sign) {
        advance(2);
      } else if (is_letter(at(0)) || is_digit(at(0)) || at(0) == '.') {
        advance(1);
      } else {
        break;
      }
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string take_symbol() {
    for (const std::string_view symbol : kLongSymbols) {
      if (text_.substr(at_, symbol.size()) != symbol) continue;
      advance(symbol.size());
      return std::string(symbol);
    }
    std::string symbol(1, at(0));
    advance(1);
    return symbol;
  }

  LuaToken next() {
    skip_blanks_and_comments();
    LuaToken token{Kind::end, {}, position_, depth_};
    if (is_over()) return token;
    const char c = at(0);
    if (is_letter(c)) {
      token.text = take_while([](char letter) { return is_letter(letter) || is_digit(letter); });
      const bool keyword = std::find(kKeywords.begin(), kKeywords.end(), token.text) != kKeywords.end();
      token.kind = keyword ? Kind::keyword : Kind::name;
    } else if (is_digit(c) || (c == '.' && is_digit(at(1)))) {
      token.kind = Kind::number;
      token.text = take_number();
    } else if (c == '"' || c == '\'') {
      token.kind = Kind::text;
      token.text = take_text();
    } else if (const int level = long_bracket(); level >= 0) {
      token.kind = Kind::text;
      token.text = take_long_text(level);
    } else {
      token.kind = Kind::symbol;
      token.text = take_symbol();
      if (token.text == "(" || token.text == "[" || token.text == "{") ++depth_;
      if (token.text == ")" || token.text == "]" || token.text == "}") token.depth = --depth_;
    }
    return token;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  TextPosition position_{1, 1};
  int depth_ = 0;
};

}  // namespace

std::vector<LuaToken> lua_tokens(std::string_view text) {
  return Tokenizer(without_byte_order_mark(text)).all();  // as Sandbox::compile()
}

}  // namespace reorient
