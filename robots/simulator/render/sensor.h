// SPDX-License-Identifier: MIT
// The camera's sensor, which converts light to the bytes that a NAO delivers: blur, vignetting, exposure, white
// balance, tone curve, noise, and an automatic exposure that adapts slowly.
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
  visit("automatic_exposure", p.automatic_exposure, "whether the exposure adapts to the brightness of the image");
  visit("exposure", p.exposure, 0.05, 20.0, "",
        "factor on the light at the start; constant if the exposure is not automatic");
  visit("brightness", p.brightness, 0.02, 0.8, "", "target of the automatic exposure: mean linear brightness");
  visit("adaptation_time", p.adaptation_time, 0.1, 60.0, "s", "time constant of the automatic exposure");
  visit("warmth", p.warmth, -0.5, 0.5, "",
        "warmth of the white balance: natural logarithm of the factor on red and of the divisor of blue");
  visit("tint", p.tint, -0.5, 0.5, "", "tint of the white balance: natural logarithm of the factor on green");
  visit("vignetting", p.vignetting, 0.0, 1.0, "", "fraction of the light that is lost in the corners of the image");
  visit("blur", p.blur, 0.0, 0.25, "",
        "fraction of its light that each pixel gives to each horizontal and vertical neighbor");
  visit("luma_noise", p.luma_noise, 0.0, 30.0, "", "standard deviation of the noise of Y (0 to 255)");
  visit("chroma_noise", p.chroma_noise, 0.0, 30.0, "", "standard deviation of the noise of Cb and Cr (0 to 255)");
  visit("black_level", p.black_level, 0.0, 0.2, "", "stray light that is added to all pixels");
  visit("saturation", p.saturation, 0.0, 1.5, "", "factor on the saturation of the image (Cb and Cr)");
  visit("noise_gain", p.noise_gain, 0.0, 1.0, "",
        "exponent with which the noise grows with the gain of the automatic exposure; 0: constant noise");
  visit("blur_angle", p.blur_angle, 0.0, 0.02, "rad",
        "standard deviation of the blur of the lens, the same at every image size");
  visit("exposure_time", p.exposure_time, 0.0, 0.1, "s", "exposure time of an image, which causes motion blur");
  visit("readout_time", p.readout_time, 0.0, 0.1, "s",
        "time from the first to the last row of an image (rolling shutter), which causes skew");
}

class Sensor {
 public:
  Sensor(const SensorParameters& parameters, const RayTable& rays, std::uint64_t seed);

  /// Sets a change of the light in powers of two, which the automatic exposure does not compensate.
  void set_stops(double stops) { stops_ = stops; }

  /// Sets factors on red, green and blue, which the automatic exposure does not compensate either.
  void set_gains(const Eigen::Array3d& gains) { gains_ = gains; }

  /// Takes an image of the scene, after `time_step` seconds of adaptation; `number` selects the noise. The camera turns
  /// at `angular_velocity` (rad/s, in its own frame).
  void expose(const Frame& scene, std::uint64_t number, double time_step, Image& image,
              const Eigen::Vector3d& angular_velocity = Eigen::Vector3d::Zero());

  double exposure() const { return exposure_; }

 private:
  struct Channels {
    std::vector<float> red, green, blue;
    explicit Channels(std::size_t width) : red(width), green(width), blue(width) {}
  };

  /// Values for a whole frame.
  struct Amplifier {
    float red, green, blue;          // factors on the light
    float luma_sigma, chroma_sigma;  // standard deviation of the noise of values from 0 to 255
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
  std::vector<Channels> ring_;  // three rows, blurred horizontally
  Channels mixed_;
  Optics optics_;
  std::vector<float> luma_, blue_, red_;  // of one row, before noise
  std::vector<int> levels_;               // Y of that row's pixels
  std::vector<std::uint32_t> pairs_;      // pairs of that row's pixels in the delivered format
};

}  // namespace reorient
