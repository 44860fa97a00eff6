// SPDX-License-Identifier: MIT
// The values and actions of an application's interface, for readers and editors.
#pragma once

#include <string>

#include "robots/application.h"

namespace reorient {

/// A Markdown page.
std::string interface_reference(const ApplicationInterface& declared);

/// Definitions for the Lua language server (---@meta), which add types to the `input` and `action` of
/// script_annotations().
std::string interface_annotations(const ApplicationInterface& declared);

}  // namespace reorient
