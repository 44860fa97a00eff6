// SPDX-License-Identifier: MIT
// Loaded before the C library (LD_PRELOAD): writes into the file that REORIENT_SYNC_REPORT names how often a recording
// was flushed to the disk, for how long at most, s, bytes of it had been written and not flushed, and how many are so
// now.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

double oldest = 0.0;   // time of the oldest byte that is not flushed
double longest = 0.0;  // s
long flushed = 0;      // times
long behind = 0;       // bytes

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool is_recording(int descriptor) {
  char link[64], name[4096];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, name, sizeof name);
  return length > 0 && std::string_view(name, static_cast<std::size_t>(length)).ends_with(".mcap");
}

void report() {
  const char* const name = std::getenv("REORIENT_SYNC_REPORT");
  if (name == nullptr) return;
  char text[100];
  const int length = std::snprintf(text, sizeof text, "%ld %f %ld\n", flushed, longest, behind);
  const int file = open(name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return;
  if (syscall(SYS_write, file, text, static_cast<std::size_t>(length)) != length) std::abort();
  close(file);
}

}  // namespace

extern "C" ssize_t write(int fd, const void* buf, std::size_t n) {
  const ssize_t written = syscall(SYS_write, fd, buf, n);
  if (written > 0 && is_recording(fd)) {
    if (behind == 0) oldest = now();
    behind += written;
    report();
  }
  return written;
}

extern "C" int fdatasync(int fildes) {
  const int result = static_cast<int>(syscall(SYS_fdatasync, fildes));
  if (result == 0 && is_recording(fildes)) {
    if (behind > 0) longest = std::max(longest, now() - oldest);
    behind = 0;
    ++flushed;
    report();
  }
  return result;
}
