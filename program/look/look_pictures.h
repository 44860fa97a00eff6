// SPDX-License-Identifier: MIT
// The pictures of `reorient look`: one for each of a few images, or sheets of small pictures.
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/contact_sheet.h"

namespace reorient {

class LookPictures {
 public:
  static constexpr std::size_t kMostPictures = 6;  ///< more images go into sheets
  static constexpr int kColumns = 5, kRows = 6;    ///< of a sheet

  /// `inputs`: files that no picture may replace. `title`: of the sheets.
  LookPictures(std::filesystem::path folder, std::vector<std::filesystem::path> inputs, std::string title);

  /// `name`: of the image. `short_caption`: for a sheet. Throws std::runtime_error with one line if a sheet cannot
  /// be written.
  void add(const pictures::CameraView& view, const std::string& name, const std::string& caption,
           const std::string& short_caption);
  /// Writes the rest. Throws the same.
  void end();

  /// In the order of writing.
  const std::vector<std::filesystem::path>& written() const { return written_; }

 private:
  struct Single {
    std::filesystem::path file;
    pictures::Picture picture;
  };
  void write(const std::filesystem::path& file, const pictures::Picture& picture);
  void write_sheet();
  std::filesystem::path file_for(const std::string& name);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> inputs_;
  std::string title_;
  std::size_t count_ = 0;
  int sheets_ = 0;
  std::set<std::string> names_;
  std::vector<Single> singles_;  // until there are too many
  std::vector<pictures::Thumbnail> thumbnails_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace reorient
