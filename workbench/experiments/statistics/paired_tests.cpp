// SPDX-License-Identifier: MIT
#include "workbench/experiments/statistics/paired_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr std::size_t kMostExact = 300;  // pairs that differ; the exact test takes the cube of their number

/// Ranks of nonzero differences by size, times two, so that the mean of several ranks is a whole number.
struct SignedRanks {
  std::vector<std::size_t> doubled;
  std::size_t total = 0;
  std::size_t positive = 0;  ///< sum over the positive differences
  std::size_t nearer() const { return std::min(positive, total - positive); }
};

SignedRanks signed_ranks(std::vector<double> differences) {
  std::sort(differences.begin(), differences.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  SignedRanks ranks;
  ranks.doubled.resize(differences.size());
  for (std::size_t begin = 0; begin < differences.size();) {
    std::size_t end = begin;
    while (end < differences.size() && std::abs(differences[end]) == std::abs(differences[begin])) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      ranks.doubled[i] = begin + 1 + end;
      ranks.total += ranks.doubled[i];
      ranks.positive += differences[i] > 0.0 ? ranks.doubled[i] : 0;
    }
    begin = end;
  }
  return ranks;
}

double exact_p(const SignedRanks& ranks) {
  // The probability of each sum of the positive ranks, if both signs were equally probable.
  std::vector<double> probability(ranks.total + 1, 0.0);
  probability[0] = 1.0;
  std::size_t reached = 0;
  for (const std::size_t rank : ranks.doubled) {
    for (std::size_t sum = reached + 1; sum-- > 0;) {
      probability[sum] *= 0.5;
      probability[sum + rank] += probability[sum];
    }
    reached += rank;
  }
  double tail = 0.0;
  for (std::size_t sum = 0; sum <= ranks.nearer(); ++sum) tail += probability[sum];
  return std::min(1.0, 2.0 * tail);
}

/// The fraction of the normal distribution beyond z >= 0, to 7.5e-8 (Abramowitz and Stegun 1964, 26.2.17).
double normal_tail(double z) {
  constexpr double kDensity = 0.3989422804014327;  // 1 / sqrt(2 pi)
  const double t = 1.0 / (1.0 + 0.2316419 * z);
  const double series =
      t * (0.319381530 + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429))));
  return kDensity * pinned::exp(-0.5 * z * z) * series;
}

double normal_p(const SignedRanks& ranks) {
  double variance = 0.0;  // of the sum: each rank counts or does not
  for (const std::size_t rank : ranks.doubled) variance += 0.25 * static_cast<double>(rank) * static_cast<double>(rank);
  const double off = 0.5 * static_cast<double>(ranks.total) - static_cast<double>(ranks.nearer());
  const double z = std::max(0.0, off - 1.0) / std::sqrt(variance);  // half a rank for continuity
  return std::min(1.0, 2.0 * normal_tail(z));
}

}  // namespace

double mcnemar_p(int only_first, int only_second) {
  const int count = only_first + only_second;
  const int fewer = std::min(only_first, only_second);
  constexpr int kMostWhole = 1000;  // pairs; with more, a single term may underflow
  double sum = 0.0;
  if (count <= kMostWhole) {
    double term = std::ldexp(1.0, -count);
    for (int i = 0; i <= fewer; ++i) {
      sum += term;
      term *= static_cast<double>(count - i) / (i + 1);
    }
  } else {
    double logarithm = -count * pinned::log(2.0);
    for (int i = 0; i <= fewer; ++i) {
      sum += pinned::exp(logarithm);
      logarithm += pinned::log(static_cast<double>(count - i) / (i + 1));
    }
  }
  return std::min(1.0, 2.0 * sum);
}

double wilcoxon_p(const std::vector<std::pair<double, double>>& pairs) {
  std::vector<double> differences;
  for (const auto& [first, second] : pairs) {
    if (first != second) differences.push_back(first - second);
  }
  const SignedRanks ranks = signed_ranks(std::move(differences));
  return ranks.doubled.size() <= kMostExact ? exact_p(ranks) : normal_p(ranks);
}

}  // namespace reorient
