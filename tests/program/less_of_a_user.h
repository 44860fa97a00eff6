// SPDX-License-Identifier: MIT
// Restricts a child program before it starts: fewer permissions, a small disk.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/paths.h"

namespace reorient {

inline constexpr int kCannot = 77;  // exit code of a child that may not do what the test needs

/// Runs in the child: drops the permissions of root, if possible.
inline void become_an_ordinary_user() {
  constexpr uid_t kPlainUser = 65534;
  if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(kPlainUser) != 0 || setuid(kPlainUser) != 0))
    _exit(kCannot);
  prctl(PR_SET_DUMPABLE, 1);  // otherwise its files in /proc stay owned by root
  if (access(kProgram, X_OK) != 0 || access((std::string(kSourceFolder) + "/scripts").c_str(), R_OK) != 0)
    _exit(kCannot);
}

/// Writes to a file of /proc; ends the child if that is not permitted.
inline void tell_the_kernel(const char* file, const std::string& text) {
  const int descriptor = open(file, O_WRONLY);
  if (descriptor < 0 || write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    _exit(kCannot);
  close(descriptor);
}

/// Runs in the child: mounts a private disk at `folder`. What is left on it
/// when the program has ended is copied to `kept`. `size`: as mount takes it.
inline void put_a_small_disk(const std::filesystem::path& folder, const std::filesystem::path& kept, const char* size) {
  const std::string user = std::to_string(geteuid()), group = std::to_string(getegid());
  if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) _exit(kCannot);
  tell_the_kernel("/proc/self/setgroups", "deny");
  tell_the_kernel("/proc/self/uid_map", "0 " + user + " 1");
  tell_the_kernel("/proc/self/gid_map", "0 " + group + " 1");
  if (mount("small", folder.c_str(), "tmpfs", 0, (std::string("size=") + size).c_str()) != 0) _exit(kCannot);
  const pid_t program = fork();
  if (program == 0) return;
  int status = 0;
  waitpid(program, &status, 0);
  std::error_code failed;
  std::filesystem::copy(folder, kept, std::filesystem::copy_options::recursive, failed);
  _exit(WIFEXITED(status) && !failed ? WEXITSTATUS(status) : kCannot);
}

}  // namespace reorient
