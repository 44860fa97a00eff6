// SPDX-License-Identifier: MIT
// The files of the page, which are part of the program: page/built/*.
#pragma once

#include <string_view>

#include "workbench/views/live/server/web_server.h"

namespace reorient::live {

/// nullptr: there is no file at this path.
const ServedFile* find_page(std::string_view path);

}  // namespace reorient::live
