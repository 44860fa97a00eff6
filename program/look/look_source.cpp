// SPDX-License-Identifier: MIT
#include "program/look/look_source.h"

#include <utility>

#include "workbench/footage/decoder_library.h"
#include "workbench/footage/open_footage.h"

namespace reorient {
namespace {

class ImageFiles : public LookSource {
 public:
  ImageFiles(std::vector<std::filesystem::path> files, const FootageCamera& camera)
      : files_(std::move(files)), camera_(camera), decoder_(decoder_library()) {}

  bool next(LookImage& image) override {
    if (next_ == files_.size()) return false;
    const std::filesystem::path& file = files_[next_++];
    image = {};
    image.file = file.string();
    FootageFrame& frame = image.frame;
    frame.name = file.filename().string();
    frame.image = read_image(file, decoder_);
    frame.camera = camera_of(camera_, frame.image.width(), frame.image.height());
    frame.robot_from_camera.translation().z() = camera_.usual_height;
    return true;
  }

 private:
  std::vector<std::filesystem::path> files_;
  FootageCamera camera_;
  FootageDecoder decoder_;
  std::size_t next_ = 0;
};

/// Logs and recordings contain the poses of their cameras; rows of tables may contain them.
class ImagesOfFootage : public LookSource {
 public:
  ImagesOfFootage(std::string file, std::unique_ptr<FootageSource> source, bool is_log, std::vector<FrameRow> rows)
      : file_(std::move(file)), source_(std::move(source)), is_log_(is_log), rows_(std::move(rows)) {}

  bool next(LookImage& image) override {
    image.file = file_;
    if (!source_->next(image.frame)) return false;
    const FrameRow* const row = next_ < rows_.size() ? &rows_[next_] : nullptr;
    image.pitch_is_known = is_log_ || (row != nullptr && row->value(FrameColumn::pitch));
    image.roll_is_known = is_log_ || (row != nullptr && row->value(FrameColumn::roll));
    image.height_is_known = is_log_ || (row != nullptr && row->value(FrameColumn::camera_height));
    ++next_;
    return true;
  }

 private:
  std::string file_;
  std::unique_ptr<FootageSource> source_;
  bool is_log_;
  std::vector<FrameRow> rows_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<LookSource> open_look_source(const std::vector<std::filesystem::path>& sources,
                                             FootageArguments arguments, const RobotBody& body) {
  std::error_code error;
  if (sources.size() > 1) {
    for (const std::filesystem::path& source : sources) {
      if (!is_image_file(source))
        throw BadFootage(source.string() +
                         ": expected an image (JPEG, PNG, ...), since several files are named, found "
                         "another file; name a folder, a video or a log alone");
    }
    return std::make_unique<ImageFiles>(sources, camera_of(arguments, body));
  }
  const std::filesystem::path& source = sources.front();
  if (is_image_file(source) && !std::filesystem::is_directory(source, error))
    return std::make_unique<ImageFiles>(sources, camera_of(arguments, body));
  if (!arguments.images_per_second)
    arguments.images_per_second = 1.0;  // times are not used, so a table need not have them
  const bool is_log = source.extension() == ".mcap";
  std::vector<FrameRow> rows;
  if (!is_log) {
    const FootageRequest request = request_of(source, arguments, body);
    const std::filesystem::path table = table_of(request);
    if (table.empty() && std::filesystem::is_directory(source, error))
      return std::make_unique<ImageFiles>(images_in(source), request.camera);
    if (!table.empty() && std::filesystem::exists(source, error)) rows = read_table(table, request.headers);
  }
  return std::make_unique<ImagesOfFootage>(source.string(), open_footage(source, arguments, body), is_log,
                                           std::move(rows));
}

}  // namespace reorient
