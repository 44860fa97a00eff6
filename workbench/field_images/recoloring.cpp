// SPDX-License-Identifier: MIT
#include "workbench/field_images/recoloring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <spdlog/fmt/fmt.h>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

/// Full range, BT.601.
struct Rgb {
  double red, green, blue;

  static Rgb of(double y, double cb, double cr) {
    return {y + 1.402 * cr, y - 0.344136 * cb - 0.714136 * cr, y + 1.772 * cb};
  }
  double luma() const { return 0.299 * red + 0.587 * green + 0.114 * blue; }
  double cb() const { return 0.564 * (blue - luma()); }
  double cr() const { return 0.713 * (red - luma()); }
};

std::array<double, 256> gamma_table(double gamma) {
  std::array<double, 256> table{};
  for (std::size_t i = 1; i < table.size(); ++i)
    table[i] = 255.0 * pinned::exp(gamma * pinned::log(static_cast<double>(i) / 255.0));
  return table;
}

/// Linear between the table's values.
double through(const std::array<double, 256>& table, double value) {
  const double place = std::clamp(value, 0.0, 255.0);
  const auto low = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const double share = place - static_cast<double>(low);
  return (1.0 - share) * table[low] + share * table[low + 1];
}

}  // namespace

std::vector<Recoloring> usual_recolorings() {
  std::vector<Recoloring> all{{.name = "none"}};
  const auto add = [&all](const char* what, double amount, double Recoloring::*member) {
    Recoloring one;
    one.name = fmt::format("{} {:g}", what, amount);
    one.*member = amount;
    all.push_back(one);
  };
  for (const double by : {-16.0, -8.0, 8.0, 16.0}) add("Cr", by, &Recoloring::cr);
  for (const double by : {-16.0, -8.0, 8.0, 16.0}) add("Cb", by, &Recoloring::cb);
  for (const double times : {0.6, 0.8, 1.2, 1.5}) add("red times", times, &Recoloring::red);
  for (const double times : {0.6, 0.8, 1.2, 1.5}) add("blue times", times, &Recoloring::blue);
  for (const double times : {0.3, 0.6, 1.5}) add("saturation times", times, &Recoloring::saturation);
  for (const double exponent : {0.6, 1.6}) add("gamma", exponent, &Recoloring::gamma);
  for (const double by : {0.3, 0.6}) add("vignetting", by, &Recoloring::vignetting);
  return all;
}

Image recolored(const ImageView& image, const Recoloring& how) {
  Image result(image.width, image.height);
  const std::array<double, 256> gamma = gamma_table(how.gamma);
  const bool changes_light = how.vignetting != 0.0 || how.red != 1.0 || how.blue != 1.0 || how.gamma != 1.0;
  const double center_x = 0.5 * (image.width - 1), center_y = 0.5 * (image.height - 1);
  const double corner = center_x * center_x + center_y * center_y;
  for (int y = 0; y < image.height; ++y) {
    std::uint8_t* out = result.row(y);
    for (int x = 0; x + 1 < image.width; x += 2, out += 4) {
      double cb = 0.0, cr = 0.0;
      for (int i = 0; i < 2; ++i) {
        const Ycbcr in = image.at(x + i, y);
        if (!changes_light) {  // unchanged bytes
          out[2 * i] = in.y;
          cb = in.cb - 128.0;
          cr = in.cr - 128.0;
          continue;
        }
        Rgb rgb = Rgb::of(in.y, in.cb - 128.0, in.cr - 128.0);
        const double dx = x + i - center_x, dy = y - center_y;
        const double light = 1.0 - how.vignetting * (corner > 0.0 ? (dx * dx + dy * dy) / corner : 0.0);
        rgb = {through(gamma, light * how.red * rgb.red), through(gamma, light * rgb.green),
               through(gamma, light * how.blue * rgb.blue)};
        out[2 * i] = to_byte(rgb.luma());
        cb += 0.5 * rgb.cb();
        cr += 0.5 * rgb.cr();
      }
      out[1] = to_byte(128.0 + how.saturation * cb + how.cb);
      out[3] = to_byte(128.0 + how.saturation * cr + how.cr);
    }
  }
  return result;
}

}  // namespace reorient
