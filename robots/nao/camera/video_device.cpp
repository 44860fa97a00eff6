// SPDX-License-Identifier: MIT
#include "robots/nao/camera/video_device.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace reorient::nao {

SystemVideoDevice::~SystemVideoDevice() { close(); }

bool SystemVideoDevice::open(const std::string& path) {
  close();
  descriptor_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  struct stat status {};
  if (descriptor_ >= 0 && (fstat(descriptor_, &status) != 0 || !S_ISCHR(status.st_mode))) close();
  return descriptor_ >= 0;
}

void SystemVideoDevice::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

int SystemVideoDevice::control(unsigned long request, void* argument) {
  while (true) {
    if (ioctl(descriptor_, request, argument) == 0) return 0;
    if (errno != EINTR) return errno;
  }
}

void* SystemVideoDevice::map(std::size_t length, std::int64_t offset) {
  void* const address = mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, offset);
  return address == MAP_FAILED ? nullptr : address;
}

void SystemVideoDevice::unmap(void* address, std::size_t length) { munmap(address, length); }

}  // namespace reorient::nao
