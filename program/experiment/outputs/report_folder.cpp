// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/report_folder.h"

#include <array>
#include <ctime>
#include <fstream>
#include <thread>

#include <spdlog/fmt/fmt.h>

#include "program/experiment/outputs/rows_report.h"
#include "program/experiment/outputs/trials_json.h"
#include "workbench/experiments/report/page.h"
#include "workbench/experiments/report/trials_csv.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

/// The processor's name in the kernel.
std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  gmtime_r(&now, &parts);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts)};
}

}  // namespace

Provenance provenance_here(const std::string& command) {
  return {command, REORIENT_VERSION, fmt::format("{}, {} cores", processor_name(), std::thread::hardware_concurrency()),
          time_now()};
}

std::vector<std::string> write_report(const Report& report, const std::filesystem::path& folder) {
  std::vector<std::string> failures;
  const auto write = [&](const char* file, auto&& text) {
    try_to_write(failures, [&] { write_whole_file(folder / file, text()); });
  };
  write("rows.json", [&] { return rows_as_json(report.experiment, report.cells); });
  write("trials.json", [&] { return trials_as_json(report.experiment, report.cells); });
  write("trials.csv", [&] { return trials_as_csv(report); });
  write("index.html", [&] { return report_page(report); });
  return failures;
}

}  // namespace reorient
