// SPDX-License-Identifier: MIT
#include "workbench/footage/open_footage.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "robots/footage/messages/bad_message.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20;  // bytes, of an image or a table

/// Refuses pipes and devices, because reading them could block. Throws BadFootage.
void require_file(const fs::path& file, const std::string& what) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw BadFootage(file.string() + ": expected " + what + ", found nothing of that name");
  if (status.type() != fs::file_type::regular)
    throw BadFootage(file.string() + ": expected " + what + ", found something that is not a regular file");
}

std::string read_file(const fs::path& file, const std::string& what) {
  require_file(file, what);
  try {
    return read_named_input(file, what, kLargestFile);
  } catch (const std::runtime_error& reason) {
    throw BadFootage(reason.what());
  }
}

std::vector<FrameRow> rows_of_folder(const fs::path& folder) {
  std::vector<FrameRow> rows;
  for (const fs::path& image : images_in(folder)) {
    FrameRow& row = rows.emplace_back();
    row.line = static_cast<int>(rows.size());
    row.image = image.filename().string();
    row.values.fill(std::numeric_limits<double>::quiet_NaN());
  }
  return rows;
}

bool have_times(const std::vector<FrameRow>& rows) { return rows.front().value(FrameColumn::time).has_value(); }

void require_times(const FootageRequest& request, const std::vector<FrameRow>& rows, const fs::path& where) {
  if (request.times_are_given || have_times(rows)) return;
  throw BadFootage(where.string() +
                   ": expected a time for each image (a column time_s), found none; --column time=HEADER names "
                   "another column, --images-per-second does without");
}

std::unique_ptr<FootageSource> open_images(const FootageRequest& request, const fs::path& table,
                                           std::vector<FrameRow> rows, const FootageDecoder& decoder) {
  const fs::path folder = fs::is_directory(request.source) ? request.source : table.parent_path();
  require_times(request, rows, table.empty() ? folder : table);
  if (rows.front().image.empty())
    throw BadFootage(table.string() + ":1: expected a column 'image' with a file for each row, found none");
  const std::string name = table.empty() ? folder.string() : table.string();
  return std::make_unique<TableFootage>(
      name, std::move(rows), request.camera,
      [folder, name, decode = decoder.image](const FrameRow& row, std::size_t, Image& image) {
        const fs::path file = folder / row.image;
        const std::string bytes = read_file(file, "the image of " + name + ":" + std::to_string(row.line));
        image = decode(std::as_bytes(std::span(bytes)), file.string());
        return true;
      });
}

/// The rows of a video without a table: as many as there are frames.
class VideoFootage : public FootageSource {
 public:
  VideoFootage(const FootageRequest& request, std::unique_ptr<FrameReader> video)
      : name_(request.source.string()),
        camera_(request.camera),
        video_(std::move(video)),
        rate_(video_->frames_per_second()) {
    if (rate_ > 0.0) return;
    if (!request.times_are_given)
      throw BadFootage(name_ + ": expected a number of frames a second, found none; set the number of images a second");
    rate_ = 1.0;
  }

  bool next(FootageFrame& frame) override {
    frame = {};
    if (!video_->next(frame.image)) return false;
    frame.time = static_cast<double>(frames_) / rate_;
    frame.name = std::to_string(frames_++);
    frame.camera = camera_of(camera_, frame.image.width(), frame.image.height());
    frame.robot_from_camera.translation().z() = camera_.usual_height;
    return true;
  }

 private:
  std::string name_;
  FootageCamera camera_;
  std::unique_ptr<FrameReader> video_;
  double rate_;
  std::uint64_t frames_ = 0;
};

std::unique_ptr<FootageSource> open_video(const FootageRequest& request, const fs::path& table,
                                          const FootageDecoder& decoder) {
  require_file(request.source, "a folder, a table, a video or a log");
  std::unique_ptr<FrameReader> owned = decoder.video(request.source);
  if (table.empty()) return std::make_unique<VideoFootage>(request, std::move(owned));
  const std::shared_ptr<FrameReader> video = std::move(owned);  // shared, because function objects must be copyable
  std::vector<FrameRow> rows = read_table(table, request.headers);
  if (!have_times(rows) && video->frames_per_second() > 0.0) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].values[static_cast<std::size_t>(FrameColumn::time)] = static_cast<double>(i) / video->frames_per_second();
  }
  require_times(request, rows, table);
  const std::size_t count = rows.size();
  return std::make_unique<TableFootage>(
      table.string(), std::move(rows), request.camera,
      [video, count, name = request.source.string()](const FrameRow&, std::size_t index, Image& image) {
        if (!video->next(image)) return false;
        Image more;
        if (index + 1 == count && video->next(more))
          throw BadFootage(name + ": expected " + std::to_string(count) +
                           " frames, as many as rows of the table, found more");
        return true;
      });
}

}  // namespace

bool is_image_file(const fs::path& file) {
  constexpr const char* kExtensions[] = {".jpg", ".jpeg", ".png", ".webp", ".bmp", ".tif", ".tiff", ".ppm", ".pgm"};
  const std::string extension = extension_of(file);
  return std::any_of(std::begin(kExtensions), std::end(kExtensions), [&](const char* one) { return extension == one; });
}

std::vector<fs::path> images_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> images;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    if (is_image_file(entry->path())) images.push_back(entry->path());
  }
  if (error) throw BadFootage(folder.string() + ": expected a folder that can be read; " + error.message());
  if (images.empty())
    throw BadFootage(folder.string() + ": expected frames.csv or images (JPEG, PNG, ...), found neither");
  std::sort(images.begin(), images.end());
  return images;
}

Image read_image(const fs::path& file, const FootageDecoder& decoder) {
  const std::string bytes = read_file(file, "an image");
  return decoder.image(std::as_bytes(std::span(bytes)), file.string());
}

fs::path table_of(const FootageRequest& request) {
  if (!request.table.empty()) return request.table;
  std::error_code error;
  const bool is_folder = fs::is_directory(request.source, error);
  fs::path usual = is_folder ? request.source / "frames.csv" : request.source;
  if (!is_folder) usual.replace_extension(".csv");
  return fs::exists(usual, error) ? usual : fs::path();
}

std::vector<FrameRow> read_table(const fs::path& table, const ColumnHeaders& headers) {
  const std::string text = read_file(table, "a table");
  const TableHeaders found = read_headers(text, table.string(), headers);
  // Report a probable typing error, which would be ignored otherwise.
  for (const std::string& header : found.unused) {
    if (const std::string meant = did_you_mean(header, found.missing); !meant.empty())
      throw BadFootage(table.string() + ":1: expected a known column, found " + messages::in_quotes(header) + meant +
                       "; --column NAME=HEADER names it, --column NAME= leaves NAME out");
  }
  return parse_frames(text, table.string(), headers);
}

std::vector<std::string> unused_columns(const FootageRequest& request) {
  const fs::path table = table_of(request);
  if (table.empty()) return {};
  return read_headers(read_file(table, "a table"), table.string(), request.headers).unused;
}

std::unique_ptr<FootageSource> open_footage(const FootageRequest& request, const FootageDecoder& decoder) {
  std::error_code error;
  const bool is_folder = fs::is_directory(request.source, error);
  if (!is_folder && !fs::exists(request.source, error))
    throw BadFootage(request.source.string() +
                     ": expected a folder, a table, a video or a log, found nothing of that name");
  const fs::path table = table_of(request);
  if (is_folder && table.empty()) return open_images(request, {}, rows_of_folder(request.source), decoder);
  if (!is_folder && extension_of(request.source) != ".csv") return open_video(request, table, decoder);
  return open_images(request, table, read_table(table, request.headers), decoder);
}

}  // namespace reorient
