// The camera's sensor: from light to the bytes that a NAO delivers. Blur, vignetting, exposure, white balance, a tone
// curve, noise, and an automatic exposure that follows the picture slowly.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/image.h"
#include "robots/simulator/render/framebuffer.h"

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
}

class Sensor {
 public:
  Sensor(const SensorParameters& parameters, const RayTable& rays, std::uint64_t seed);

  /// Powers of two of light beyond what the camera's exposure is set for; an automatic exposure does not undo them.
  void set_stops(double stops) { stops_ = stops; }

  /// Reads the frame out, after `time_step` seconds of adaptation to it; `number` picks the noise.
  void expose(const Frame& frame, std::uint64_t number, double time_step, Image& image);

  double exposure() const { return exposure_; }

 private:
  struct Channels {
    std::vector<float> red, green, blue;
    explicit Channels(std::size_t width) : red(width), green(width), blue(width) {}
  };

  void adapt(const Frame& frame, double time_step);
  void blur_row(const Frame& frame, int row, Channels& blurred) const;
  void develop(const Channels& light, const float* vignette, int width);
  void write_row(std::uint64_t number, int row, std::uint8_t* bytes);

  SensorParameters parameters_;
  double exposure_;
  double stops_ = 0.0;
  bool adapted_ = false;
  std::uint64_t seed_;
  std::vector<float> vignette_;
  std::vector<float> noise_;    // standard normal
  std::vector<Channels> ring_;  // three rows, blurred across
  Channels mixed_;
  std::vector<float> luma_, blue_, red_;  // of one row, before noise
};

}  // namespace reorient
