// SPDX-License-Identifier: MIT
#include "localization/calibration/offset_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "geometry/random.h"

namespace reorient {
namespace {

using Vector = Eigen::Matrix<double, kOffsetComponents, 1>;
using Matrix = Eigen::Matrix<double, kOffsetComponents, kOffsetComponents>;

constexpr int kResamples = 60;
constexpr int kMostSteps = 40;
constexpr int kResampleSteps = 2;                            // from a nearly correct start
constexpr OffsetValues kDifference{2e-3, 2e-3, 2e-3, 2e-3};  // for derivatives, rad and m
constexpr OffsetValues kConverged{1e-6, 1e-6, 1e-6, 1e-6};

struct Mixture {
  double noise = 0.0;
  double inliers = 0.5;

  /// The probability that a residual is an inlier.
  double probability(double residual, double window) const {
    if (!(std::abs(residual) < window)) return 0.0;
    const double scaled = residual / noise;
    const double normal = inliers * pinned::exp(-0.5 * scaled * scaled) / (noise * std::sqrt(2.0 * kPi));
    const double uniform = (1.0 - inliers) / (2.0 * window);
    return normal / (normal + uniform);
  }
};

struct Solution {
  OffsetValues values{};
  Mixture mixture;
};

struct Grid {
  std::vector<OffsetValues> cells;
  std::vector<std::vector<double>> costs;  // [image][cell]
};

class OffsetFit {
 public:
  OffsetFit(const OffsetProblem& problem, const std::array<bool, kOffsetComponents>& free)
      : problem_(problem), free_(free) {
    make_cells();
    grid_.costs.resize(problem.images);
    std::vector<WeightedResidual> residuals;
    for (std::size_t image = 0; image < problem.images; ++image) {
      for (const OffsetValues& cell : grid_.cells) {
        problem.residuals(image, offset_of(cell), problem.every, residuals);
        double cost = 0.0;
        for (const WeightedResidual& one : residuals) {
          const double capped = std::min(std::abs(one.value), problem.cap);
          cost += one.weight * capped * capped;
        }
        grid_.costs[image].push_back(cost);
      }
    }
  }

  Solution solve(const std::vector<int>& counts) const {
    return refined({grid_.cells[best_cell(counts)], {problem_.cap, 0.5}}, counts, kMostSteps);
  }

  /// Standard errors around a solution, from resampled images.
  OffsetValues deviations(const Solution& solution) const {
    Random random(1, problem_.images);
    OffsetValues sums{};
    std::vector<int> counts;
    for (int i = 0; i < kResamples; ++i) {
      counts.assign(problem_.images, 0);
      for (std::size_t k = 0; k < problem_.images; ++k) ++counts[random.below(problem_.images)];
      const OffsetValues& cell = grid_.cells[best_cell(counts)];
      const bool is_near = differ_by_at_most(cell, solution.values, 1.5);
      const Solution again = is_near ? refined(solution, counts, kResampleSteps)
                                     : refined({cell, {problem_.cap, 0.5}}, counts, kMostSteps);
      for (std::size_t c = 0; c < kOffsetComponents; ++c)
        sums[c] += (again.values[c] - solution.values[c]) * (again.values[c] - solution.values[c]);
    }
    for (double& sum : sums) sum = std::sqrt(sum / kResamples);
    return sums;
  }

 private:
  void make_cells() {
    grid_.cells = {OffsetValues{}};
    for (std::size_t c = 0; c < kOffsetComponents; ++c) {
      if (!free_[c] || problem_.reach[c] <= 0.0) continue;
      const int steps = static_cast<int>(std::lround(problem_.reach[c] / problem_.step[c]));
      std::vector<OffsetValues> more;
      for (const OffsetValues& cell : grid_.cells) {
        for (int i = -steps; i <= steps; ++i) {
          more.push_back(cell);
          more.back()[c] = i * problem_.step[c];
        }
      }
      grid_.cells = std::move(more);
    }
  }

  std::size_t best_cell(const std::vector<int>& counts) const {
    std::vector<double> sums(grid_.cells.size(), 0.0);
    for (std::size_t image = 0; image < problem_.images; ++image) {
      if (counts[image] == 0) continue;
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += counts[image] * grid_.costs[image][i];
    }
    return static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
  }

  bool differ_by_at_most(const OffsetValues& a, const OffsetValues& b, double steps) const {
    for (std::size_t c = 0; c < kOffsetComponents; ++c) {
      if (free_[c] && problem_.reach[c] > 0.0 && std::abs(a[c] - b[c]) > steps * problem_.step[c]) return false;
    }
    return true;
  }

  Solution refined(Solution solution, const std::vector<int>& counts, int most_steps) const {
    for (int i = 0; i < most_steps; ++i) {
      const Vector step = take_step(solution, counts);
      bool is_converged = true;
      for (std::size_t c = 0; c < kOffsetComponents; ++c)
        is_converged = is_converged && std::abs(step[static_cast<Eigen::Index>(c)]) < kConverged[c];
      if (is_converged) break;
    }
    return solution;
  }

  /// One Gauss-Newton step with the weights of the mixture. Also updates the mixture from the same residuals.
  Vector take_step(Solution& solution, const std::vector<int>& counts) const {
    Matrix information = Matrix::Zero();
    Vector gradient = Vector::Zero();
    double weights = 0.0, inliers = 0.0, squares = 0.0;
    std::vector<WeightedResidual> residuals;
    std::array<std::vector<WeightedResidual>, kOffsetComponents> above, below;
    const double variance = solution.mixture.noise * solution.mixture.noise;
    for (std::size_t image = 0; image < problem_.images; ++image) {
      if (counts[image] == 0) continue;
      problem_.residuals(image, offset_of(solution.values), 1, residuals);
      for (std::size_t c = 0; c < kOffsetComponents; ++c) {
        if (!free_[c]) continue;
        OffsetValues moved = solution.values;
        moved[c] = solution.values[c] + kDifference[c];
        problem_.residuals(image, offset_of(moved), 1, above[c]);
        moved[c] = solution.values[c] - kDifference[c];
        problem_.residuals(image, offset_of(moved), 1, below[c]);
      }
      for (std::size_t i = 0; i < residuals.size(); ++i) {
        const WeightedResidual& one = residuals[i];
        const double weight = counts[image] * one.weight;
        const double probable = weight * solution.mixture.probability(one.value, problem_.window);
        weights += weight;
        inliers += probable;
        if (probable <= 0.0) continue;
        squares += probable * one.value * one.value;
        Vector slope = Vector::Zero();
        bool is_smooth = true;
        for (std::size_t c = 0; c < kOffsetComponents; ++c) {
          if (!free_[c]) continue;
          const double difference = above[c][i].value - below[c][i].value;
          // A jump: another line has become the nearest one, so the derivative does not exist.
          is_smooth = is_smooth && std::abs(difference) < 20.0 * kDifference[c];
          slope[static_cast<Eigen::Index>(c)] = difference / (2.0 * kDifference[c]);
        }
        if (!is_smooth) continue;
        information += probable / variance * slope * slope.transpose();
        gradient += probable / variance * one.value * slope;
      }
    }
    if (weights > 0.0 && inliers > 0.0) {
      solution.mixture.inliers = std::clamp(inliers / weights, 0.01, 0.99);
      solution.mixture.noise = std::clamp(std::sqrt(squares / inliers), problem_.least_noise, problem_.window);
    }
    for (std::size_t c = 0; c < kOffsetComponents; ++c) {
      const auto k = static_cast<Eigen::Index>(c);
      const double prior = free_[c] ? 1.0 / (problem_.prior[c] * problem_.prior[c]) : 1.0;
      information(k, k) += prior;
      gradient[k] += free_[c] ? prior * solution.values[c] : 0.0;
    }
    Vector step = -information.ldlt().solve(gradient);
    for (std::size_t c = 0; c < kOffsetComponents; ++c) {
      const auto k = static_cast<Eigen::Index>(c);
      const double most = problem_.reach[c] > 0.0 ? problem_.step[c] : problem_.prior[c];
      step[k] = free_[c] ? std::clamp(step[k], -most, most) : 0.0;
      solution.values[c] += step[k];
    }
    return step;
  }

  const OffsetProblem& problem_;
  std::array<bool, kOffsetComponents> free_;
  Grid grid_;
};

}  // namespace

OffsetValues values_of(const CameraOffset& offset) { return {offset.tilt, offset.pan, offset.roll, offset.height}; }
CameraOffset offset_of(const OffsetValues& values) { return {values[0], values[1], values[2], values[3]}; }

bool OffsetEstimate::is_any_determined() const {
  return std::any_of(deviation.begin(), deviation.end(), [](const auto& one) { return one.has_value(); });
}

OffsetEstimate fit_offset(const OffsetProblem& problem, const OffsetValues& most) {
  OffsetEstimate estimate;
  if (problem.images < 2) return estimate;
  std::array<bool, kOffsetComponents> free = problem.observable;
  const std::vector<int> once(problem.images, 1);
  while (std::find(free.begin(), free.end(), true) != free.end()) {
    const OffsetFit fit(problem, free);
    const Solution solution = fit.solve(once);
    if (solution.mixture.inliers < problem.least_inliers) return estimate;
    const OffsetValues deviations = fit.deviations(solution);
    // Removes the least determined component first, because the others may be determined without it.
    std::size_t worst = kOffsetComponents;
    double excess = 1.0;
    for (std::size_t c = 0; c < kOffsetComponents; ++c) {
      if (!free[c]) continue;
      const double limit = problem.reach[c] > 0.0 ? problem.reach[c] : 2.0 * problem.prior[c];
      const double ratio =
          std::abs(solution.values[c]) > limit ? std::numeric_limits<double>::max() : deviations[c] / most[c];
      if (ratio <= excess) continue;
      excess = ratio;
      worst = c;
    }
    if (worst < kOffsetComponents) {
      free[worst] = false;
      continue;
    }
    estimate.offset = offset_of(solution.values);
    estimate.noise = solution.mixture.noise;
    estimate.inliers = solution.mixture.inliers;
    for (std::size_t c = 0; c < kOffsetComponents; ++c) {
      if (free[c]) estimate.deviation[c] = deviations[c];
    }
    break;
  }
  return estimate;
}

double weighted_median(std::vector<WeightedResidual> values) {
  std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  double all = 0.0, sum = 0.0;
  for (const WeightedResidual& one : values) all += one.weight;
  for (const WeightedResidual& one : values) {
    sum += one.weight;
    if (2.0 * sum >= all) return one.value;
  }
  return 0.0;
}

}  // namespace reorient
