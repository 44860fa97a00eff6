// SPDX-License-Identifier: MIT
// Compresses the files of the page for browsers that accept it.
#pragma once

#include <string>
#include <string_view>

namespace reorient::live {

/// Whether the value of the header Accept-Encoding contains gzip with a quality above 0.
bool accepts_gzip(std::string_view header);

/// The text in the gzip format; empty: compression failed.
std::string gzip(std::string_view text);

}  // namespace reorient::live
