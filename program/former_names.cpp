#include "program/former_names.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include <spdlog/spdlog.h>

#include "engine/script/language/world_fields.h"

namespace reorient {
namespace {

/// Parameters of earlier versions that are not used any more, and the parameter that replaces each.
constexpr std::pair<std::string_view, std::string_view> kFormerParameters[] = {
    {"background_training.asymmetry", "background_training.separability"},
    {"room_status.asymmetry", "room_status.separability"}};

bool has_word(std::string_view text, std::string_view word) {
  const auto is_part = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    if ((at == 0 || !is_part(at - 1)) && !is_part(at + word.size())) return true;
  }
  return false;
}

}  // namespace

bool warn_of_former_name(const ParameterChange& change) {
  const auto* const former = std::find_if(std::begin(kFormerParameters), std::end(kFormerParameters),
                                          [&](const auto& names) { return names.first == change.name; });
  if (former == std::end(kFormerParameters)) return false;
  spdlog::warn("{}parameter '{}' is not used any more: '{}', a probability, took its place",
               change.source.empty() ? "" : change.source + ": ", former->first, former->second);
  return true;
}

std::set<std::string> files_of(const FrameLoop& engine) {
  std::set<std::string> files;
  for (const MachineDefinition* machine : engine.machines()) files.insert(machine->file);
  return files;
}

void warn_of_former_fields(const ScriptTexts& scripts, const std::set<std::string>& files) {
  for (const std::string& file : files) {
    const ScriptText* const script = scripts.find(file);
    if (script == nullptr) continue;
    for (const WorldField& field : world_fields()) {
      if (!field.replacement.empty() && has_word(script->text, field.full_name()))
        spdlog::warn("{}/{}: {} is a former name: use {}", scripts.root(), file, field.full_name(), field.replacement);
    }
  }
}

}  // namespace reorient
