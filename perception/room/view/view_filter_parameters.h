// SPDX-License-Identifier: MIT
// Method and parameters of the view filter.
#pragma once

namespace reorient {

enum class ViewMethod {
  particles,  ///< the paper's method: weighted and resampled hypotheses
  grid        ///< cells all around, each with a fraction of the belief
};
constexpr int enum_count(ViewMethod) { return 2; }

struct ViewFilterParameters {
  ViewMethod method = ViewMethod::grid;
  int particles = 100;
  int cells = 96;
  double noise = 0.166;
  double sharpness = 150.0;
  double injection = 0.5;
  double clear_lead = 0.05;
  double leak = 30.0;
};
template <typename Visit>
void describe(ViewFilterParameters& p, Visit&& visit) {
  visit("method", p.method, {"particles", "grid"}, "representation of the belief where on the wall the camera looks");
  visit("particles", p.particles, 10, 1000, "", "number of view particles");
  visit("cells", p.cells, 8, 360, "", "number of cells around the wall (method grid)");
  visit("noise", p.noise, 0.0, 2.0, "rad/s^0.5", "random walk of the view; 0.166 is 3 degrees in 0.1 s");
  visit("sharpness", p.sharpness, 0.0, 5000.0, "1/s", "beta: rate at which worse matches lose weight");
  visit("injection", p.injection, 0.0, 10.0, "1/s",
        "rate at which particles are set to the best match (method particles); 0.5 is 5 % in 0.1 s");
  visit("clear_lead", p.clear_lead, 0.0, 1.0, "",
        "lead of the best match over the average at which the injection is complete; 0: always complete");
  visit("leak", p.leak, 0.1, 1000.0, "s",
        "time constant with which the belief fades without new evidence (method grid)");
}

}  // namespace reorient
