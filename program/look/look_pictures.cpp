// SPDX-License-Identifier: MIT
#include "program/look/look_pictures.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "workbench/views/pictures/canvas/png_file.h"

namespace reorient {
namespace {

constexpr int kThumbnailWidth = 256;  // pixels

/// "images/0001.jpg" -> "images_0001".
std::string stem_of(const std::string& name) {
  std::string stem = std::filesystem::path(name).replace_extension().string();
  std::replace_if(
      stem.begin(), stem.end(), [](char letter) { return letter == '/' || letter == ' ' || letter == '\\'; }, '_');
  return stem.empty() ? "image" : stem;
}

}  // namespace

LookPictures::LookPictures(std::filesystem::path folder, std::vector<std::filesystem::path> inputs, std::string title)
    : folder_(std::move(folder)), inputs_(std::move(inputs)), title_(std::move(title)) {}

void LookPictures::add(const pictures::CameraView& view, const std::string& name, const std::string& caption,
                       const std::string& short_caption) {
  ++count_;
  if (count_ <= kMostPictures) singles_.push_back({file_for(name), pictures::draw_camera_view(view, caption)});
  if (count_ > kMostPictures) singles_.clear();
  thumbnails_.push_back({pictures::draw_camera_thumbnail(view, kThumbnailWidth), short_caption});
  if (thumbnails_.size() == static_cast<std::size_t>(kColumns) * kRows) write_sheet();
}

void LookPictures::end() {
  for (const Single& single : singles_) write(single.file, single.picture);
  if (count_ > kMostPictures && !thumbnails_.empty()) write_sheet();
}

void LookPictures::write(const std::filesystem::path& file, const pictures::Picture& picture) {
  std::error_code error;
  for (const std::filesystem::path& input : inputs_) {
    if (std::filesystem::equivalent(input, file, error))
      throw std::runtime_error(
          file.string() +
          ": expected a picture that replaces no input, found an input of this name; name another folder with --out");
  }
  pictures::write_png(file, picture);
  written_.push_back(file);
}

void LookPictures::write_sheet() {
  ++sheets_;
  write(folder_ / fmt::format("sheet_{:03}.png", sheets_),
        pictures::draw_contact_sheet(thumbnails_, kColumns, kThumbnailWidth,
                                     fmt::format("{}: sheet {}", title_, sheets_)));
  thumbnails_.clear();
}

std::filesystem::path LookPictures::file_for(const std::string& name) {
  const std::string stem = stem_of(name);
  std::string unique = stem;
  for (int i = 2; !names_.insert(unique).second; ++i) unique = fmt::format("{}_{}", stem, i);
  return folder_ / (unique + "_look.png");
}

}  // namespace reorient
