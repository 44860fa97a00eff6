// SPDX-License-Identifier: MIT
// Converts uncompressed images of logs.
#pragma once

#include "geometry/image.h"
#include "robots/footage/messages/messages.h"

namespace reorient {

/// An image of odd width loses its last column. Throws BadFootage if the encoding is unknown, or the size of the data
/// does not match width, height, encoding and step.
Image image_of(const messages::RawImage& raw);

}  // namespace reorient
