// SPDX-License-Identifier: MIT
// From the types in signatures to what the check knows of values.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "workbench/script_tools/check/symbol_table.h"
#include "workbench/script_tools/reference/signature.h"

namespace reorient {

/// Types that have a name of their own: "reorient.Verdict".
using NamedTypes = std::map<std::string, Symbol, std::less<>>;

/// "number", "string|nil", "table<string, any>", "{ from: string, file: string? }", "fun()", "reorient.Verdict"; of an
/// unknown type anything.
Symbol symbol_of_type(std::string_view type, const NamedTypes& named);

FunctionSymbol symbol_of_function(const Signature& signature, const NamedTypes& named);

}  // namespace reorient
