// SPDX-License-Identifier: MIT
#include "program/shell_word.h"

#include <algorithm>

#include "engine/parameters/utf8.h"

namespace reorient {

std::string shell_word(const std::string& word) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  const auto is_control = [](char letter) { return (letter >= 0 && letter < ' ') || letter == 0x7f; };
  if (std::any_of(word.begin(), word.end(), is_control)) {
    std::string text = "$'";  // as bash, zsh and POSIX 2024 read it
    for (const char letter : word) {
      if (is_control(letter)) {
        text += written_out({&letter, 1});
      } else {
        text += letter == '\'' || letter == '\\' ? std::string{'\\', letter} : std::string(1, letter);
      }
    }
    return text + "'";
  }
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

}  // namespace reorient
