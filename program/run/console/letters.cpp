#include "program/run/console/letters.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cwchar>

namespace reorient {
namespace {

locale_t utf8() {
  static const locale_t locale = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  return locale;  // where there is none, everything stays as it is
}

}  // namespace

Utf8Letters::Utf8Letters() : before_(uselocale(utf8())) {}

std::wstring wide(std::string_view text) {
  std::wstring letters;
  std::mbstate_t state{};
  while (!text.empty()) {
    wchar_t letter = 0;
    const std::size_t count = std::mbrtowc(&letter, text.data(), text.size(), &state);
    if (count > text.size()) return letters;
    letters += letter;
    text.remove_prefix(std::max<std::size_t>(1, count));
  }
  return letters;
}

std::string narrow(std::wstring_view letters) {
  std::string text;
  std::mbstate_t state{};
  for (const wchar_t letter : letters) {
    std::array<char, MB_LEN_MAX> bytes;
    const std::size_t count = std::wcrtomb(bytes.data(), letter, &state);
    if (count <= bytes.size()) text.append(bytes.data(), count);
  }
  return text;
}

std::size_t shown_width(std::wstring_view letters) {
  std::size_t width = 0;
  for (const wchar_t letter : letters) {
    const int columns = ::wcwidth(letter);
    width += columns < 0 ? 2 : static_cast<std::size_t>(columns);  // ^A
  }
  return width;
}

}  // namespace reorient
