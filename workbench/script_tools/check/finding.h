// SPDX-License-Identifier: MIT
// An error or warning about a script.
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
