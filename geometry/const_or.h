// SPDX-License-Identifier: MIT
// For functions that visit the members of a struct, const or not.
#pragma once

#include <concepts>
#include <type_traits>

namespace reorient {

/// `Given` is T or const T.
template <typename Given, typename T>
concept ConstOr = std::same_as<std::remove_const_t<Given>, T>;

}  // namespace reorient
