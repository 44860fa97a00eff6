// SPDX-License-Identifier: MIT
// Converts the types in signatures to symbols of the check.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "workbench/script_tools/check/symbol_table.h"
#include "workbench/script_tools/reference/signature.h"

namespace reorient {

/// Types with their own name: "reorient.Verdict".
using NamedTypes = std::map<std::string, Symbol, std::less<>>;

/// Accepts "number", "string|nil", "table<string, any>", "{ from: string, file: string? }", "fun()" and
/// "reorient.Verdict". An unknown type matches every value.
Symbol symbol_of_type(std::string_view type, const NamedTypes& named);

FunctionSymbol symbol_of_function(const Signature& signature, const NamedTypes& named);

}  // namespace reorient
