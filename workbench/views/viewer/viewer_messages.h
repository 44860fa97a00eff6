// SPDX-License-Identifier: MIT
// A frame as messages that viewers draw and plot.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "engine/record/frame_record.h"
#include "geometry/image.h"
#include "workbench/run/observer.h"
#include "workbench/views/viewer/jpeg.h"
#include "workbench/views/viewer/viewer_topics.h"

namespace reorient {

/// Topics of the record that are not always filled. Messages are made of them if they are.
inline constexpr Topics kViewedTopics{Topic::pose_particles, Topic::room,  Topic::conditions,
                                      Topic::parameters,     Topic::costs, Topic::feature_fits};

/// A frame to be shown. It must be valid only during the call.
struct ViewedFrame {
  const FrameRecord& frame;  ///< topics that are always filled
  const FrameRecord& extra;  ///< the filled topics of kViewedTopics, in the same record or another one
  const SceneTruth& scene;
  std::array<ImageView, 2> images;             ///< of the upper and the lower camera; empty: not shown
  bool begins = false;                         ///< a viewer may start here, so lasting messages are sent again
  ViewerTopics topics = ViewerTopics().set();  ///< messages that are made
};

/// Copies the image, so that it outlives its frame. Uses the memory of `to` again.
void copy_pixels(const ImageView& from, Image& to);

class ViewerMessages {
 public:
  /// Quality of the JPEGs: 1 to 100.
  explicit ViewerMessages(int jpeg_quality = 75) : encoder_(jpeg_quality) {}

  /// The message is valid during the call.
  using Sink = std::function<void(ViewerTopic, std::string_view message)>;
  void add(const ViewedFrame& viewed, const Sink& sink);

 private:
  JpegEncoder encoder_;
};

}  // namespace reorient
