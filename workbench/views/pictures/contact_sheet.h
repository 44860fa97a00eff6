// SPDX-License-Identifier: MIT
// Many small pictures in one picture, with a line of text below each.
#pragma once

#include <span>
#include <string>

#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

struct Thumbnail {
  Picture picture;
  std::string caption;
};

/// Rows of `columns` thumbnails from left to right, each `width` pixels wide; taller ones are scaled down.
Picture draw_contact_sheet(std::span<const Thumbnail> thumbnails, int columns, int width, const std::string& title);

}  // namespace reorient::pictures
