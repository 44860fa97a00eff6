// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/compression.h"

#include <algorithm>
#include <cctype>

#include <zlib.h>

namespace reorient::live {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

bool is_gzip(std::string_view name) {
  constexpr std::string_view kName = "gzip";
  return std::equal(name.begin(), name.end(), kName.begin(), kName.end(),
                    [](unsigned char some, char other) { return std::tolower(some) == other; });
}

/// "q=0", "q=0.000"
bool is_refusal(std::string_view parameter) {
  return (parameter.starts_with("q=0") || parameter.starts_with("Q=0")) &&
         parameter.substr(2).find_first_not_of("0.") == std::string_view::npos;
}

}  // namespace

bool accepts_gzip(std::string_view header) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(','), header.size());
    const std::string_view coding = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    const std::size_t name_end = std::min(coding.find(';'), coding.size());
    if (is_gzip(trimmed(coding.substr(0, name_end))))
      return !is_refusal(trimmed(coding.substr(std::min(name_end + 1, coding.size()))));
  }
  return false;
}

std::string gzip(std::string_view text) {
  constexpr int kWindowOfGzip = 15 + 16, kMemoryLevel = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindowOfGzip, kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
    return {};
  std::string bytes(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const bool is_complete = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  bytes.resize(is_complete ? stream.total_out : 0);
  deflateEnd(&stream);
  return bytes;
}

}  // namespace reorient::live
