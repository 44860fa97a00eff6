// SPDX-License-Identifier: MIT
// Topics of MCAP files that other programs wrote.
#pragma once

#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/source.h"

namespace reorient::mcap {

/// Adds the schemas and channels that lie in chunks, where the summary is missing or does not repeat them. This reads
/// the whole file once; it ends at the first damaged chunk.
void read_topics_in_chunks(const Source& source, Contents& contents);

}  // namespace reorient::mcap
