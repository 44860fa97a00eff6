// SPDX-License-Identifier: MIT
// Records a run: the inputs of its frames, so that they can be replayed, and their records. A frame never waits: it
// adds its data to a bounded queue, and a thread of the recorder packs, writes and flushes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "workbench/recording/frame_entry.h"
#include "workbench/recording/mcap/format.h"
#include "workbench/run/observer.h"

namespace reorient {

struct RecorderOptions {
  std::filesystem::path file;
  /// Interval of recorded camera images in frames. 1: all images, which exact replay needs; 0: no images.
  int images_every = 1;
  double state_every = 60.0;  ///< s between two recorded states of the engine
  int jpeg_quality = 75;      ///< JPEG quality of the images for viewers, 1 to 100; 0: no images
  int particles_every = 6;    ///< frames between two recordings of the pose filter's particles; 0: never
  /// A new file begins after this number of bytes or s of the robot: run.mcap, run.2.mcap, run.3.mcap. 0: never.
  std::uint64_t rotate_bytes = 0;
  double rotate_seconds = 0.0;
  std::size_t most_waiting = std::size_t{96} << 20;  ///< most bytes in the queue; above it the recording ends
  double patience = 10.0;                            ///< s that end() waits for the disk
  mcap::Texts about;                                 ///< description of the run: scenario, seed, version
  ApplicationInterface application{};                ///< of the run; viewers learn the types of its values
};

class Recorder : public Observer {
 public:
  struct Counts {
    std::uint64_t frames = 0;           ///< in all files so far
    std::uint64_t images_left_out = 0;  ///< frames without exact images because the disk was slow
    std::uint64_t views_left_out = 0;   ///< frames without images for viewers because the disk was slow
    std::uint64_t bytes = 0;            ///< of all files so far
    int files = 1;
    double exact_until = -1.0;  ///< s of the robot; later frames cannot be replayed exactly; -1: all can
  };

  /// Creates the file. `tell` is called on the thread of the frames with one line for the user. Throws
  /// std::runtime_error with one line.
  Recorder(RecorderOptions options, std::function<void(const std::string&)> tell);
  ~Recorder() override;

  void before(const FrameInputs& inputs, const FrameLoop& engine) override;
  Topics wanted() const override { return wanted_; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// Waits until the thread has at most an eighth of RecorderOptions::most_waiting to write, or for `seconds`. Returns
  /// false in the latter case. Only for robots that have no real time, between their frames.
  bool wait_for_thread(double seconds);

  /// Ends the file. Nothing is recorded afterwards. If the disk does not accept the rest within
  /// RecorderOptions::patience, the thread is detached.
  void end();

  Counts counts() const;

 private:
  struct Item;
  /// Data of both threads, owned by both. The thread uses nothing else except constants that are never destroyed,
  /// because a thread that waits for a disk may outlive the recorder and even main().
  struct Shared;

  void choose_views(const Item& item);
  void report_trouble();
  static void write_items(Shared& shared);

  const RecorderOptions options_;
  const std::function<void(const std::string&)> report_;
  std::shared_ptr<Shared> shared_;

  std::unique_ptr<Item> item_;                  // item that is being filled
  double next_state_ = 0.0, file_began_ = 0.0;  // s of the robot
  Topics wanted_;
  std::uint64_t frames_ = 0;  // recorded
  int files_begun_ = 1;
  bool is_broken_ = false;  // an image is missing since the last state
  bool has_reported_ = false, reported_slow_ = false, reported_missing_views_ = false;

  std::thread thread_;
};

}  // namespace reorient
