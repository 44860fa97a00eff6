// SPDX-License-Identifier: MIT
// The [[reference]] tables of an experiment file.
#pragma once

#include <string>
#include <vector>

#include "workbench/experiments/condition/reference.h"
#include "workbench/files/table_reader.h"

namespace reorient {

/// Throws std::runtime_error with one line: file, line, reason.
std::vector<Reference> read_references(const TableReader& in, const toml::array& tables, const std::string& file);

}  // namespace reorient
