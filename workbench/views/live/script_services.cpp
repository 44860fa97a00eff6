// SPDX-License-Identifier: MIT
#include "workbench/views/live/script_services.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/check/script_check.h"
#include "workbench/views/live/protocol/client_json.h"

namespace reorient::live {
namespace {

using ScriptJson = nlohmann::ordered_json;

constexpr std::size_t kMostFindings = 200;
constexpr std::size_t kLongestFinding = 1000;  // bytes

std::string json_text(const ScriptJson& json) {
  return json.dump(-1, ' ', false, ScriptJson::error_handler_t::replace);
}

bool is_test(const std::string& file) { return file.starts_with("tests/"); }

[[noreturn]] void unknown_script(const std::string& name, const std::vector<std::string>& known) {
  const std::string begin = name.substr(0, 100);
  throw std::runtime_error("unknown script '" + as_line(begin) + "'" + did_you_mean(begin, known));
}

std::vector<std::string> listed_files(const std::filesystem::path& root, const ScriptTexts& scripts) {
  std::vector<std::string> files = scripts.files();
  for (std::string& test : scripted_tests(root)) files.push_back(std::move(test));
  std::sort(files.begin(), files.end());
  return files;
}

/// Only a name from the list, so no path leads out of the folder.
void require_listed(const std::string& file, const std::filesystem::path& root, const ScriptTexts& scripts) {
  const std::vector<std::string> files = listed_files(root, scripts);
  if (!std::binary_search(files.begin(), files.end(), file)) unknown_script(file, files);
}

/// The text of a listed file.
std::string text_on_disk(const std::filesystem::path& root, const std::string& file) {
  const std::optional<ScriptText> text = read_script(root, file);
  if (!text) throw std::runtime_error(file + ": expected a script, found none");
  if (!text->problem.empty()) throw std::runtime_error(as_line(file + ": " + text->problem));
  return text->text;
}

std::string requested_text(const ClientObject& request, const char* service) {
  std::string text = request.text("text");
  if (text.size() > kLargestScript)
    throw BadClientMessage(std::string(service) + ": text: expected at most " + std::to_string(kLargestScript) +
                           " bytes, found " + std::to_string(text.size()));
  return text;
}

/// Throws if a viewer may not write the listed file.
void require_writable_script(const std::filesystem::path& root, const std::string& file) {
  constexpr std::array<std::string_view, 4> kFolders{"behaviors/", "scenarios/", "lib/", "tests/"};
  if (std::none_of(kFolders.begin(), kFolders.end(), [&](std::string_view folder) { return file.starts_with(folder); }))
    throw std::runtime_error(
        as_line("save_script: expected a file below behaviors/, scenarios/, lib/ or tests/, found " + file));
  if (!is_below(root, root / file))
    throw std::runtime_error(
        as_line("save_script: " + file + ": expected a file of this folder, found a link that leads out of it"));
}

}  // namespace

std::optional<std::string> ScriptServices::answer(Service service, const std::string& payload) const {
  switch (service) {
    case Service::scripts:
      return list();
    case Service::script:
      return read(payload);
    case Service::check_script:
      return check(payload);
    case Service::save_script:
      return save(payload);
    default:
      return std::nullopt;
  }
}

std::string ScriptServices::list() const { return json_text({{"files", listed_files(root_, read_scripts(root_))}}); }

std::string ScriptServices::read(const std::string& payload) const {
  const std::string file = ClientObject("script", payload).text("file");
  require_listed(file, root_, read_scripts(root_));
  return json_text({{"file", file}, {"text", as_utf8(text_on_disk(root_, file))}});
}

std::string ScriptServices::check(const std::string& payload) const {
  const ClientObject request("check_script", payload);
  const std::string file = request.text("file");
  const ScriptText text{requested_text(request, "check_script"), ""};
  const std::unique_lock lock(checking_, std::try_to_lock);
  if (!lock) throw std::runtime_error("check_script: another check is running; try again");
  TextsToCheck texts{.scripts = read_scripts(root_), .interfaces = known_interfaces(root_)};
  require_listed(file, root_, texts.scripts);
  if (is_test(file)) {
    texts.tests[file] = text;
  } else {
    texts.scripts.apply({file, text});
  }
  ScriptJson findings = ScriptJson::array();
  for (const Finding& finding : check_texts(std::move(texts)).findings) {
    if (finding.file != file || findings.size() == kMostFindings) continue;
    findings.push_back({{"file", finding.file},
                        {"line", finding.position.line},
                        {"column", finding.position.column},
                        {"severity", finding.severity == Finding::Severity::error ? "error" : "warning"},
                        {"message", as_line(finding.message.substr(0, kLongestFinding))}});
  }
  return json_text({{"findings", std::move(findings)}});
}

std::string ScriptServices::save(const std::string& payload) const {
  const ClientObject request("save_script", payload);
  const std::string file = request.text("file");
  const std::string text = requested_text(request, "save_script");
  const std::string expected = request.text("expected");
  const std::lock_guard lock(saving_);
  require_listed(file, root_, read_scripts(root_));
  require_writable_script(root_, file);
  const std::string before = text_on_disk(root_, file);
  if (!is_utf8(before))
    throw std::runtime_error("save_script: " + file + ": expected UTF-8 on the disk, found other bytes");
  const bool is_expected = before == expected;
  if (is_expected) write_whole_file(root_ / file, text);
  return json_text({{"file", file}, {"saved", is_expected}, {"text", is_expected ? text : before}});
}

FrameTask ScriptServices::reload(const std::string& payload) const {
  const std::string name = ClientObject("reload", payload.empty() ? "{}" : payload).text_or_empty("script");
  const ScriptTexts texts = read_scripts(root_);
  ReloadScripts reload{reloads_of(texts, name)};
  if (reload.edits.empty()) unknown_script(name, texts.files());
  return reload;
}

}  // namespace reorient::live
