// SPDX-License-Identifier: MIT
// The manual page reorient(1), made from the help pages.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace reorient {

/// The page as roff with the macros of man(7), ASCII only.
std::string man_page(const CLI::App& program);

}  // namespace reorient
