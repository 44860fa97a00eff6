// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/rows_file.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

/// A mistake in the file, without the file's name.
struct Flaw : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr std::uintmax_t kLargestRows = std::uintmax_t{512} << 20;  // bytes: a million trials
constexpr double kLongest = 1e9;                                    // s or hours: larger than any measurement
constexpr int kMostEvents = 1'000'000'000;

/// A short value as it is in the file, otherwise its type.
std::string shown(const ordered_json& value) {
  constexpr std::size_t kLongestShown = 40;
  const bool is_short = !value.is_structured() && (!value.is_string() || value.size() <= kLongestShown);
  const std::string text = is_short ? value.dump() : std::string();
  return text.empty() || text.size() > kLongestShown ? value.type_name() : text;
}

const ordered_json& at(const ordered_json& table, const char* key, const char* what) {
  const auto found = table.find(key);
  if (found == table.end()) throw Flaw(fmt::format("expected \"{}\" in {}, found none", key, what));
  return *found;
}

double number_at(const ordered_json& table, const char* key, const char* what) {
  const ordered_json& value = at(table, key, what);
  const double number = value.is_number() ? value.get<double>() : -1.0;
  if (!(number >= 0.0 && number <= kLongest))
    throw Flaw(fmt::format("expected a non-negative number as \"{}\" of {}, found {}", key, what, shown(value)));
  return number;
}

std::optional<double> optional_number_at(const ordered_json& table, const char* key, const char* what) {
  if (at(table, key, what).is_null()) return std::nullopt;
  return number_at(table, key, what);
}

int count_at(const ordered_json& table, const char* key, const char* what) {
  const ordered_json& value = at(table, key, what);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMostEvents)
    throw Flaw(fmt::format("expected a non-negative whole number as \"{}\" of {}, found {}", key, what, shown(value)));
  return value.get<int>();
}

bool yes_at(const ordered_json& table, const char* key, const char* what) {
  const ordered_json& value = at(table, key, what);
  if (!value.is_boolean())
    throw Flaw(fmt::format("expected true or false as \"{}\" of {}, found {}", key, what, shown(value)));
  return value.get<bool>();
}

std::optional<Reorientation> reorientation_at(const ordered_json& table, const char* key, const char* what) {
  const ordered_json& value = at(table, key, what);
  if (value.is_null()) return std::nullopt;
  for (int i = 0; i < enum_count(Reorientation()); ++i) {
    const auto reorientation = static_cast<Reorientation>(i);
    if (value == to_string(reorientation)) return reorientation;
  }
  throw Flaw(fmt::format("expected a command as \"{}\" of {}, found {}", key, what, shown(value)));
}

/// The key, or its former name where the file has that one.
const char* present_or_former(const ordered_json& table, const char* present, const char* former) {
  return !table.contains(present) && table.contains(former) ? former : present;
}

Outcome outcome_from(const ordered_json& table) {
  constexpr const char* kWhat = "an outcome";
  if (!table.is_object()) throw Flaw("expected an object as an outcome, found " + shown(table));
  const ordered_json& seed = at(table, "seed", kWhat);
  if (!seed.is_number_unsigned())
    throw Flaw("expected a non-negative whole number as \"seed\" of an outcome, found " + shown(seed));
  return {seed.get<std::uint64_t>(),
          yes_at(table, "disturbed", kWhat),
          yes_at(table, "failed", kWhat),
          optional_number_at(table, "right_after_s", kWhat),
          optional_number_at(table, present_or_former(table, "corrected_after_s", "mended_after_s"), kWhat),
          reorientation_at(table, present_or_former(table, "corrected_by", "mended_by"), kWhat),
          count_at(table, "false_flips", kWhat)};
}

StoredRow row_from(const ordered_json& table) {
  constexpr const char* kWhat = "a row";
  if (!table.is_object()) throw Flaw("expected an object as a row, found " + shown(table));
  static_cast<void>(at(table, "trials", kWhat));
  StoredRow row;
  // The axes' choices come first.
  for (auto entry = table.begin(); entry != table.end() && entry.key() != "trials"; ++entry) {
    if (!entry->is_string())
      throw Flaw(fmt::format("expected a text as choice of \"{}\" in a row, found {}", entry.key(), shown(*entry)));
    row.choices.emplace_back(entry.key(), entry->get<std::string>());
  }
  row.false_flips = count_at(table, "false_flips", kWhat);
  row.right_hours = number_at(table, "right_hours", kWhat);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  row.false_flip_rate = {optional_number_at(table, "false_flips_per_hour_low", kWhat).value_or(0.0),
                         optional_number_at(table, "false_flips_per_hour_high", kWhat).value_or(kInfinite)};
  const ordered_json& outcomes = at(table, "outcomes", kWhat);
  if (!outcomes.is_array()) throw Flaw("expected a list as \"outcomes\" of a row, found " + shown(outcomes));
  std::set<std::uint64_t> seeds;
  for (const ordered_json& one : outcomes) {
    row.outcomes.push_back(outcome_from(one));
    const std::uint64_t seed = row.outcomes.back().seed;
    if (!seeds.insert(seed).second) throw Flaw(fmt::format("expected different seeds in a row, found {} twice", seed));
  }
  return row;
}

std::vector<StoredRow> rows_from(const ordered_json& list) {
  if (!list.is_array() || list.empty())
    throw Flaw(std::string("expected a list of rows, found ") + (list.is_array() ? "an empty one" : list.type_name()));
  std::vector<StoredRow> rows;
  std::set<std::vector<std::pair<std::string, std::string>>> seen;
  for (const ordered_json& one : list) {
    rows.push_back(row_from(one));
    if (!seen.insert(rows.back().choices).second)
      throw Flaw("expected rows with different choices, found two with the same");
  }
  // Rows that are pooled over the rooms have no trials to compare.
  const bool has_trials =
      std::any_of(rows.begin(), rows.end(), [](const StoredRow& row) { return !row.outcomes.empty(); });
  if (has_trials) std::erase_if(rows, [](const StoredRow& row) { return row.outcomes.empty(); });
  return rows;
}

}  // namespace

std::vector<StoredRow> read_rows(const std::filesystem::path& file) {
  const auto refuse = [&file](const std::string& why) {
    throw std::runtime_error(as_line(file.string() + ": " + why));
  };
  const std::string text = read_named_input(file, "a file that 'experiment --json' wrote", kLargestRows);
  try {
    return rows_from(ordered_json::parse(text));
  } catch (const nlohmann::json::parse_error& mistake) {
    const auto until = text.begin() + static_cast<std::ptrdiff_t>(std::min(mistake.byte, text.size()));
    throw std::runtime_error(as_line(
        fmt::format("{}:{}: expected JSON, found invalid or truncated text; 'experiment --json' writes it again",
                    file.string(), 1 + std::count(text.begin(), until, '\n'))));
  } catch (const nlohmann::json::exception&) {
    refuse("expected numbers below 1.8e308, found a larger one; 'experiment --json' writes it again");
  } catch (const Flaw& flaw) {
    refuse(std::string(flaw.what()) + "; 'experiment --json' writes it again");
  }
  return {};
}

}  // namespace reorient
