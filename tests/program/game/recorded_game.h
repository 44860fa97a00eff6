// SPDX-License-Identifier: MIT
// A short game whose robots are recorded.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {

inline const std::vector<std::string> kBothTeams{"blue_1", "blue_2", "red_1", "red_2"};

class GameThatIsRecorded : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string recording_of(const std::string& robot) const { return path("game/" + robot + ".mcap"); }

  /// A short game, by default two against two for 2 s, with more options at the end.
  static std::vector<std::string> words(const std::vector<std::string>& more, const char* seconds = "2",
                                        const char* robots = "2") {
    std::vector<std::string> all{"game", "--robots", robots, "--seconds", seconds, "--log", "off"};
    for (const char* const time : {"match.initial_time=0.2", "match.ready_time=0.5", "match.set_time=0.3"})
      all.insert(all.end(), {"--set", time});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  ProgramRun record(const std::vector<std::string>& more = {}, const char* seconds = "2",
                    const char* robots = "2") const {
    std::vector<std::string> all = words({"--record", path("game")}, seconds, robots);
    all.insert(all.end(), more.begin(), more.end());
    return run_reorient(all);
  }

  TemporaryFolder folder_;
};

}  // namespace reorient
