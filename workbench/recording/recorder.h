// SPDX-License-Identifier: MIT
// Records a run: whatever decides its frames, so that they can be made again, and what came of them. The frame waits
// for nothing: it fills a place in a bounded queue, and a thread of the recorder's own packs, writes and flushes.
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
  /// Every how many frames the cameras' images are recorded: 1: all, so that frames can be made again; 0: none.
  int images_every = 1;
  double state_every = 60.0;  ///< s between two states of the engine
  int jpeg_quality = 75;      ///< of the images for viewing only, 1 to 100; 0: none
  int particles_every = 6;    ///< frames between two looks at the pose filter's particles; 0: none
  /// A new file begins after so many bytes or s of the robot: run.mcap, run.2.mcap, run.3.mcap. 0: never.
  std::uint64_t rotate_bytes = 0;
  double rotate_seconds = 0.0;
  std::size_t most_waiting = std::size_t{96} << 20;  ///< bytes in the queue; beyond them the recording ends
  double patience = 10.0;                            ///< s that end() waits for the disk
  mcap::Texts about;                                 ///< the run, for people: scenario, seed, version
};

class Recorder : public Observer {
 public:
  struct Counts {
    std::uint64_t frames = 0;           ///< in the files, so far
    std::uint64_t images_left_out = 0;  ///< as the disk was slow: frames whose exact images are not there
    std::uint64_t views_left_out = 0;   ///< the same, frames whose images to look at are not there
    std::uint64_t bytes = 0;            ///< of all files, so far
    int files = 1;
    double exact_until = -1.0;  ///< s of the robot; frames from there on cannot be made again; -1: all can
  };

  /// Makes the file. `tell`: one line to the person who records, on the thread of the frames. Throws std::runtime_error
  /// with one line.
  Recorder(RecorderOptions options, std::function<void(const std::string&)> tell);
  ~Recorder() override;

  void before(const FrameInputs& inputs, const FrameLoop& engine) override;
  Topics wanted() const override { return wanted_; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// Ends the file. Nothing is recorded afterwards. The thread of a disk that does not take the rest within
  /// RecorderOptions::patience is left behind.
  void end();

  Counts counts() const;

 private:
  struct Item;
  /// What both threads use. The thread owns it, too, and touches nothing else but constants that are never destroyed:
  /// one that waits for a disk that does not answer may outlive the recorder, and even main().
  struct Shared;

  void choose_views(const Item& item);
  void tell_trouble();
  static void write_items(Shared& shared);

  const RecorderOptions options_;
  const std::function<void(const std::string&)> tell_;
  std::shared_ptr<Shared> shared_;

  std::unique_ptr<Item> item_;                  // that is being filled
  double next_state_ = 0.0, file_began_ = 0.0;  // s of the robot
  Topics wanted_;
  std::uint64_t frames_ = 0;  // recorded
  int files_begun_ = 1;
  bool is_broken_ = false;  // an image is missing since the last state
  bool told_ = false, told_slow_ = false, told_no_views_ = false;

  std::thread thread_;
};

}  // namespace reorient
