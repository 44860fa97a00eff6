// SPDX-License-Identifier: MIT
// The library that decodes images and videos (workbench/footage/opencv/). It is loaded when something is
// decoded first: REORIENT_DECODER names it, else it lies beside the program or where it is installed.
#pragma once

#include "workbench/footage/decoder.h"

namespace reorient {

/// What it returns throws BadFootage with one line with the packages to install if the library is missing.
FootageDecoder decoder_library();

}  // namespace reorient
