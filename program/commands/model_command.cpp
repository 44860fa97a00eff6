// SPDX-License-Identifier: MIT
// `reorient model`: shows, compares and merges saved models of rooms.
#include <chrono>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/chrono.h>
#include <sys/stat.h>

#include "engine/parameters/utf8.h"
#include "engine/record/frame_record.h"
#include "perception/room/model_comparison.h"
#include "program/help.h"
#include "program/model/model_file.h"
#include "program/model/model_text.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/pictures/record_views.h"

namespace reorient {
namespace {

struct ModelOptions {
  std::filesystem::path file, picture;
  std::filesystem::path first, second, out;  ///< of compare and merge
  bool sides_changed = false;
};

SavedModel read_named(const std::filesystem::path& file) {
  try {
    return read_model_file(file);
  } catch (const std::runtime_error& reason) {
    throw std::runtime_error(file.string() + ": " + reason.what() +
                             "; name a file that 'reorient run --model FILE' wrote");
  }
}

/// In local time; empty if unknown.
std::string time_of(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return {};
  return fmt::format(", saved {:%Y-%m-%d %H:%M}", fmt::localtime(status.st_mtime));
}

/// A file of another type stays: probably its name is a mistake.
void require_new_or(const std::string& what, bool is_one, const std::filesystem::path& file,
                    const std::string& option) {
  std::error_code error;
  if (is_one || !std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) == 0) return;
  throw std::runtime_error(option + " " + file.string() + ": expected a new file or " + what +
                           ", found another file, which was not changed; name another one");
}

bool is_png(const std::filesystem::path& file) {
  constexpr std::string_view kBegin = "\x89PNG";
  std::string begin(kBegin.size(), '\0');
  return std::ifstream(file, std::ios::binary).read(begin.data(), std::ssize(begin)) && begin == kBegin;
}

bool is_model(const std::filesystem::path& file) {
  try {
    read_model_file(file);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

int show_model(const ModelOptions& options, std::ostream& out) {
  if (options.file.empty())
    throw std::runtime_error(
        "expected a file that 'reorient run --model FILE' wrote, found none (see reorient model --help)");
  NamedFiles files;
  files.reads(options.file, "the model");
  files.require_writable(options.picture, "--picture");
  require_new_or("a PNG picture", is_png(options.picture), options.picture, "--picture");
  const SavedModel model = read_named(options.file);
  out << as_line(options.file.string()) << time_of(options.file) << "\n";
  print_model(model, out);
  if (options.picture.empty()) return kSuccess;
  RoomRecord room;
  room.basis = model.basis;
  room.model.assign(model.model.tiles().begin(), model.model.tiles().end());
  pictures::WorldView view = pictures::world_view_of(room, FieldDimensions());
  view.title = as_line(options.file.filename().string());
  view.note = fmt::format("learned for {:.1f} s", model.learned);
  pictures::write_png(options.picture, pictures::draw_world_view(view));
  out << "picture: " << as_line(options.picture.string()) << "\n";
  return kSuccess;
}

struct TwoModels {
  SavedModel first, second;
};

TwoModels read_two(const ModelOptions& options) {
  TwoModels two{read_named(options.first), read_named(options.second)};
  if (const std::string different = differences(two.first.basis, two.second.basis); !different.empty()) {
    throw std::runtime_error(options.second.string() + ": its parameters differ from those of " +
                             options.first.string() + ": " + different +
                             "; only models with the same parameters can be compared or merged");
  }
  return two;
}

int compare_models(const ModelOptions& options, std::ostream& out) {
  const TwoModels two = read_two(options);
  const ModelComparison comparison = compare(two.first, two.second);
  out << "A: " << as_line(options.first.string()) << "\nB: " << as_line(options.second.string()) << "\n";
  print_comparison(comparison, Wall(two.first.basis.wall), out);
  const bool is_known = comparison.mean.has_value();
  return is_known && (!comparison.is_of_one_room() || comparison.is_turned()) ? kWrong : kSuccess;
}

bool is_same(const SavedModel& one, const SavedModel& other) {
  std::vector<std::byte> bytes, other_bytes;
  write_model(one, bytes);
  write_model(other, other_bytes);
  return bytes == other_bytes;
}

int merge_models(const ModelOptions& options, std::ostream& out) {
  NamedFiles files;
  for (const std::filesystem::path& file : {options.first, options.second}) files.reads(file, "a model to merge");
  files.writes(options.out, "--out");
  TwoModels two = read_two(options);
  if (is_same(two.first, two.second))  // the same observations would count twice
    throw std::runtime_error("expected two different models, found the same one: " + options.first.string() + ", " +
                             options.second.string() + "; name two models");
  if (options.sides_changed) two.second.rotate_by_180_degrees();
  const ModelComparison comparison = compare(two.first, two.second);
  if (comparison.mean && comparison.spread && !comparison.is_of_one_room()) {
    throw std::runtime_error(fmt::format(
        "{} and {}: expected models of the same room, found a mean difference of {:.2f}, as between different parts of "
        "one room ({:.2f}); see 'reorient model compare'",
        options.second.string(), options.first.string(), *comparison.mean, *comparison.spread));
  }
  if (comparison.is_turned()) {
    throw std::runtime_error(fmt::format(
        "{} looks like {} rotated by 180 degrees ({:.2f} against {:.2f} unrotated): {} --sides-changed",
        options.second.string(), options.first.string(), comparison.sides->turned, comparison.sides->as_it_is,
        options.sides_changed ? "leave out" : "the teams changed sides; merge them with"));
  }
  // A model that is half wrong is worse than no model.
  if (!comparison.is_same_way()) {
    throw std::runtime_error(fmt::format(
        "{} and {}: expected models of the same room from the same end of the field, found too little agreement; see "
        "'reorient model compare'; let each robot learn more of the tiles that the other one has learned",
        options.first.string(), options.second.string()));
  }
  require_writable_file(options.out, "--out");
  require_new_or("a model", is_model(options.out), options.out, "--out");
  const SavedModel both = merged(two.first, two.second);
  write_model_file(both, options.out);
  out << as_line(options.out.string()) << "\n";
  print_model(both, out);
  return kSuccess;
}

void add_two_models(CLI::App& parser, ModelOptions& options) {
  parser.add_option("first", options.first, "model that 'reorient run --model FILE' wrote")
      ->type_name("FIRST")
      ->check(check_not_empty)
      ->required();
  parser.add_option("second", options.second, "second model, with the same wall")
      ->type_name("SECOND")
      ->check(check_not_empty)
      ->required();
}

}  // namespace

Subcommand add_model(CLI::App& program) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* const parser = program.add_subcommand("model", "show, compare or merge saved models of rooms");
  parser->fallthrough();
  set_examples(*parser, {{"reorient run --model hall.model", "learn a room and save its model"},
                         {"reorient model hall.model --picture hall.png", "show and draw it"},
                         {"reorient model compare a.model b.model", "compare two models"}});
  parser->add_option("file", options->file, "model that 'reorient run --model FILE' wrote")
      ->type_name("FILE")
      ->check(check_not_empty);
  parser->add_option("--picture", options->picture, "draw the model into this PNG file")
      ->type_name("FILE")
      ->check(check_not_empty);
  CLI::App* const comparing =
      parser->add_subcommand("compare", "show where two models differ, and whether one is rotated");
  set_examples(*comparing, {{"reorient model compare a.model b.model", "exit code 1: another room, or rotated"},
                            {"reorient model compare monday.model tuesday.model", "the same room on two days"}});
  add_two_models(*comparing, *options);
  CLI::App* const merging = parser->add_subcommand("merge", "merge the models of two robots into one");
  set_examples(*merging, {{"reorient model merge a.model b.model --out both.model", "merge two models"},
                          {"reorient model merge a.model b.model --out both.model --sides-changed",
                           "the second team played toward the other goal"}});
  add_two_models(*merging, *options);
  merging->add_option("--out", options->out, "file to write")->type_name("FILE")->check(check_not_empty)->required();
  merging->add_flag("--sides-changed", options->sides_changed,
                    "rotate the second model by 180 degrees: its team played toward the other goal");
  return {parser, [options, comparing, merging](std::ostream& out, std::ostream&) {
            if (comparing->parsed()) return compare_models(*options, out);
            if (merging->parsed()) return merge_models(*options, out);
            return show_model(*options, out);
          }};
}

}  // namespace reorient
