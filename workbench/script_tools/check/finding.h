// SPDX-License-Identifier: MIT
// Something in a script that is wrong, or worth a look.
#pragma once

#include <string>

#include "engine/script/source/lua_tokens.h"

namespace reorient {

struct Finding {
  enum class Severity { error, warning };

  Severity severity = Severity::error;
  std::string file;  ///< from the scripts' root
  TextPosition position;
  std::string message;

  /// "behaviors/orientation.lua:12:5: error: message"
  std::string text() const;
};

}  // namespace reorient
