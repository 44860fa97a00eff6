// SPDX-License-Identifier: MIT
#include "program/commands/field_images_experiment_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/core_parameters.h"
#include "engine/parameters/counted.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/parameters/utf8.h"
#include "geometry/camera_attitude.h"
#include "geometry/head.h"
#include "program/experiment/outputs/text_table.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/run/venue.h"
#include "workbench/field_images/field_labels.h"
#include "workbench/field_images/field_score.h"
#include "workbench/field_images/recoloring.h"
#include "workbench/field_images/still_image.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/home.h"
#include "workbench/files/input_file.h"
#include "workbench/footage/decoder_library.h"
#include "workbench/footage/open_footage.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/pictures/contact_sheet.h"
#include "workbench/views/scene/camera_overlay.h"

namespace reorient {
namespace {

constexpr const char* kLabels = "field_images";
constexpr int kSheetColumns = 5, kThumbnailWidth = 320;  // pixels

struct FieldImagesOptions {
  std::vector<std::filesystem::path> sources;
  std::filesystem::path labels, body, field;
  ParameterOptions parameters;
  std::filesystem::path out = "out", json;
};

struct LabeledImage {
  const FieldLabels* labels = nullptr;
  Image image;
};

std::vector<std::filesystem::path> files_of(const std::vector<std::filesystem::path>& sources) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& source : sources) {
    std::error_code error;
    if (!std::filesystem::is_directory(source, error)) {
      files.push_back(source);
      continue;
    }
    std::vector<std::filesystem::path> within;
    for (const auto& entry : std::filesystem::directory_iterator(source, error)) {
      if (entry.is_regular_file(error)) within.push_back(entry.path());
    }
    if (error) throw std::runtime_error(as_line(source.string() + ": expected a readable folder: " + error.message()));
    std::sort(within.begin(), within.end());
    files.insert(files.end(), within.begin(), within.end());
  }
  return files;
}

Image image_of(const RawFormat& raw, const std::string& bytes, const std::string& name) {
  Image image(raw.width, raw.height);
  const std::size_t size = image.bytes().size();
  if (bytes.size() < raw.header + size)
    throw std::runtime_error(as_line(fmt::format("{}: expected {} bytes of an image behind {} of a header, found {}",
                                                 name, size, raw.header, bytes.size())));
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(raw.header), size, image.row(0));
  return image;
}

/// Those files that have labels. The names of the others, with their digests, are appended to `unlabeled`.
std::vector<LabeledImage> read_images(const std::vector<std::filesystem::path>& files,
                                      const std::vector<FieldLabels>& labels, std::vector<std::string>& unlabeled) {
  const FootageDecoder decoder = decoder_library();
  std::vector<LabeledImage> images;
  for (const std::filesystem::path& file : files) {
    constexpr std::uintmax_t kLargest = std::uintmax_t{256} << 20;  // bytes
    const std::string bytes = read_named_input(file, "a readable image file", kLargest);
    const std::string digest = digest_of(bytes);
    const FieldLabels* const found = labels_of(labels, digest);
    if (found == nullptr) {
      unlabeled.push_back(as_line(file.string()) + ": digest " + digest);
      continue;
    }
    images.push_back({found, found->raw ? image_of(*found->raw, bytes, file.string()) : read_image(file, decoder)});
  }
  return images;
}

/// One image in one recoloring.
struct Seen {
  FieldScore score;
  pictures::Picture thumbnail;
};

struct Eyes {
  RobotBody body;
  FieldDimensions field;
  FieldFeatureParameters parameters;

  Seen look(const LabeledImage& labeled, const Recoloring& recoloring) const {
    const Image image = recolored(labeled.image.view(), recoloring);
    const CameraModel camera = camera_of(*labeled.labels, image.width(), image.height());
    const Isometry3 robot_from_camera =
        with_attitude(reorient::robot_from_camera(body.dimensions, {}, {}, body.dimensions.torso_height),
                      labeled.labels->pitch, labeled.labels->roll);
    const auto view = GroundProjection::look(camera, robot_from_camera);
    if (!view)
      throw std::runtime_error(
          as_line(labeled.labels->name + ": expected a camera that sees the ground, found labels of another"));
    const FieldPercept percept = percept_of_still_image(image.view(), camera, robot_from_camera, parameters, field);
    const pictures::CameraView drawn{.image = image.view(),
                                     .overlay = scene::percept_overlay(percept, camera, robot_from_camera)};
    return {score_of(percept, *labeled.labels, *view, parameters.line_range),
            pictures::draw_camera_thumbnail(drawn, kThumbnailWidth)};
  }
};

/// The recall of each line that has pieces.
struct Recalls {
  double mean = 1.0, worst = 1.0;
  int lines = 0;
};

Recalls recalls_of(const FieldScore& score) {
  Recalls recalls;
  double sum = 0.0;
  for (const LineScore& line : score.lines) {
    if (line.pieces == 0) continue;
    ++recalls.lines;
    sum += line.recall();
    recalls.worst = std::min(recalls.worst, line.recall());
  }
  if (recalls.lines > 0) recalls.mean = sum / recalls.lines;
  return recalls;
}

constexpr double kGoodRecall = 0.9;

int lines_found(const FieldScore& score) {
  return static_cast<int>(std::count_if(score.lines.begin(), score.lines.end(), [](const LineScore& line) {
    return line.pieces > 0 && line.recall() >= kGoodRecall;
  }));
}

std::vector<std::string> cells_of(const std::string& name, const FieldScore& score) {
  const Recalls recalls = recalls_of(score);
  return {name,
          fmt::format("{} of {}", lines_found(score), recalls.lines),
          fmt::format("{:.2f}", recalls.mean),
          fmt::format("{:.2f}", recalls.worst),
          std::to_string(score.on_lines),
          std::to_string(score.in_masks),
          std::to_string(score.elsewhere()),
          fmt::format("{} of {}", score.posts_found, score.posts),
          std::to_string(score.false_posts),
          fmt::format("{} of {}", score.robots_found, score.robots),
          std::to_string(score.false_obstacles),
          fmt::format("{} of {}", score.balls_found, score.balls),
          std::to_string(score.false_balls + score.false_marks),
          score.border_columns > 0
              ? fmt::format("{:.2f}", static_cast<double>(score.border_found) / score.border_columns)
              : "-"};
}

nlohmann::ordered_json as_json(const std::string& image, const std::string& recoloring, const FieldScore& score) {
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  for (const LineScore& line : score.lines) lines.push_back({{"pieces", line.pieces}, {"found", line.found}});
  return {{"image", as_utf8(image)},
          {"recoloring", recoloring},
          {"lines", std::move(lines)},
          {"line_points", score.line_points},
          {"on_lines", score.on_lines},
          {"in_masks", score.in_masks},
          {"elsewhere", score.elsewhere()},
          {"posts", score.posts},
          {"posts_found", score.posts_found},
          {"false_posts", score.false_posts},
          {"robots", score.robots},
          {"robots_found", score.robots_found},
          {"false_obstacles", score.false_obstacles},
          {"balls", score.balls},
          {"balls_found", score.balls_found},
          {"false_balls", score.false_balls},
          {"marks", score.marks},
          {"marks_found", score.marks_found},
          {"false_marks", score.false_marks},
          {"border_columns", score.border_columns},
          {"border_found", score.border_found},
          {"shows_carpet", score.shows_carpet}};
}

Eyes eyes_of(const FieldImagesOptions& options) {
  Eyes eyes;
  eyes.body = load_body(body_file(options.body));
  eyes.field = load_field(field_file(options.field, eyes.body));
  CoreParameters parameters = core_parameters_for(eyes.field, eyes.body);
  ParameterRegistry registry;
  declare(parameters, registry);
  set_overrides(options.parameters, registry);
  eyes.parameters = parameters.field_features;
  return eyes;
}

int run(const FieldImagesOptions& options, std::ostream& out) {
  const Interruption interruption;
  static constexpr std::string_view kExtensions[] = {".toml"};
  const std::filesystem::path labels_file =
      asset_file("labels", options.labels.empty() ? kLabels : options.labels, kExtensions);
  const std::vector<FieldLabels> labels = load_field_labels(labels_file);
  const std::vector<std::filesystem::path> files = files_of(options.sources);
  NamedFiles named;
  for (const std::filesystem::path& file : files) named.reads(file, file.string());
  named.reads(labels_file, "--labels");
  for (const std::filesystem::path& file : parameter_files_of(options.parameters)) named.reads(file, "--params");
  named.require_writable(options.json, "--json");
  require_writable_folder(options.out, "--out");
  const Eyes eyes = eyes_of(options);
  std::vector<std::string> unlabeled;
  const std::vector<LabeledImage> images = read_images(files, labels, unlabeled);
  if (images.empty())
    throw std::runtime_error(
        as_line(fmt::format("{}: expected images with labels in {}, found {}", options.sources.front().string(),
                            labels_file.string(), unlabeled.empty() ? "no file" : "others: " + unlabeled.front())));

  const std::vector<Recoloring> recolorings = usual_recolorings();
  std::vector<FieldScore> by_recoloring(recolorings.size());
  TextTable of_images{{"image", "lines found", "mean recall", "worst", "on lines", "in masks", "elsewhere", "posts",
                       "false posts", "robots", "false obstacles", "balls", "false balls, marks", "border"}};
  TextTable of_recolorings = of_images;
  of_recolorings[0][0] = "recoloring";
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::vector<std::filesystem::path> sheets;
  for (const LabeledImage& image : images) {
    FieldScore of_image;
    std::vector<pictures::Thumbnail> thumbnails;
    for (std::size_t i = 0; i < recolorings.size(); ++i) {
      if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());
      Seen seen = eyes.look(image, recolorings[i]);
      const Recalls recalls = recalls_of(seen.score);
      thumbnails.push_back({std::move(seen.thumbnail), fmt::format("{}: recall {:.2f}, worst {:.2f}",
                                                                   recolorings[i].name, recalls.mean, recalls.worst)});
      json.push_back(as_json(image.labels->name, recolorings[i].name, seen.score));
      by_recoloring[i] = by_recoloring[i] + seen.score;
      of_image = of_image + seen.score;
    }
    of_images.push_back(cells_of(as_line(image.labels->name), of_image));
    sheets.push_back(options.out / ("field_images_" + image.labels->digest + ".png"));
    pictures::write_png(sheets.back(), pictures::draw_contact_sheet(thumbnails, kSheetColumns, kThumbnailWidth,
                                                                    as_line(image.labels->name)));
  }
  FieldScore all;
  for (std::size_t i = 0; i < recolorings.size(); ++i) {
    of_recolorings.push_back(cells_of(recolorings[i].name, by_recoloring[i]));
    all = all + by_recoloring[i];
  }
  of_recolorings.push_back(cells_of("all", all));
  if (!options.json.empty()) write_whole_file(options.json, json.dump(1) + "\n");

  out << fmt::format("{} in {}\n", counted(images.size(), "labeled image"), counted(recolorings.size(), "recoloring"));
  for (const std::string& one : unlabeled) out << "no labels: " << one << '\n';
  out << '\n';
  print_table(of_recolorings, 1, out);
  out << "\nEach image in all recolorings:\n\n";
  print_table(of_images, 1, out);
  out << fmt::format(
      "\nA line is found where line points are in {:.0f} % of its pieces. in masks: line points on balls, feet, "
      "boards, marks and posts; elsewhere: on the plain carpet. border: fraction of the columns in which the carpet's "
      "boundary is at the boards.\n",
      100.0 * kGoodRecall);
  for (const std::filesystem::path& sheet : sheets) out << "picture: " << as_line(sheet.string()) << '\n';
  return kSuccess;
}

}  // namespace

Subcommand add_field_images_experiment(CLI::App& experiment) {
  const auto options = std::make_shared<FieldImagesOptions>();
  CLI::App* const parser = experiment.add_subcommand(
      "field_images", "score the field vision on labeled images of real fields, also recolored");
  set_examples(*parser,
               {{"reorient experiment field_images images", "all labeled images of a folder"},
                {"reorient experiment field_images images --json scores.json", "with the score of each image"}});
  parser->add_option("source", options->sources, "images, or folders of images; those without labels are skipped")
      ->type_name("SOURCE")
      ->required()
      ->check(check_not_empty);
  parser
      ->add_option("--labels", options->labels,
                   "labels: a file, or the name of one in assets/labels (default: " + std::string(kLabels) + ")")
      ->type_name("FILE")
      ->group("Images")
      ->check(check_not_empty);
  add_body_options(*parser, options->body, options->field);
  add_parameter_options(*parser, options->parameters);
  parser->add_option("--out", options->out, "folder for the contact sheets")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty)
      ->capture_default_str();
  parser->add_option("--json", options->json, "write the scores of each image in each recoloring as JSON")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  return {parser, [options](std::ostream& out, std::ostream&) { return run(*options, out); }};
}

}  // namespace reorient
