// Texts as libedit has them: wide letters, in a locale.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <locale.h>

namespace reorient {

/// libedit goes by the locale, the rest of the program by none: while this lives, letters are UTF-8 in this thread.
class Utf8Letters {
 public:
  Utf8Letters();
  ~Utf8Letters() { uselocale(before_); }
  Utf8Letters(const Utf8Letters&) = delete;
  Utf8Letters& operator=(const Utf8Letters&) = delete;

 private:
  locale_t before_;
};

// Those below need Utf8Letters; what cannot be converted is left out.

std::wstring wide(std::string_view text);
std::string narrow(std::wstring_view letters);
/// In columns of a terminal, as libedit shows them.
std::size_t shown_width(std::wstring_view letters);

}  // namespace reorient
