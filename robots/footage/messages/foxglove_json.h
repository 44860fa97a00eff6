// SPDX-License-Identifier: MIT
// Decodes messages of Foxglove's schemas in JSON. Each function throws BadFootage with the field at which a message
// violates its schema. Time and frame may be missing.
#pragma once

#include <cstddef>
#include <span>

#include "robots/footage/messages/messages.h"

namespace reorient::messages::foxglove_json {

RawImage raw_image(std::span<const std::byte> message);
CompressedImage compressed_image(std::span<const std::byte> message);
CameraInfo camera_calibration(std::span<const std::byte> message);
Transforms frame_transform(std::span<const std::byte> message);
Transforms frame_transforms(std::span<const std::byte> message);
Pose pose_in_frame(std::span<const std::byte> message);

}  // namespace reorient::messages::foxglove_json
