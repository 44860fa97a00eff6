// SPDX-License-Identifier: MIT
#include "engine/record/frame_record.h"

#include <algorithm>

namespace reorient {
namespace {

/// Copies the pixels to own memory, without gaps between the rows.
void own(ImageView& view, std::vector<std::uint8_t>& bytes) {
  if (view.empty() || view.data == bytes.data()) return;
  const std::size_t row = 2 * static_cast<std::size_t>(view.width);
  bytes.resize(row * static_cast<std::size_t>(view.height));
  for (int y = 0; y < view.height; ++y) std::copy_n(view.row(y), row, bytes.data() + static_cast<std::size_t>(y) * row);
  view.data = bytes.data();
  view.stride = static_cast<int>(row);
}

}  // namespace

std::string_view to_string(Stage stage) {
  switch (stage) {
    case Stage::inputs:
      return "inputs";
    case Stage::field:
      return "field features";
    case Stage::localization:
      return "pose filter";
    case Stage::room:
      return "room awareness";
    case Stage::behaviors:
      return "behaviors";
    case Stage::record:
      return "record";
  }
  return "";
}

void ApplicationRecord::take(const ApplicationState& state) {
  declared = state.shared_declared();
  values.assign(state.values().begin(), state.values().end());
  actions.assign(state.actions().begin(), state.actions().end());
  requests.assign(state.records().begin(), state.records().end());
}

void ApplicationRecord::check() const {
  check_bytes(mistake_in(*declared).empty(), "application: mistake in its interface");
  check_fits(values, actions, *declared);
  for (const ActionRecord& record : requests) {
    check_bytes(record.request.action < declared->actions.size() &&
                    mistake_in(record.request.arguments, declared->actions[record.request.action].arguments).empty(),
                "application: a request does not fit its declaration");
  }
}

void FrameRecord::own_images() {
  own(images.upper, images.own[0]);
  own(images.lower, images.own[1]);
}

}  // namespace reorient
