// SPDX-License-Identifier: MIT
// The camera's sensor: from light to the bytes that a NAO delivers. Blur, vignetting, exposure, white balance, a tone
// curve, noise, and an automatic exposure that follows the picture slowly.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/image.h"
#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/render/optics.h"

namespace reorient {

struct SensorParameters {
  bool automatic_exposure = true;
  double exposure = 1.0;
  double brightness = 0.17;
  double adaptation_time = 2.0;
  double warmth = 0.08;
  double tint = 0.0;
  double vignetting = 0.55;
  double blur = 0.12;
  double luma_noise = 2.2;
  double chroma_noise = 1.4;
  double black_level = 0.012;
  double saturation = 0.85;
  double noise_gain = 0.0;
  double blur_angle = 0.0;
  double exposure_time = 0.0;
  double readout_time = 0.0;
};

template <typename Visit>
void describe(SensorParameters& p, Visit&& visit) {
  visit("automatic_exposure", p.automatic_exposure, "whether the camera follows the picture's brightness");
  visit("exposure", p.exposure, 0.05, 20.0, "",
        "factor on the light at the start; stays where the exposure is not automatic");
  visit("brightness", p.brightness, 0.02, 0.8, "", "mean linear brightness that the automatic exposure aims at");
  visit("adaptation_time", p.adaptation_time, 0.1, 60.0, "s", "time constant of the automatic exposure");
  visit("warmth", p.warmth, -0.5, 0.5, "", "white balance: red up and blue down by this natural logarithm");
  visit("tint", p.tint, -0.5, 0.5, "", "white balance: green up by this natural logarithm");
  visit("vignetting", p.vignetting, 0.0, 1.0, "", "share of light that is lost in the image's corners");
  visit("blur", p.blur, 0.0, 0.25, "", "share that each pixel gives to each neighbour, across and down");
  visit("luma_noise", p.luma_noise, 0.0, 30.0, "", "standard deviation of Y, of 255");
  visit("chroma_noise", p.chroma_noise, 0.0, 30.0, "", "standard deviation of Cb and Cr, of 255");
  visit("black_level", p.black_level, 0.0, 0.2, "", "stray light that is added everywhere");
  visit("saturation", p.saturation, 0.0, 1.5, "", "factor on Cb and Cr");
  visit("noise_gain", p.noise_gain, 0.0, 1.0, "",
        "how the noise grows where the automatic exposure amplifies: with this power of the gain");
  visit("blur_angle", p.blur_angle, 0.0, 0.02, "rad", "standard deviation of the lens's blur, at every image size");
  visit("exposure_time", p.exposure_time, 0.0, 0.1, "s", "for how long light is gathered: what moves is blurred");
  visit("readout_time", p.readout_time, 0.0, 0.1, "s",
        "from the first to the last row: what moves is skewed (rolling shutter)");
}

class Sensor {
 public:
  Sensor(const SensorParameters& parameters, const RayTable& rays, std::uint64_t seed);

  /// Powers of two of light beyond what the camera's exposure is set for; an automatic exposure does not undo them.
  void set_stops(double stops) { stops_ = stops; }

  /// Factors on red, green and blue, which the automatic exposure does not undo either.
  void set_gains(const Eigen::Array3d& gains) { gains_ = gains; }

  /// Reads the scene out, after `time_step` seconds of adaptation to it; `number` picks the noise. The camera turns at
  /// `angular_velocity` (rad/s, in its own frame).
  void expose(const Frame& scene, std::uint64_t number, double time_step, Image& image,
              const Eigen::Vector3d& angular_velocity = Eigen::Vector3d::Zero());

  double exposure() const { return exposure_; }

 private:
  struct Channels {
    std::vector<float> red, green, blue;
    explicit Channels(std::size_t width) : red(width), green(width), blue(width) {}
  };

  /// What holds for a whole frame.
  struct Amplifier {
    float red, green, blue;          // factors on the light
    float luma_sigma, chroma_sigma;  // of the noise, of 255
  };

  void adapt(const Frame& frame, double time_step);
  Amplifier amplifier() const;
  void blur_row(const Frame& frame, int row, Channels& blurred) const;
  void develop(const Channels& light, const Amplifier& amplifier, const float* vignette, int width);
  void write_row(std::uint64_t number, int row, const Amplifier& amplifier, std::uint8_t* bytes);

  SensorParameters parameters_;
  double exposure_;
  double stops_ = 0.0;
  Eigen::Array3d gains_ = Eigen::Array3d::Ones();
  bool adapted_ = false;
  std::uint64_t seed_;
  std::vector<float> vignette_;
  std::vector<float> noise_;    // standard normal
  std::vector<Channels> ring_;  // three rows, blurred across
  Channels mixed_;
  Optics optics_;
  std::vector<float> luma_, blue_, red_;  // of one row, before noise
  std::vector<int> levels_;               // of its pixels' Y
  std::vector<std::uint32_t> pairs_;      // of its pixels, as they are delivered
};

}  // namespace reorient
