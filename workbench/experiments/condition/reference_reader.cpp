// SPDX-License-Identifier: MIT
#include "workbench/experiments/condition/reference_reader.h"

namespace reorient {
namespace {

constexpr int kMostReferenceTrials = 1'000'000'000;
constexpr double kYear = 3.2e7;  // s

Reference read_reference(const TableReader& in, const std::string& file) {
  Reference reference;
  const auto share = [&in](std::optional<double>& target) {
    return [&in, &target](auto& key, auto& value) { target = in.number(key, value, 0.0, 1.0); };
  };
  const auto seconds = [&in](std::optional<double>& target) {
    return [&in, &target](auto& key, auto& value) { target = in.number(key, value, 0.0, kYear); };
  };
  in.read({
      {"label", [&](auto& key, auto& value) { reference.label = in.text(key, value); }},
      {"choices",
       [&](auto& key, auto& value) {
         const toml::table& choices = in.table(key, value);
         const TableReader inner(choices, file);
         for (const auto& [axis, choice] : choices)
           reference.choices.emplace_back(std::string(axis.str()), inner.text(std::string(axis.str()), choice));
       }},
      {"trials",
       [&](auto& key, auto& value) {
         reference.trials = static_cast<int>(in.whole(key, value, 1, kMostReferenceTrials));
       }},
      {"flip", share(reference.flip)},
      {"purge", share(reference.purge)},
      {"failed", share(reference.failed)},
      {"mean_s", seconds(reference.mean_s)},
      {"flip_mean_s", seconds(reference.flip_mean_s)},
      {"purge_mean_s", seconds(reference.purge_mean_s)},
  });
  return reference;
}

}  // namespace

std::vector<Reference> read_references(const TableReader& in, const toml::array& tables, const std::string& file) {
  std::vector<Reference> references;
  for (const toml::node& one : tables) {
    references.push_back(read_reference(TableReader(*one.as_table(), file), file));
    if (references.back().label.empty()) in.refuse(one, "reference: expected a label (who measured it), found none");
  }
  return references;
}

}  // namespace reorient
