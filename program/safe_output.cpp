// SPDX-License-Identifier: MIT
#include "program/safe_output.h"

#include <algorithm>
#include <string_view>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

/// Number of bytes at the end that begin a letter but do not complete it: at most 3.
std::size_t incomplete_letter(std::string_view text) {
  const auto byte = [&](std::size_t from_end) { return static_cast<unsigned char>(text[text.size() - from_end]); };
  for (std::size_t length = 1; length <= std::min<std::size_t>(3, text.size()); ++length) {
    if ((byte(length) & 0xC0U) == 0x80U) continue;
    const std::size_t whole = byte(length) >= 0xF0 ? 4 : byte(length) >= 0xE0 ? 3 : byte(length) >= 0xC0 ? 2 : 1;
    return length < whole ? length : 0;
  }
  return 0;
}

}  // namespace

SafeOutput::int_type SafeOutput::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char one = traits_type::to_char_type(letter);
  return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize SafeOutput::xsputn(const char* text, std::streamsize size) {
  const std::string_view added(text, static_cast<std::size_t>(size));
  // Most text needs no change; then it is not copied.
  const bool is_plain = begun_.empty() && std::all_of(added.begin(), added.end(), [](char letter) {
                          return (letter >= ' ' && letter < 0x7F) || letter == '\n' || letter == '\t';
                        });
  if (is_plain) return out_.sputn(text, size);
  begun_ += added;
  const std::size_t whole = begun_.size() - incomplete_letter(begun_);
  const std::string safe = as_text(std::string_view(begun_).substr(0, whole));
  begun_.erase(0, whole);
  return put(safe) ? size : 0;
}

int SafeOutput::sync() {
  const bool is_written = put(as_text(begun_));
  begun_.clear();
  return is_written && out_.pubsync() == 0 ? 0 : -1;
}

void SafeOutput::put_control(std::string_view sequence) {
  SafeOutput::sync();
  put(sequence);
  out_.pubsync();
}

bool SafeOutput::put(std::string_view text) {
  const auto size = static_cast<std::streamsize>(text.size());
  return out_.sputn(text.data(), size) == size;
}

void print_error(std::ostream& err, std::string_view text) {
  err << "reorient: " << as_line(text) << '\n' << std::flush;
}

}  // namespace reorient
