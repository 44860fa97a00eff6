// SPDX-License-Identifier: MIT
#include "program/footage/footage_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/text_table.h"

namespace reorient {
namespace {

/// Why a mirrored pose was not found, or a right one was flipped: evidence and room status during the trial.
std::string cause_of(const TrialResult& result) {
  std::map<RoomStatus, int> statuses;
  double most = -1e9, least = 1e9;
  for (const ConfidenceSample& sample : result.confidences) {
    ++statuses[sample.status];
    most = std::max(most, sample.evidence);
    least = std::min(least, sample.evidence);
  }
  if (statuses.empty()) return "no image was processed";
  std::string text;
  for (const auto& [status, count] : statuses)
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", to_string(status),
                        100.0 * count / static_cast<double>(result.confidences.size()));
  return fmt::format("evidence {:.1f} to {:.1f}; the room was {}", least, most, text);
}

bool has_failed(const TrialResult& result, const FootageCase& one) {
  return one.change.mirrored ? result.failed() : result.false_flips > 0;
}

std::string what_went_wrong(const TrialResult& result, const FootageCase& one, double watch) {
  if (!one.change.mirrored) return "flipped";
  if (!result.corrected_after) return "not found";
  return fmt::format("found after {:.1f} s, {}", *result.corrected_after,
                     *result.corrected_after > watch ? "too late" : "but wrong again later");
}

/// The times of the rows as numbers of images, which matter more than seconds at a low rate.
void print_images(const FootageResults& results, std::ostream& out) {
  TextTable lines{{"room", "start", "found", "images until then: median", "p90", "most"}};
  for (std::size_t i = 0; i < results.cells.size(); ++i) {
    if (!results.case_of(i).change.mirrored) continue;
    const CellResults& cell = results.cells[i];
    const FootageTrials& footage = *results.footages[results.footage_of(i)];
    std::vector<int> images;
    for (const TrialResult& result : cell.trials) {
      if (result.right_after)
        images.push_back(footage.images_within(result.seed - 1, result.corrected_after.value_or(*result.right_after)));
    }
    std::sort(images.begin(), images.end());
    const auto quantile = [&](double share) {
      if (images.empty()) return std::string("-");
      return std::to_string(
          images[static_cast<std::size_t>(std::lround(share * static_cast<double>(images.size() - 1)))]);
    };
    lines.push_back({as_line(cell.choices[0]), cell.choices[1],
                     fmt::format("{} of {}", images.size(), cell.trials.size()), quantile(0.5), quantile(0.9),
                     quantile(1.0)});
  }
  out << '\n';
  print_table(lines, 2, out);
}

void print_failures(const FootageResults& results, double watch, const TrialCommand& command, std::ostream& out) {
  bool any = false;
  for (std::size_t i = 0; i < results.cells.size(); ++i) {
    const FootageCase& one = results.case_of(i);
    const CellResults& cell = results.cells[i];
    bool any_here = false;
    for (const TrialResult& result : cell.trials) {
      if (!has_failed(result, one)) continue;
      if (!std::exchange(any, true))
        out << "\nFailed trials. A command shows the first of its row; the others differ in --belief-at:\n";
      const std::size_t index = result.seed - 1;
      if (!std::exchange(any_here, true))
        out << fmt::format("{}, {}, {}:\n    {}\n", as_line(cell.choices[0]), one.start, one.pose,
                           command(results.footage_of(i), index, one));
      const FootageTrials::Start& start = results.footages[results.footage_of(i)]->starts()[index];
      out << fmt::format("  {} s, image {}: {}; {}\n", to_microseconds(start.time), as_line(start.image),
                         what_went_wrong(result, one, watch), cause_of(result));
    }
  }
}

/// Trials that could not succeed, because the robot still learned the room.
void print_unlearned(const FootageResults& results, std::ostream& out) {
  for (std::size_t i = 0; i < results.names.size(); ++i) {
    const auto& starts = results.footages[i]->starts();
    const std::optional<double> learned = results.footages[i]->room_learned_at();
    const auto early =
        std::count_if(starts.begin(), starts.end(), [&](const auto& one) { return !learned || one.time <= *learned; });
    if (early == 0) continue;
    out << fmt::format(
        "\n{}: {} of {} starts come before the room was learned{}\n", as_line(results.names[i]), early, starts.size(),
        learned ? fmt::format(" (at {:.1f} s); --learn {:.0f} leaves them out", *learned, std::floor(*learned) + 1.0)
                : std::string(", which did not happen"));
  }
}

/// Whether trials overlap in time on average.
bool have_common_images(const FootageResults& results, double watch) {
  return std::any_of(results.footages.begin(), results.footages.end(),
                     [&](const std::unique_ptr<FootageTrials>& footage) {
                       const auto& starts = footage->starts();
                       return starts.size() > 1 &&
                              starts.back().time - starts.front().time < watch * static_cast<double>(starts.size() - 1);
                     });
}

void print_answer(const FootageResults& results, std::ostream& out) {
  int mirrored = 0, found = 0, right = 0, flipped = 0;
  for (std::size_t i = 0; i < results.cells.size(); ++i) {
    const FootageCase& one = results.case_of(i);
    for (const TrialResult& result : results.cells[i].trials) {
      const bool failed = has_failed(result, one);
      (one.change.mirrored ? mirrored : right) += 1;
      if (one.change.mirrored && !failed) ++found;
      if (!one.change.mirrored && failed) ++flipped;
    }
  }
  out << fmt::format("\n{} of {} mirrored poses were found ({:.1f} %); {} of {} right poses were flipped ({:.1f} %)\n",
                     found, mirrored, 100.0 * found / mirrored, flipped, right, 100.0 * flipped / right);
}

}  // namespace

double to_microseconds(double seconds) { return std::round(seconds * 1e6) / 1e6; }

void print_footage_results(const FootageResults& results, const FootageTrialOptions& options,
                           const TrialCommand& command, std::ostream& out) {
  print_images(results, out);
  print_failures(results, options.watch, command, out);
  print_unlearned(results, out);
  if (have_common_images(results, options.watch))
    out << "\nTrials are so close in time that they share images: the intervals are narrower than they should "
           "be.\n";
  print_answer(results, out);
}

}  // namespace reorient
