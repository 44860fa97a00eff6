// SPDX-License-Identifier: MIT
// The color of the carpet, whatever it is, learned from the images. The chroma is stored for each part of the image,
// since a lens makes the corners darker and changes their tint.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/image.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/ground_projection.h"

namespace reorient {

/// What a pixel may show. Unsure: too dark to have a color, as carpet in the corners of a vignetted image, or carpet in
/// only one of the two models of the light.
enum class Surface : std::uint8_t { other, carpet, unsure };

/// A cone of chroma around the axis that starts at the chroma of colorless surfaces, in 1/256 of a step.
struct ChromaCone {
  int apex_b = 0, apex_r = 0;    ///< on the axis, where luma is 0
  int light_b = 0, light_r = 0;  ///< change of the apex with luma
  int hue_b = 0, hue_r = 0;      ///< direction of the axis; a vector of length 256
  int least_along = 0, most_along = 0, spread = 0;

  struct Place {
    int along = 0, off = 0;  ///< along the axis and across it
  };
  Place place_of(int y, int cb, int cr) const {
    const int b = 256 * (cb - 128) - apex_b - light_b * y;
    const int r = 256 * (cr - 128) - apex_r - light_r * y;
    const int across = (b * hue_r - r * hue_b) >> 8;
    return {(b * hue_b + r * hue_r) >> 8, across < 0 ? -across : across};
  }
  bool contains(const Place& place) const {
    return (place.along >= least_along) & (place.along <= most_along) & (place.off <= spread + (place.along >> 1));
  }
  bool may_be_dark(const Place& place) const {
    return (place.off <= 2 * spread) & (place.along <= least_along) & (place.along >= -2 * spread);
  }
};

/// The carpet in one part of the image, for two models of a tint of colorless surfaces. Either the camera's processing
/// adds the tint to each pixel, or the light causes it and it grows with luma. Written without branches so that a
/// compiler can vectorize it.
class CarpetPart {
 public:
  Surface surface(int y, int cb, int cr) const {
    const ChromaCone::Place in_added = added.place_of(y, cb, cr);
    const bool once = (y <= brightest) & added.contains(in_added);
    const bool again = (y <= brightest) & of_light.contains(of_light.place_of(y, cb, cr));
    const bool dark = (y <= darkest) & added.may_be_dark(in_added);
    const int any = once | again | dark, both = once & again;
    return static_cast<Surface>(2 * any - both);
  }

 private:
  friend class CarpetColor;
  ChromaCone added, of_light;
  int brightest = 0, darkest = 0;
};

class CarpetColor {
 public:
  explicit CarpetColor(const FieldFeatureParameters& parameters);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Observes the ground close to the robot, where most pixels show carpet. The color persists from image to image. An
  /// image with little of it does not change it. Several images with another color, for example after the light was
  /// switched, replace it.
  void observe(const ImageView& image, const GroundProjection& view);

  bool known() const { return known_; }

  // Parts of the last observed image.
  int column_of(int x) const { return quotient(x, columns_per_pixel_); }
  int row_of(int y) const { return quotient(y, rows_per_pixel_); }
  const CarpetPart& part(int column, int row) const {
    return parts_[static_cast<std::size_t>(row * kColumns + column)];
  }
  const CarpetPart& at(int x, int y) const { return part(column_of(x), row_of(y)); }
  Surface surface(int x, int y, const Ycbcr& pixel) const { return at(x, y).surface(pixel.y, pixel.cb, pixel.cr); }

  /// Difference of chroma from that of colorless surfaces, in the better model of the tint, as a fraction of luma.
  double tint_at(const Eigen::Vector2i& pixel, const Ycbcr& seen) const;

  double luma() const { return learned_.luma; }

  /// Mean difference of luma between pixels two rows apart on plain carpet, from texture and sensor noise.
  double noise() const { return learned_.noise; }

  /// Sets how much the stripes of this image differ from the carpet beside them: (luma, blue, red). The initial
  /// assumption is a strong contrast between white and the carpet. The parts use the new value from the next image on.
  void observe_white(const Eigen::Vector3d& less_carpet);
  /// The mean difference in (blue, red) over the images so far. Before the first one: the difference between a
  /// colorless white and the carpet at this position.
  Eigen::Vector2d white_less_carpet(const Eigen::Vector2d& carpet) const {
    return white_known_ ? Eigen::Vector2d(white_less_carpet_.tail<2>()) : Eigen::Vector2d(-carpet);
  }

  /// The mean difference in luma. 0 before the first image.
  double white_contrast() const { return white_known_ ? white_less_carpet_.x() : 0.0; }

  /// Standard deviation of one channel between samples of the carpet and its smooth color.
  double deviation() const { return learned_.deviation; }

  /// The learned values. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.known_, self.learned_.blue, self.learned_.red, self.learned_.luma, self.learned_.noise,
            self.learned_.deviation, self.other_color_images_, self.white_known_, self.white_less_carpet_);
    if constexpr (Archive::kReads) self.check();
  }

 private:
  static constexpr int kColumns = 16, kRows = 12;  // parts

  struct Sample {
    int y, b, r;     ///< chroma without its offset of 128
    int difference;  ///< difference of luma to two rows below
    double u, v;     ///< position in the image, each from -1 to 1
  };
  struct Dominant {
    double b = 0.0, r = 0.0;
    int count = 0;  ///< samples
  };
  /// Factors of 1, u, v, u^2, u v, v^2: a position in the image, or a smooth surface over it.
  using Terms = Eigen::Matrix<double, 6, 1>;
  struct Learned {
    Terms blue = Terms::Zero(), red = Terms::Zero();  ///< chroma without its offset of 128, over the image
    double luma = 0.0;                                ///< mean
    double noise = 0.0;                               ///< of luma
    double deviation = 0.0;                           ///< of chroma

    Eigen::Vector2d chroma_at(const Terms& place) const { return {blue.dot(place), red.dot(place)}; }
  };
  struct Fit {
    int near = 0;                                      ///< samples near the color
    Terms place = Terms::Zero();                       ///< mean position of these samples
    Eigen::Vector2d chroma = Eigen::Vector2d::Zero();  ///< mean chroma of these samples, (blue, red)
  };

  // pixel * parts / pixels without a division, which is slow compared with the rest of a look at one pixel. Exact for
  // up to 65536 pixels.
  static std::uint64_t per_pixel(int parts, int pixels) {
    return ((static_cast<std::uint64_t>(parts) << 32) + static_cast<std::uint64_t>(pixels) - 1) /
           static_cast<std::uint64_t>(pixels);
  }
  static int quotient(int pixel, std::uint64_t parts_per_pixel) {
    return static_cast<int>(static_cast<std::uint64_t>(pixel) * parts_per_pixel >> 32);
  }

  void collect(const ImageView& image, const GroundProjection& view);
  static Terms terms_at(double u, double v);
  void learn();
  std::optional<Dominant> find_dominant() const;
  Fit fit(Learned& color) const;
  bool is_same_carpet_as(Learned& seen) const;
  void mix(const Learned& seen, double kept);
  void prepare_parts();
  ChromaCone cone_for(const Eigen::Vector2d& carpet, const Eigen::Vector2d& no_color,
                      const Eigen::Vector2d& light) const;
  Eigen::Vector2d light_of(const Eigen::Vector2d& white) const;
  CarpetPart part_for(const Eigen::Vector2d& carpet) const;
  void check() const;

  FieldFeatureParameters parameters_;
  std::vector<Sample> samples_;
  int width_ = 1, height_ = 1;                                ///< of the last observed image
  std::uint64_t columns_per_pixel_ = 0, rows_per_pixel_ = 0;  ///< parts, in 1/2^32
  bool known_ = false;
  Learned learned_;
  int other_color_images_ = 0;  ///< consecutive images with another color
  bool white_known_ = false;
  Eigen::Vector3d white_less_carpet_ = Eigen::Vector3d::Zero();  ///< (luma, blue, red)
  std::array<CarpetPart, static_cast<std::size_t>(kColumns) * kRows> parts_{};
};

}  // namespace reorient
