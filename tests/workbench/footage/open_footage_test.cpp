// SPDX-License-Identifier: MIT
// Footage from a disk, with arbitrary contents of the folder. The decoder is one for tests: an image is a line "WIDTH
// HEIGHT LUMA".
#include "workbench/footage/open_footage.h"

#include <cstring>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/temporary_folder.h"
#include "workbench/footage/decoder_library.h"

namespace reorient {
namespace {

Image plain(int width, int height, int luma) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) std::memset(image.row(y), luma, static_cast<std::size_t>(2 * width));
  return image;
}

Image decode_line(std::span<const std::byte> bytes, const std::string& where) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  int width = 0, height = 0, luma = 0;
  if (!(in >> width >> height >> luma)) throw BadFootage(where + ": expected an image");
  return plain(width, height, luma);
}

/// So many frames of 16x8 pixels, ten a second.
class Frames : public FrameReader {
 public:
  explicit Frames(int count) : count_(count) {}
  bool next(Image& image) override {
    if (next_ == count_) return false;
    image = plain(16, 8, next_++);
    return true;
  }
  double frames_per_second() const override { return 10.0; }

 private:
  int count_, next_ = 0;
};

class OpenFootage : public ::testing::Test {
 protected:
  std::unique_ptr<FootageSource> open(const std::filesystem::path& source,
                                      const std::function<void(FootageRequest&)>& change = {}) const {
    FootageRequest request;
    request.source = source;
    if (change) change(request);
    return open_footage(request, {decode_line, [this](const std::filesystem::path&) {
                                    return std::make_unique<Frames>(video_frames_);
                                  }});
  }

  /// All frames, and the reason of an early end.
  std::pair<std::vector<FootageFrame>, std::string> read(
      const std::filesystem::path& source, const std::function<void(FootageRequest&)>& change = {}) const {
    std::vector<FootageFrame> frames;
    try {
      const auto footage = open(source, change);
      for (FootageFrame frame; footage->next(frame);) frames.push_back(frame);
    } catch (const BadFootage& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return {std::move(frames), error.what()};
    }
    return {std::move(frames), ""};
  }

  void expect_refused(const std::string& refusal, const std::string& part) const {
    EXPECT_NE(refusal.find(part), std::string::npos) << refusal << "\nexpected: " << part;
  }

  std::filesystem::path folder() const { return folder_.path(); }

  TemporaryFolder folder_;
  int video_frames_ = 3;
};

TEST_F(OpenFootage, IsAFolderWithATable) {
  folder_.write("images/a.jpg", "16 8 1");
  folder_.write("images/b.jpg", "16 8 2");
  folder_.write("frames.csv", "image,time_s,x_m,y_m,rotation_rad\nimages/a.jpg,1,0,0,0\nimages/b.jpg,2,1,0,0\n");
  const auto [frames, failure] = read(folder());
  EXPECT_EQ(failure, "");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].image.view().luma(3, 3), 2);
  EXPECT_EQ(frames[1].time, 2.0);
  EXPECT_EQ(frames[1].pose->position.x(), 1.0);
  EXPECT_EQ(frames[1].camera.width, 16);
}

TEST_F(OpenFootage, IsAFolderOfImagesInOrderOfNameIfItsTimesAreGiven) {
  folder_.write("2.png", "16 8 2");
  folder_.write("1.PNG", "16 8 1");
  folder_.write("notes.txt", "none");
  const auto [frames, failure] = read(folder(), [](FootageRequest& request) { request.times_are_given = true; });
  EXPECT_EQ(failure, "");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].name, "1.PNG");
  EXPECT_FALSE(frames[0].pose);
  expect_refused(read(folder()).second, "expected a time for each image");
}

TEST_F(OpenFootage, IsATableAlone) {
  folder_.write("a.jpg", "16 8 1");
  const auto table = folder_.write("other.csv", "image,time_s\na.jpg,1\n");
  EXPECT_EQ(read(table).first.size(), 1u);
}

TEST_F(OpenFootage, IsAVideoWithOrWithoutATable) {
  const auto video = folder_.write("walk.mkv", "video");
  {
    const auto [frames, failure] = read(video);
    EXPECT_EQ(failure, "");
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_DOUBLE_EQ(frames[2].time, 0.2);
  }
  folder_.write("walk.csv", "x_m,y_m,rotation_rad\n0,0,0\n1,0,0\n2,0,0\n");
  const auto [frames, failure] = read(video);
  EXPECT_EQ(failure, "");
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_DOUBLE_EQ(frames[2].time, 0.2);
  EXPECT_EQ(frames[2].pose->position.x(), 2.0);
}

TEST_F(OpenFootage, ReportsWhereAVideoAndItsTableDiffer) {
  const auto video = folder_.write("walk.mkv", "video");
  folder_.write("walk.csv", "time_s\n0\n1\n2\n3\n");
  {
    const auto [frames, failure] = read(video);
    EXPECT_EQ(frames.size(), 3u);
    expect_refused(failure, "walk.csv:5: expected an image for each of 4 rows, found 3");
  }
  folder_.write("walk.csv", "time_s\n0\n1\n");
  const auto [frames, failure] = read(video);
  expect_refused(failure, "walk.mkv: expected 2 frames, as many as rows of the table, found more");
}

TEST_F(OpenFootage, KeepsTheFramesBeforeAMissingImage) {
  folder_.write("a.jpg", "16 8 1");
  folder_.write("frames.csv", "image,time_s\na.jpg,1\nb.jpg,2\n");
  const auto [frames, failure] = read(folder());
  EXPECT_EQ(frames.size(), 1u);
  expect_refused(failure, "b.jpg: expected the image of ");
  expect_refused(failure, "frames.csv:3, found nothing of that name");
}

TEST_F(OpenFootage, KeepsTheFramesBeforeAnImageOfAnotherSize) {
  folder_.write("a.jpg", "16 8 1");
  folder_.write("b.jpg", "32 8 1");
  folder_.write("frames.csv", "image,time_s\na.jpg,1\nb.jpg,2\n");
  const auto [frames, failure] = read(folder());
  EXPECT_EQ(frames.size(), 1u);
  expect_refused(failure, "frames.csv:3: expected an image of 16x8 pixels, as the first one, found 32x8");
}

TEST_F(OpenFootage, DoesNotWaitForAPipe) {
  ASSERT_EQ(mkfifo((folder() / "pipe.jpg").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder() / "pipe.csv").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder() / "pipe.mkv").c_str(), 0600), 0);
  folder_.write("frames.csv", "image,time_s\npipe.jpg,1\n");
  for (const char* const name : {"", "pipe.csv", "pipe.mkv"})
    expect_refused(read(folder() / name).second, "found something that is not a regular file");
}

TEST_F(OpenFootage, DoesNotReadAFileThatIsTooLarge) {
  const std::filesystem::path table = folder_.write("frames.csv", "image,time_s\n");
  std::filesystem::resize_file(table, std::uintmax_t{1} << 40);  // a hole
  expect_refused(read(table).second,
                 "frames.csv: expected a table of at most 256 MiB, found a larger one (1048576 MiB)");
}

TEST_F(OpenFootage, ReportsWhatIsMissing) {
  expect_refused(read(folder() / "nothing").second, "found nothing of that name");
  expect_refused(read(folder()).second, "expected frames.csv or images (JPEG, PNG, ...), found neither");
  folder_.write("a.jpg", "16 8 1");
  expect_refused(read(folder(), [&](FootageRequest& request) { request.table = folder() / "other.csv"; }).second,
                 "other.csv: expected a table, found nothing of that name");
  folder_.write("frames.csv", "time_s\n1\n");
  expect_refused(read(folder()).second, "frames.csv:1: expected a column 'image'");
}

TEST(DecoderLibrary, NamesTheMissingPackages) {
  setenv("REORIENT_DECODER", "/nowhere/reorient_decoder.so", 1);
  try {
    decoder_library().image({}, "a.jpg");
    FAIL();
  } catch (const BadFootage& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("libopencv-imgcodecs-dev and libopencv-videoio-dev"), std::string::npos) << what;
    EXPECT_NE(what.find("/nowhere/reorient_decoder.so"), std::string::npos) << what;
  }
  unsetenv("REORIENT_DECODER");
}

TEST(FootageCamera, IsCutAboveAndBelowWhereTheImageHasAnotherShape) {
  FootageCamera camera;  // 640x480, 56.3 x 43.7 degrees
  const CameraModel same = camera_of(camera, 320, 240);
  EXPECT_NEAR(same.focal.y(),
              CameraModel::from_fields_of_view(320, 240, camera.optics.field_of_view_horizontal,
                                               camera.optics.field_of_view_vertical)
                  .focal.y(),
              1e-9);
  const CameraModel wide = camera_of(camera, 640, 360);
  EXPECT_EQ(wide.focal, CameraModel::from_fields_of_view(640, 480, camera.optics.field_of_view_horizontal,
                                                         camera.optics.field_of_view_vertical)
                            .focal);
  EXPECT_EQ(wide.center.y(), 179.5);
}

}  // namespace
}  // namespace reorient
