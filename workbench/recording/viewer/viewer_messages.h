// SPDX-License-Identifier: MIT
// A frame in messages that viewers draw and plot.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "engine/record/frame_record.h"
#include "geometry/image.h"
#include "workbench/recording/viewer/jpeg.h"
#include "workbench/recording/viewer/viewer_topics.h"
#include "workbench/run/observer.h"

namespace reorient {

/// The record's topics beyond those that are always filled, of which messages can be made where they are there.
inline constexpr Topics kViewedTopics{Topic::pose_particles, Topic::room, Topic::parameters, Topic::costs};

/// A frame as it is shown. What stays valid during the call is enough.
struct ViewedFrame {
  const FrameRecord& frame;  ///< all that is always filled
  const FrameRecord& extra;  ///< those of kViewedTopics that are filled: the same record, or another
  const SceneTruth& scene;
  std::array<ImageView, 2> images;  ///< of the upper and the lower camera; empty: none is shown
  bool begins = false;              ///< a viewer may begin here: messages that last are sent again
};

class ViewerMessages {
 public:
  /// Of the JPEGs: 1 to 100.
  explicit ViewerMessages(int jpeg_quality = 75) : encoder_(jpeg_quality) {}

  /// The message is valid during the call.
  using Sink = std::function<void(ViewerTopic, std::string_view message)>;
  void add(const ViewedFrame& viewed, const Sink& sink);

 private:
  JpegEncoder encoder_;
};

}  // namespace reorient
