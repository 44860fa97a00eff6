// SPDX-License-Identifier: MIT
// JSON of clients, with messages that say what was expected and what was found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace reorient::live {

/// An object of a client. All functions throw BadClientMessage; `what` of the constructor names the message.
class ClientObject {
 public:
  ClientObject(std::string what, std::string_view text);

  const nlohmann::json& json() const { return json_; }
  /// Throws if the member is missing or no text.
  std::string text(const char* name) const;
  /// An empty text if it is missing.
  std::string text_or_empty(const char* name) const;
  std::optional<std::string> optional_text(const char* name) const;
  std::vector<std::string> texts(const char* name) const;
  std::uint32_t number(const char* name) const;
  /// A finite number that need not be whole; nothing if it is missing.
  std::optional<double> optional_real(const char* name) const;
  std::optional<bool> optional_boolean(const char* name) const;
  std::vector<std::uint32_t> numbers(const char* name) const;
  /// The members of an array, which must be objects.
  std::vector<ClientObject> objects(const char* name) const;

 private:
  struct Parsed {};
  ClientObject(Parsed /*tag*/, std::string what, nlohmann::json json)
      : what_(std::move(what)), json_(std::move(json)) {}
  const nlohmann::json& member(const char* name) const;
  const nlohmann::json& array(const char* name) const;
  [[noreturn]] void refuse(const std::string& where, const char* expected, const nlohmann::json& found) const;
  std::uint32_t number_of(const std::string& where, const nlohmann::json& value) const;

  std::string what_;
  nlohmann::json json_;
};

}  // namespace reorient::live
