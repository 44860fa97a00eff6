// SPDX-License-Identifier: MIT
// Words of behaviors and scenarios that scripted tests do not have.
#pragma once

#include <lua.hpp>

namespace reorient {

/// Reading such a global raises an error that says what a test writes instead. Other missing globals stay nil.
void refuse_words_of_behaviors(lua_State* L);

}  // namespace reorient
