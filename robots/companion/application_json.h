// SPDX-License-Identifier: MIT
// Values and actions of an application as JSON, as clients send and receive them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/application.h"

namespace reorient {

/// Reads an object such as {"ball": {"x": 1.0, "seen": true}, "teammates": [{"player": 2}]}: a point is {"x", "y"}, a
/// pose {"x", "y", "rotation"}, a list an array of objects, whose missing fields have their defaults. A value of a
/// wrong type becomes one that does not fit its declaration. Throws BadMessage for a text that is no such object, and
/// for unknown names.
std::vector<SetValue> read_values(std::string_view text, const ApplicationInterface& declared);

/// {"foot": "left", "direction": 0.25}; bytes that are not UTF-8 are replaced.
std::string arguments_json(const StartedAction& started, const DeclaredAction& declared);

}  // namespace reorient
