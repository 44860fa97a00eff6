// SPDX-License-Identifier: MIT
// A folder with tools of this project and programs that replace those of the system.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/wait.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {

class ToolTree {
 public:
  /// Copies a file of the project to the same path in this folder.
  void copy(const std::filesystem::path& file) const {
    std::filesystem::create_directories((folder.path() / file).parent_path());
    std::filesystem::copy(std::filesystem::path(kSourceFolder) / file, folder.path() / file);
  }

  /// Adds a program to the search path, given as the text of a shell script.
  void write_program(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder.write("bin/" + name, "#!/bin/sh\n" + text + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

  struct Result {
    int code;
    std::string text;  // standard output and error
  };
  /// Runs a line of bash at the top of the folder.
  Result run(const std::string& line) const {
    const std::filesystem::path script = folder.write("line", line);
    const std::string command = "cd '" + folder.path().string() + "' && PATH=\"$PWD/bin:$PATH\" bash -euo pipefail '" +
                                script.string() + "' 2>&1";
    Result result{};
    FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 256> buffer;
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) result.text += buffer.data();
    result.code = WEXITSTATUS(pclose(pipe));
    return result;
  }

  TemporaryFolder folder;
};

}  // namespace reorient
