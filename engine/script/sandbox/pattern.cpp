// SPDX-License-Identifier: MIT
#include "engine/script/sandbox/pattern.h"

#include <array>
#include <cctype>

namespace reorient {
namespace {

constexpr std::size_t kMostCaptures = 32;
constexpr int kDeepest = 200;

using Set = std::bitset<256>;

std::size_t code(char letter) { return static_cast<unsigned char>(letter); }

bool is_in_class(char kind, int letter) {
  switch (kind) {
    case 'a':
      return std::isalpha(letter) != 0;
    case 'c':
      return std::iscntrl(letter) != 0;
    case 'd':
      return std::isdigit(letter) != 0;
    case 'g':
      return std::isgraph(letter) != 0;
    case 'l':
      return std::islower(letter) != 0;
    case 'p':
      return std::ispunct(letter) != 0;
    case 's':
      return std::isspace(letter) != 0;
    case 'u':
      return std::isupper(letter) != 0;
    case 'w':
      return std::isalnum(letter) != 0;
    case 'x':
      return std::isxdigit(letter) != 0;
    case 'z':  // no longer in the manual, but still supported by Lua
      return letter == 0;
    default:
      return false;
  }
}

/// The sets of %a, %d ... by their letter; an upper-case letter is the complement, any other character is itself.
/// Created once, so that a pattern of two thousand classes does not cost more than its letters.
std::array<Set, 256> make_classes() {
  std::array<Set, 256> classes;
  for (std::size_t letter = 0; letter < classes.size(); ++letter) {
    const char kind = static_cast<char>(std::tolower(static_cast<int>(letter)));
    for (int c = 0; c < 256; ++c) classes[letter][static_cast<std::size_t>(c)] = is_in_class(kind, c);
    if (classes[letter].none()) {
      classes[letter].set(letter);
    } else if (std::isupper(static_cast<int>(letter)) != 0) {
      classes[letter].flip();
    }
  }
  return classes;
}

const Set& letter_class(char letter) {
  static const std::array<Set, 256> classes = make_classes();
  return classes[code(letter)];
}

/// All characters from the first to the last; empty if the last is before the first.
Set range(char first, char last) {
  if (code(last) < code(first)) return {};
  return (~Set() >> (255 - (code(last) - code(first)))) << code(first);
}

/// The end of a set whose first character is at `at`: the first ']' that is neither that one nor after a '%'.
std::size_t end_of_set(std::string_view text, std::size_t at) {
  for (bool first = true;; first = false) {
    if (at >= text.size()) throw PatternError("malformed pattern (missing ']')");
    const char letter = text[at];
    if (letter == ']' && !first) return at;
    at += letter == '%' ? 2 : 1;
  }
}

/// A set in brackets; `at` is after the '[' and moves past the ']'. As in Lua, the search for the end ignores
/// ranges, and the last character of a range is literal, also a '%'.
Set read_set(std::string_view text, std::size_t& at) {
  Set set;
  const bool complement = at < text.size() && text[at] == '^';
  if (complement) ++at;
  const std::size_t end = end_of_set(text, at);
  while (at < end) {
    const char letter = text[at++];
    if (letter == '%') {
      set |= letter_class(text[at++]);
    } else if (at + 1 < end && text[at] == '-') {
      set |= range(letter, text[at + 1]);
      at += 2;
    } else {
      set.set(code(letter));
    }
  }
  at = end + 1;
  return complement ? ~set : set;
}

}  // namespace

Pattern::Item Pattern::read_escape(std::string_view text, std::size_t& at) {
  if (at >= text.size()) throw PatternError("malformed pattern (ends with '%')");
  Item item;
  const char letter = text[at++];
  if (letter == 'b') {
    if (at + 1 >= text.size()) throw PatternError("malformed pattern (missing arguments to '%b')");
    item.kind = Kind::balance;
    item.left = text[at];
    item.right = text[at + 1];
    at += 2;
  } else if (letter == 'f') {
    if (at >= text.size() || text[at] != '[') throw PatternError("missing '[' after '%f' in pattern");
    item.kind = Kind::frontier;
    item.set = read_set(text, ++at);
  } else if (std::isdigit(static_cast<unsigned char>(letter)) != 0) {
    item.kind = Kind::reference;
    item.capture = static_cast<std::size_t>(letter - '1');
    if (letter == '0' || item.capture >= captures_) throw PatternError("invalid capture index in pattern");
  } else {
    item.set = letter_class(letter);
  }
  return item;
}

Pattern::Repeat Pattern::read_repeat(std::string_view text, std::size_t& at) {
  if (at >= text.size()) return Repeat::once;
  Repeat repeat = Repeat::once;
  switch (text[at]) {
    case '?':
      repeat = Repeat::optional;
      break;
    case '*':
      repeat = Repeat::greedy;
      break;
    case '+':
      repeat = Repeat::greedy_some;
      break;
    case '-':
      repeat = Repeat::lazy;
      break;
    default:
      return Repeat::once;
  }
  ++at;
  return repeat;
}

Pattern::Pattern(std::string_view text) {
  std::size_t at = 0;
  if (text.starts_with('^')) {
    anchored_ = true;
    ++at;
  }
  std::vector<std::size_t> open;
  while (at < text.size()) {
    const char letter = text[at++];
    Item item;
    if (letter == '(') {
      if (captures_ >= kMostCaptures) throw PatternError("too many captures");
      item.capture = captures_++;
      const bool position = at < text.size() && text[at] == ')';
      item.kind = position ? Kind::position : Kind::open;
      if (position) {
        ++at;
      } else {
        open.push_back(item.capture);
      }
    } else if (letter == ')') {
      if (open.empty()) throw PatternError("invalid pattern capture");
      item.kind = Kind::close;
      item.capture = open.back();
      open.pop_back();
    } else if (letter == '$' && at == text.size()) {
      item.kind = Kind::subject_end;
    } else if (letter == '%') {
      item = read_escape(text, at);
    } else if (letter == '[') {
      item.set = read_set(text, at);
    } else if (letter == '.') {
      item.set.set();
    } else {
      item.set.set(code(letter));
    }
    if (item.kind == Kind::one) item.repeat = read_repeat(text, at);
    items_.push_back(item);
  }
  if (!open.empty()) throw PatternError("unfinished capture");
}

/// One attempt at one position of the subject.
class Pattern::Run {
 public:
  Run(const Pattern& pattern, std::string_view subject, std::int64_t& steps)
      : items_(pattern.items_), subject_(subject), steps_(steps), captures_(pattern.captures_) {}

  /// The end of a match at `at` of all items starting with `item`.
  std::optional<std::size_t> match(std::size_t at, std::size_t item) {
    if (++depth_ > kDeepest) throw PatternError("pattern too complex");
    const std::optional<std::size_t> end = follow(at, item);
    --depth_;
    return end;
  }

  const std::vector<Capture>& captures() const { return captures_; }

 private:
  void pay() {
    if (--steps_ < 0) throw PatternTooCostly();
  }

  bool fits(std::size_t at, const Item& item) const { return at < subject_.size() && item.set[code(subject_[at])]; }

  std::optional<std::size_t> follow(std::size_t at, std::size_t index) {
    for (; index < items_.size(); ++index) {
      pay();
      const Item& item = items_[index];
      std::optional<std::size_t> next;
      switch (item.kind) {
        case Kind::one:
          if (item.repeat != Repeat::once) return repeated(at, index);
          if (fits(at, item)) next = at + 1;
          break;
        case Kind::open:
        case Kind::position:
        case Kind::close:
          return captured(at, index);
        case Kind::balance:
          next = balanced(at, item);
          break;
        case Kind::frontier:
          next = frontier(at, item);
          break;
        case Kind::reference:
          next = repetition(at, item);
          break;
        case Kind::subject_end:
          if (at == subject_.size()) next = at;
          break;
      }
      if (!next) return std::nullopt;
      at = *next;
    }
    return at;
  }

  std::optional<std::size_t> repeated(std::size_t at, std::size_t index) {
    const Item& item = items_[index];
    if (item.repeat == Repeat::lazy) {
      for (;; ++at) {
        if (const auto end = match(at, index + 1)) return end;
        pay();
        if (!fits(at, item)) return std::nullopt;
      }
    }
    const std::size_t least = item.repeat == Repeat::greedy_some ? 1 : 0;
    const std::size_t most = item.repeat == Repeat::optional ? 1 : subject_.size();
    std::size_t count = 0;
    for (; count < most && fits(at + count, item); ++count) pay();
    for (;; --count) {
      if (count < least) return std::nullopt;
      if (const auto end = match(at + count, index + 1)) return end;
      if (count == 0) return std::nullopt;
    }
  }

  std::optional<std::size_t> captured(std::size_t at, std::size_t index) {
    const Item& item = items_[index];
    Capture& capture = captures_[item.capture];
    const Capture before = capture;
    if (item.kind == Kind::close) {
      capture.length = at - capture.start;
      capture.closed = true;
    } else {
      capture = {at, 0, item.kind == Kind::position, item.kind == Kind::position};
    }
    const auto end = match(at, index + 1);
    if (!end) captures_[item.capture] = before;
    return end;
  }

  std::optional<std::size_t> balanced(std::size_t at, const Item& item) {
    if (at >= subject_.size() || subject_[at] != item.left) return std::nullopt;
    std::size_t depth = 1;
    for (std::size_t i = at + 1; i < subject_.size(); ++i) {
      pay();
      if (subject_[i] == item.right) {
        if (--depth == 0) return i + 1;
      } else if (subject_[i] == item.left) {
        ++depth;
      }
    }
    return std::nullopt;
  }

  std::optional<std::size_t> frontier(std::size_t at, const Item& item) const {
    const char before = at == 0 ? '\0' : subject_[at - 1];
    const char here = at < subject_.size() ? subject_[at] : '\0';
    if (item.set[code(before)] || !item.set[code(here)]) return std::nullopt;
    return at;
  }

  std::optional<std::size_t> repetition(std::size_t at, const Item& item) {
    const Capture& capture = captures_[item.capture];
    if (!capture.closed || capture.is_position) throw PatternError("invalid capture index in pattern");
    steps_ -= static_cast<std::int64_t>(capture.length / 16);
    if (subject_.substr(at, capture.length) != subject_.substr(capture.start, capture.length)) return std::nullopt;
    return at + capture.length;
  }

  const std::vector<Item>& items_;
  std::string_view subject_;
  std::int64_t& steps_;
  std::vector<Capture> captures_;
  int depth_ = 0;
};

std::optional<Pattern::Match> Pattern::search(std::string_view subject, std::size_t from, std::int64_t& steps) const {
  Run run(*this, subject, steps);
  for (std::size_t begin = from; begin <= subject.size(); ++begin) {
    if (--steps < 0) throw PatternTooCostly();
    if (const auto end = run.match(begin, 0)) return Match{begin, *end, run.captures()};
    if (anchored_) break;
  }
  return std::nullopt;
}

}  // namespace reorient
