// SPDX-License-Identifier: MIT
// Uncompressed images of logs, converted to ours.
#pragma once

#include "geometry/image.h"
#include "robots/footage/messages/messages.h"

namespace reorient {

/// An image of odd width loses its last column. Throws BadFootage where the encoding is unknown, or the data do not fit
/// width, height, encoding and step.
Image image_of(const messages::RawImage& raw);

}  // namespace reorient
