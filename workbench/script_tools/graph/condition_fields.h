// SPDX-License-Identifier: MIT
// The world fields and the values of an application that the condition of a transition reads, by the text of its
// script.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/script/script_texts.h"
#include "engine/script/source/lua_tokens.h"

namespace reorient {

class ConditionFields {
 public:
  /// `texts` must outlive it.
  explicit ConditionFields(const ScriptTexts& texts) : texts_(texts) {}

  /// The full names, as "confidence.evidence", in the order of the text. `begin`: where the transition begins, in the
  /// file; with column 0, the first one of the line. Includes those of functions that the condition names: local ones
  /// of the file, and those of the libraries that the file requires. Never fails: unusual text gives fewer names.
  std::vector<std::string> read_at(const std::string& file, TextPosition begin);

 private:
  struct File {
    std::vector<LuaToken> tokens;
    std::map<std::string, std::string> modules;  ///< file of each `local NAME = require "..."`
  };
  class Reader;

  const File& read_file(const std::string& name);

  const ScriptTexts& texts_;
  std::map<std::string, File> files_;
};

}  // namespace reorient
