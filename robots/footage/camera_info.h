// SPDX-License-Identifier: MIT
// Converts the calibration in a log to the camera model.
#pragma once

#include "geometry/camera.h"
#include "robots/footage/messages/messages.h"

namespace reorient {

/// The camera at the resolution of its image. `rectified`: the image is already undistorted, so that P is valid instead
/// of K and D. Throws BadFootage if the camera is not calibrated, its distortion model is unknown, or the aspect ratios
/// of calibration and image differ.
CameraModel camera_of(const messages::CameraInfo& info, int width, int height, bool rectified);

/// `camera` at another resolution of the same aspect ratio, or without its last column if its width is odd. Throws
/// BadFootage for another aspect ratio.
CameraModel camera_at(const CameraModel& camera, int width, int height);

}  // namespace reorient
