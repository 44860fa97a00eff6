// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "workbench/views/pictures/canvas/canvas.h"

namespace reorient::pictures {

Picture draw_contact_sheet(std::span<const Thumbnail> thumbnails, int columns, int width, const std::string& title) {
  constexpr double kTitle = 34.0, kCaption = 20.0, kGap = 6.0, kTallest = 0.8;  // fraction of the width
  const double cell_width = width + kGap;
  double tallest = 8.0;
  for (const Thumbnail& thumbnail : thumbnails)
    tallest = std::max(tallest, std::min(1.0 * thumbnail.picture.height, kTallest * width));
  const double cell_height = tallest + kCaption + kGap;
  const int rows = std::max(1, (static_cast<int>(thumbnails.size()) + columns - 1) / columns);
  Canvas canvas(static_cast<int>(columns * cell_width + kGap),
                static_cast<int>(std::ceil(kTitle + rows * cell_height)));
  const TextStyle title_style{.size = 18.0, .bold = true};
  canvas.text({kGap, 23.0}, shortened(title, canvas.width() - 2.0 * kGap, title_style), title_style);
  const TextStyle caption_style{.size = 13.0, .color = palette::faint_ink};
  for (std::size_t i = 0; i < thumbnails.size(); ++i) {
    const Picture& picture = thumbnails[i].picture;
    const std::size_t row = i / static_cast<std::size_t>(columns), column = i % static_cast<std::size_t>(columns);
    const double left = kGap + cell_width * static_cast<double>(column);
    const double top = kTitle + cell_height * static_cast<double>(row);
    const double scale = std::min({1.0, 1.0 * width / picture.width, tallest / picture.height});
    canvas.image(picture, {left, top, scale * picture.width, scale * picture.height});
    canvas.text({left, top + tallest + 14.0}, shortened(thumbnails[i].caption, width, caption_style), caption_style);
  }
  return canvas.finish();
}

}  // namespace reorient::pictures
