// SPDX-License-Identifier: MIT
#include "program/run/record_options.h"

#include <CLI/CLI.hpp>

#include "program/options.h"

namespace reorient {

void add_record_options(CLI::App& parser, RecordOptions& options) {
  parser.add_option("--record-images", options.record_images, "camera images: lossless, every:N, none")
      ->type_name("MODE")
      ->group(kOutputGroup)
      ->capture_default_str();
  parser.add_option("--view-images", options.view_images, "images for viewers: jpeg:Q (quality Q, 1 to 100), none")
      ->type_name("MODE")
      ->group(kOutputGroup)
      ->capture_default_str();
  parser
      .add_option("--view-particles", options.view_particles, "particles of the pose filter for viewers: every:N, none")
      ->type_name("MODE")
      ->group(kOutputGroup)
      ->capture_default_str();
  parser.add_option("--record-rotate", options.record_rotate, "start a new file after this size or time: 500MB, 10min")
      ->type_name("LIMIT")
      ->group(kOutputGroup)
      ->check(check_not_empty);
}

}  // namespace reorient
