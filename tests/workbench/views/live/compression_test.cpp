// SPDX-License-Identifier: MIT
// The compression of the page: what a browser accepts, and that a browser can read it.
#include "workbench/views/live/server/compression.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <zlib.h>

namespace reorient::live {
namespace {

TEST(AcceptsGzip, IfTheHeaderListsItWithAQualityAboveZero) {
  for (const char* header :
       {"gzip", " gzip ", "GZip", "br,gzip", "br;q=1, gzip;q=0.001", "gzip;q=1", "gzip;", "gzip;x"})
    EXPECT_TRUE(accepts_gzip(header)) << header;
  for (const char* header : {"", ",", ";", " ", "br", "x-gzip", "gzip2", "gz ip", "*", "gzip;q=0", "gzip; Q=0.000",
                             "br;q=gzip", "identity;gzip"})
    EXPECT_FALSE(accepts_gzip(header)) << header;
}

RC_GTEST_PROP(AcceptsGzip, ReadsAnyHeader, (const std::string& header)) { accepts_gzip(header); }

std::string decompressed(const std::string& bytes, std::size_t size) {
  std::string text(size, '\0');
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  return result == Z_STREAM_END ? text : "it is damaged";
}

RC_GTEST_PROP(Gzip, KeepsTheText, (const std::string& text)) {
  RC_ASSERT(decompressed(gzip(text), std::max<std::size_t>(text.size(), 1)).substr(0, text.size()) == text);
}

TEST(Gzip, MakesARepetitiveTextShort) { EXPECT_LT(gzip(std::string(100'000, 'x')).size(), 500u); }

}  // namespace
}  // namespace reorient::live
