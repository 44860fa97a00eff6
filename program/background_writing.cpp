// SPDX-License-Identifier: MIT
#include "program/background_writing.h"

#include <chrono>
#include <exception>
#include <utility>

#include <spdlog/spdlog.h>

namespace reorient {

bool BackgroundWriting::is_busy() const {
  return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void BackgroundWriting::start(std::function<void()> write) {
  end();
  writing_ = std::async(std::launch::async, [write = std::move(write)]() -> std::string {
    try {
      write();
      return {};
    } catch (const std::exception& error) {
      return error.what();
    }
  });
}

std::string BackgroundWriting::mistake() { return writing_.valid() ? writing_.get() : std::string(); }

void BackgroundWriting::end() {
  if (const std::string error = mistake(); !error.empty()) spdlog::warn("{}", error);
}

}  // namespace reorient
