// The colour of the carpet, learnt from the images themselves: hue and saturation, since light and shade leave those
// be.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/image.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/ground_projection.h"

namespace reorient {

/// What a pixel may show. Shade: too dark to have a colour, as carpet is in the corners of a vignetted image.
enum class Surface : std::uint8_t { other, carpet, shade };

class CarpetColor {
 public:
  explicit CarpetColor(const FieldFeatureParameters& parameters);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Looks at the ground close to the robot, where most is carpet. The colour is carried over from image to image; an
  /// image with little green leaves it as it is, one with another green (the light was switched) replaces it.
  void observe(const ImageView& image, const GroundProjection& view);

  bool known() const { return known_; }

  Surface surface(int y, int cb, int cr) const {
    const int b = cb - 128;
    const int r = cr - 128;
    const int along = b * hue_b_ + r * hue_r_;
    const int across = b * hue_r_ - r * hue_b_;
    const int off = across < 0 ? -across : across;
    if (along >= least_along_ && along <= most_along_ && off <= spread_ + along / 2 && y <= brightest_) {
      return Surface::carpet;
    }
    return y <= darkest_ && off <= 2 * spread_ && along <= least_along_ && along >= -2 * spread_ ? Surface::shade
                                                                                                 : Surface::other;
  }

  /// Saturation along the carpet's hue: 1 for carpet, 0 for grey.
  double greenness(int cb, int cr) const {
    return static_cast<double>((cb - 128) * hue_b_ + (cr - 128) * hue_r_) / usual_along_;
  }

  double luma() const { return luma_; }

  /// Mean difference of luma between pixels two rows apart on plain carpet: texture and sensor noise.
  double noise() const { return noise_; }

  /// What was learned. Throws BadBytes.
  template <typename Archive>
  void archive(Archive& archive) {
    archive(known_, b_, r_, luma_, noise_);
    if constexpr (Archive::kReads) complete();
  }

 private:
  struct Sample {
    int y, b, r;     ///< chroma without its offset of 128
    int difference;  ///< of luma to two rows below
  };
  void collect(const ImageView& image, const GroundProjection& view);
  bool find_green(double& b, double& r) const;
  void blend(double b, double r);
  void prepare_thresholds();
  void complete();

  FieldFeatureParameters parameters_;
  std::vector<Sample> samples_;
  bool known_ = false;
  double b_ = 0.0, r_ = 0.0;  ///< the carpet's chroma
  double luma_ = 0.0;
  double noise_ = 0.0;
  // The same as thresholds in whole numbers; `along` and `across` the hue are in 1/256 of a step of chroma.
  int hue_b_ = 0, hue_r_ = 0;
  int least_along_ = 0, most_along_ = 0, usual_along_ = 1, spread_ = 0, brightest_ = 0, darkest_ = 0;
};

}  // namespace reorient
