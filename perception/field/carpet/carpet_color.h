// The color of the carpet, learned from the images themselves, whatever it is: its chroma in each part of the image,
// since a lens makes the corners darker and of another tint.
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

/// What a pixel may show. Shade: too dark to have a color, as carpet is in the corners of a vignetted image.
enum class Surface : std::uint8_t { other, carpet, shade };

/// The carpet in one part of the image. `along` and `across` its hue are in 1/256 of a step of chroma.
class CarpetPart {
 public:
  Surface surface(int y, int cb, int cr) const {
    const int b = cb - 128 - apex_b;
    const int r = cr - 128 - apex_r;
    const int along = b * hue_b + r * hue_r;
    const int across = b * hue_r - r * hue_b;
    const int off = across < 0 ? -across : across;
    if (along >= least_along && along <= most_along && off <= spread + along / 2 && y <= brightest)
      return Surface::carpet;
    return y <= darkest && off <= 2 * spread && along <= least_along && along >= -2 * spread ? Surface::shade
                                                                                             : Surface::other;
  }

 private:
  friend class CarpetColor;
  int apex_b = 0, apex_r = 0;  // white, or beyond it
  int hue_b = 0, hue_r = 0;
  int least_along = 0, most_along = 0, spread = 0, brightest = 0, darkest = 0;
};

class CarpetColor {
 public:
  explicit CarpetColor(const FieldFeatureParameters& parameters);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Looks at the ground close to the robot, where most is carpet. The color is carried over from image to image; an
  /// image with little of it leaves it as it is, several with another one (the light was switched) replace it.
  void observe(const ImageView& image, const GroundProjection& view);

  bool known() const { return known_; }

  // Parts of the image that was observed last.
  int column_of(int x) const { return x * kColumns / width_; }
  std::span<const CarpetPart> row_at(int y) const {
    return std::span(parts_).subspan(static_cast<std::size_t>(y * kRows / height_ * kColumns), kColumns);
  }
  const CarpetPart& at(int x, int y) const { return row_at(y)[static_cast<std::size_t>(column_of(x))]; }
  Surface surface(int x, int y, const Ycbcr& pixel) const { return at(x, y).surface(pixel.y, pixel.cb, pixel.cr); }

  double luma() const { return learned_.luma; }

  /// Mean difference of luma between pixels two rows apart on plain carpet: texture and sensor noise.
  double noise() const { return learned_.noise; }

  /// By how much the chroma of this image's stripes differs from that of the carpet beside them: (blue, red). White
  /// against the carpet is taken to be as different, until other images say otherwise; the parts from the next image
  /// on.
  void observe_white(const Eigen::Vector2d& difference);
  /// The same, of the images so far. Before any: as if white had no color, and the carpet that of this place.
  Eigen::Vector2d white_less_carpet(const Eigen::Vector2d& carpet) const {
    return white_known_ ? white_less_carpet_ : Eigen::Vector2d(-carpet);
  }

  /// Standard deviation of the carpet's chroma.
  double deviation() const { return learned_.deviation; }

  /// What was learned. Throws BadBytes.
  template <typename Archive>
  void archive(Archive& archive) {
    archive(known_, learned_.blue, learned_.red, learned_.luma, learned_.noise, learned_.deviation, doubted_,
            white_known_, white_less_carpet_);
    if constexpr (Archive::kReads) check();
  }

 private:
  static constexpr int kColumns = 16, kRows = 12;  // parts

  struct Sample {
    int y, b, r;     ///< chroma without its offset of 128
    int difference;  ///< of luma to two rows below
    double u, v;     ///< place in the image, each from -1 to 1
  };
  struct Dominant {
    double b = 0.0, r = 0.0;
    int count = 0;  ///< samples
  };
  /// Of 1, u, v, u^2, u v, v^2: a place in the image, or the factors of a smooth surface over it.
  using Terms = Eigen::Matrix<double, 6, 1>;
  struct Learned {
    Terms blue = Terms::Zero(), red = Terms::Zero();  ///< chroma without its offset of 128, over the image
    double luma = 0.0;                                ///< mean
    double noise = 0.0;                               ///< of luma
    double deviation = 0.0;                           ///< of chroma
  };

  void collect(const ImageView& image, const GroundProjection& view);
  static Terms terms_at(double u, double v);
  void learn();
  std::optional<Dominant> find_dominant() const;
  int fit(Learned& color) const;
  void mix(const Learned& seen, double kept);
  void prepare_parts();
  CarpetPart part_for(const Eigen::Vector2d& carpet) const;
  void check() const;

  FieldFeatureParameters parameters_;
  std::vector<Sample> samples_;
  int width_ = 1, height_ = 1;  ///< of the image observed last
  bool known_ = false;
  Learned learned_;
  int doubted_ = 0;  ///< images with another color since it was seen last
  bool white_known_ = false;
  Eigen::Vector2d white_less_carpet_ = Eigen::Vector2d::Zero();
  std::array<CarpetPart, static_cast<std::size_t>(kColumns) * kRows> parts_{};
};

}  // namespace reorient
