// SPDX-License-Identifier: MIT
#include "program/background_writing.h"

#include <chrono>
#include <exception>
#include <utility>

#include <spdlog/spdlog.h>

namespace reorient {

bool BackgroundWriting::is_busy() const {
  return mistake_.valid() && mistake_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void BackgroundWriting::start(std::function<void()> write) {
  end();
  mistake_ = std::async(std::launch::async, [write = std::move(write)]() -> std::string {
    try {
      write();
      return {};
    } catch (const std::exception& error) {
      return error.what();
    }
  });
}

void BackgroundWriting::end() {
  if (!mistake_.valid()) return;
  if (const std::string mistake = mistake_.get(); !mistake.empty()) spdlog::warn("{}", mistake);
}

}  // namespace reorient
