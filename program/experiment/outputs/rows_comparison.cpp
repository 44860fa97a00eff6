// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/rows_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/text_table.h"
#include "workbench/experiments/tables/paired_comparison.h"

namespace reorient {
namespace {

using Choices = std::vector<std::pair<std::string, std::string>>;

std::string name_of(const Choices& choices) {
  std::string name;
  for (const auto& [axis, choice] : choices) name += (name.empty() ? "" : ", ") + as_line(axis) + " " + as_line(choice);
  return name.empty() ? "the only row" : name;
}

Choices sorted(Choices choices) {
  std::sort(choices.begin(), choices.end());
  return choices;
}

/// `rest_of`: the choices that must be equal in both partners.
template <typename RestOf>
PairedRows paired(const std::vector<StoredRow>& first, const std::vector<StoredRow>& second, RestOf&& rest_of) {
  std::map<Choices, const StoredRow*> partners;
  for (const StoredRow& row : second) partners[sorted(rest_of(row))] = &row;
  PairedRows rows;
  for (const StoredRow& row : first) {
    const auto partner = partners.find(sorted(rest_of(row)));
    if (partner == partners.end()) {
      rows.only_first.push_back(name_of(row.choices));
    } else {
      rows.pairs.push_back({name_of(rest_of(row)), row, *partner->second});
      partners.erase(partner);
    }
  }
  for (const StoredRow& row : second) {
    if (partners.contains(sorted(rest_of(row)))) rows.only_second.push_back(name_of(row.choices));
  }
  return rows;
}

std::string p_text(double p) { return p < 0.0001 ? "< 0.0001" : fmt::format("{:.4f}", p); }

std::string failed_text(int failed, int disturbed) {
  return disturbed == 0 ? "-" : fmt::format("{} of {}", failed, disturbed);
}

std::string difference_text(const PairedComparison& comparison) {
  if (!comparison.median_difference) return "-";
  if (!comparison.interval) return fmt::format("{:+.1f}", *comparison.median_difference);
  return fmt::format("{:+.1f} [{:+.1f}, {:+.1f}]", *comparison.median_difference, comparison.interval->low,
                     comparison.interval->high);
}

std::string rate_text(const StoredRow& row) {
  if (row.right_hours <= 0.0 || !std::isfinite(row.false_flip_rate.high)) return "-";
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", row.false_flips / row.right_hours, row.false_flip_rate.low,
                     row.false_flip_rate.high);
}

std::vector<std::string> cells_of(const RowPair& pair, const PairedComparison& comparison) {
  return {pair.name,
          std::to_string(comparison.pairs),
          failed_text(comparison.failed_first, comparison.disturbed),
          failed_text(comparison.failed_second, comparison.disturbed),
          std::to_string(comparison.only_first_failed),
          std::to_string(comparison.only_second_failed),
          comparison.disturbed == 0 ? "-" : p_text(comparison.failed_p),
          difference_text(comparison),
          comparison.timed == 0 ? "-" : p_text(comparison.times_p),
          rate_text(pair.first),
          rate_text(pair.second)};
}

/// " (did you mean 'hard'?)", or all names if none is similar.
std::string hint_at(const std::string& wanted, const std::set<std::string>& known) {
  const std::vector<std::string> names(known.begin(), known.end());
  const std::string hint = did_you_mean(wanted, names);
  return as_line(hint.empty() ? " (expected " + list_of(names) + ")" : hint);
}

}  // namespace

PairedRows pair_rows(std::pair<std::string, std::vector<StoredRow>> first,
                     std::pair<std::string, std::vector<StoredRow>> second) {
  PairedRows rows = paired(first.second, second.second, [](const StoredRow& row) { return row.choices; });
  rows.first_name = std::move(first.first);
  rows.second_name = std::move(second.first);
  return rows;
}

PairedRows pair_choices(const std::vector<StoredRow>& rows, const std::string& axis, const std::string& from,
                        const std::string& to) {
  if (from == to)
    throw std::runtime_error("--from and --to: expected two different choices, found '" + as_line(from) + "' twice");
  std::set<std::string> axes, choices;
  for (const StoredRow& row : rows) {
    for (const auto& [name, choice] : row.choices) {
      axes.insert(name);
      if (name == axis) choices.insert(choice);
    }
  }
  if (choices.empty()) throw std::runtime_error("--axis: unknown axis '" + as_line(axis) + "'" + hint_at(axis, axes));
  const auto chosen = [&](const std::string& wanted) {
    if (!choices.contains(wanted))
      throw std::runtime_error("axis '" + as_line(axis) + "': unknown choice '" + as_line(wanted) + "'" +
                               hint_at(wanted, choices));
    std::vector<StoredRow> some;
    for (const StoredRow& row : rows) {
      if (std::find(row.choices.begin(), row.choices.end(), std::pair(axis, wanted)) != row.choices.end())
        some.push_back(row);
    }
    return some;
  };
  PairedRows all = paired(chosen(from), chosen(to), [&axis](const StoredRow& row) {
    Choices rest = row.choices;
    std::erase_if(rest, [&axis](const auto& choice) { return choice.first == axis; });
    return rest;
  });
  all.first_name = as_line(axis) + " " + as_line(from);
  all.second_name = as_line(axis) + " " + as_line(to);
  return all;
}

void print_comparison(const PairedRows& rows, std::ostream& out) {
  TextTable table{{"", "pairs", "failed A", "failed B", "A alone", "B alone", "p", "B later by, s [95 %]", "p",
                   "A, false flips/h", "B, false flips/h"}};
  std::string notes;
  int pairs = 0;
  for (const RowPair& pair : rows.pairs) {
    const PairedComparison comparison = compare_pairs(pair.first.outcomes, pair.second.outcomes);
    pairs += comparison.pairs;
    table.push_back(cells_of(pair, comparison));
    if (comparison.without_pair > 0)
      notes += fmt::format("{}: {} without a trial of the same seed in the other row\n", pair.name,
                           counted(comparison.without_pair, "trial"));
  }
  if (rows.pairs.empty())
    throw std::runtime_error(fmt::format("{}: expected a row with the same choices as one of {} ({}), found none ({})",
                                         rows.second_name, rows.first_name, rows.only_first.front(),
                                         rows.only_second.front()));
  if (pairs == 0)
    throw std::runtime_error(
        fmt::format("{}: expected a trial with the same seed as one of {}, found none; run both with the same --seed",
                    rows.second_name, rows.first_name));
  for (const std::string& row : rows.only_first) notes += row + ": only in A\n";
  for (const std::string& row : rows.only_second) notes += row + ": only in B\n";
  out << "A: " << rows.first_name << "\nB: " << rows.second_name << "\n\n";
  print_table(table, 1, out);
  out << (notes.empty() ? "" : "\n") << notes;
}

}  // namespace reorient
