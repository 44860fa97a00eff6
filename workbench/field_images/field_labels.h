// SPDX-License-Identifier: MIT
// Labels of images of a field: lines, posts, balls, and areas without line points.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/transform.h"

namespace reorient {

/// Pixels of the image: u to the right, v down, (0, 0) the center of the top left pixel.
using LabeledPixels = std::vector<Eigen::Vector2d>;

struct LabeledPost {
  Eigen::Vector2d base = Eigen::Vector2d::Zero();  ///< its foot on the carpet, pixel
  Eigen::Vector2d top = Eigen::Vector2d::Zero();   ///< pixel
};

struct LabeledBall {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< pixel
  double radius = 0.0;                               ///< pixels
};

/// Format of a file with YUYV after a header.
struct RawFormat {
  int width = 0, height = 0;  ///< pixels
  std::size_t header = 0;     ///< bytes
};

/// The labels of one image.
struct FieldLabels {
  std::string name;          ///< of the image, for the user
  std::string digest;        ///< of the file's bytes: digest_of()
  int width = 0;             ///< pixels of the image that the labels were made in; others are scaled to it
  double field_of_view = 0;  ///< rad, horizontal, of a camera without distortion
  double pitch = 0.0;        ///< rad, downwards
  double roll = 0.0;         ///< rad, left side up
  std::optional<RawFormat> raw;
  std::vector<LabeledPixels> lines;  ///< each along the middle of a line or of an arc, two points or more
  std::vector<LabeledPost> posts;
  std::vector<LabeledBall> balls;
  std::vector<LabeledPixels> feet;     ///< polygons: robots and people
  std::vector<LabeledPixels> boards;   ///< polygons: everything around the carpet
  std::vector<LabeledPixels> marks;    ///< polygons: penalty marks, and other white that is not a line
  std::vector<LabeledPixels> ignored;  ///< polygons in which a line point is neither right nor wrong
};

/// Digest of a file's bytes, 16 hexadecimal digits. Labels identify their image by it, independent of its name.
std::string digest_of(std::string_view bytes);

/// Throws std::runtime_error with one line: file, line, what was expected, what was found.
std::vector<FieldLabels> parse_field_labels(std::string_view text, const std::string& name);
/// The same.
std::vector<FieldLabels> load_field_labels(const std::filesystem::path& file);

/// The labels of the image with that digest; null: no labels.
const FieldLabels* labels_of(std::span<const FieldLabels> all, const std::string& digest);

}  // namespace reorient
