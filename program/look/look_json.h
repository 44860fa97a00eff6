// SPDX-License-Identifier: MIT
// The percepts of one image as JSON (docs/vision.md).
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "program/look/seen_image.h"
#include "robots/robot_body.h"
#include "workbench/files/atomic_file.h"

namespace reorient {

/// "given", "recorded", "searched".
const char* to_string(PitchSource source);

/// On one line.
std::string as_json(const LookImage& image, const SeenImage& seen, const RobotBody& body);

/// A list of JSON values in a file, written one by one; it replaces `file` when it is complete.
class JsonList {
 public:
  /// All functions throw std::runtime_error with one line.
  explicit JsonList(const std::filesystem::path& file);
  void add(const std::string& value);
  void end();

 private:
  FileInTheMaking file_;
  std::ofstream out_;
  bool is_empty_ = true;
};

}  // namespace reorient
