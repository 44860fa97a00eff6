// SPDX-License-Identifier: MIT
// The library that decodes images and videos (workbench/footage/opencv/). It is loaded when something is
// decoded first: REORIENT_DECODER names it; else it is beside the program or in the installation.
#pragma once

#include "workbench/footage/decoder.h"

namespace reorient {

/// If the library is missing, the returned decoder throws BadFootage with one line that names the packages to install.
FootageDecoder decoder_library();

}  // namespace reorient
