// SPDX-License-Identifier: MIT
// Topics of MCAP files of other programs.
#pragma once

#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/source.h"

namespace reorient::mcap {

/// Adds the schemas and channels in chunks, for files whose summary is missing or does not repeat them. Reads the whole
/// file once and leaves out damaged chunks.
void read_topics_in_chunks(const Source& source, Contents& contents);

}  // namespace reorient::mcap
