// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/access.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <arpa/inet.h>
#include <sys/random.h>

#include "engine/parameters/utf8.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {
namespace {

/// The beginning of a header of a client, for a message.
std::string quoted_header(std::string_view header) { return "'" + as_line(header.substr(0, 80)) + "'"; }

/// The name or address in a header Host, in lower case, without the port and brackets; empty: not of that form.
std::string host_name(std::string_view host) {
  std::string_view name = host, rest;
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return "";
    name = host.substr(1, end - 1);
    rest = host.substr(end + 1);
  } else {
    name = host.substr(0, host.find(':'));
    rest = host.substr(name.size());
  }
  const bool is_port = rest.size() > 1 && rest.size() <= 6 && rest.front() == ':' &&
                       rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (!rest.empty() && !is_port) return "";
  std::string lower(name);
  for (char& letter : lower) letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  return lower;
}

bool is_every_address(std::string_view address) { return address == "0.0.0.0" || address == "::"; }

/// A page of another site can make a browser send requests here under the other site's name (DNS rebinding), but never
/// under an address or under "localhost".
bool is_own_host(const std::string& host, const AccessRules& rules) {
  const std::string name = host_name(host);
  if (name == "localhost" || name == "127.0.0.1" || name == "::1" || name == rules.address) return true;
  return is_every_address(rules.address) && is_numeric_address(name);
}

Access refuse(int code, std::string reason) { return {code, std::move(reason), false, {}}; }

Access decide_viewer(const RequestHead& request, const AccessRules& rules) {
  if (request.path != "/") return refuse(404, "expected a WebSocket at the path /");
  if (choose_subprotocol(request.subprotocols).empty()) {
    return refuse(400, "expected the WebSocket subprotocol " + std::string(kSubprotocols[0]) + " or " +
                           std::string(kSubprotocols[1]) + ", found " + quoted_header(request.subprotocols));
  }
  const std::string_view token = query_field(request.query, "token");
  const bool has_token = is_same_secret(token, rules.token);
  const bool is_foreign = request.origin && !is_own_page(request);
  const auto is_allowed = [&] {
    return std::find(rules.allowed_origins.begin(), rules.allowed_origins.end(), *request.origin) !=
           rules.allowed_origins.end();
  };
  if (!has_token && is_foreign)
    return refuse(403, "a page of " + quoted_header(*request.origin) +
                           " needs the token of the printed link: add ?token=... to the address");
  if (!has_token && !is_loopback(rules.address))
    return refuse(403, "a viewer needs the token of the printed link: add ?token=... to the address");
  if (!has_token) {
    return {0, "", false,
            token.empty() ? "to change something, connect with the token of the printed link: add ?token=..."
                          : "the token is not that of this run; open the link that this run printed"};
  }
  if (is_foreign && !is_allowed())
    return {0, "", false,
            "a page of " + quoted_header(*request.origin) +
                " may only watch; to let it change something, start the run with --live-allow-origin"};
  return {0, "", true, ""};
}

}  // namespace

bool is_own_page(const RequestHead& request) { return request.origin == "http://" + request.host; }

bool is_numeric_address(const std::string& address) {
  std::array<unsigned char, sizeof(in6_addr)> ignored{};
  return inet_pton(AF_INET, address.c_str(), ignored.data()) == 1 ||
         inet_pton(AF_INET6, address.c_str(), ignored.data()) == 1;
}

bool is_loopback(std::string_view address) { return address.starts_with("127.") || address == "::1"; }

std::string_view query_field(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::string_view field = query.substr(0, query.find('&'));
    if (field.size() > name.size() && field.starts_with(name) && field[name.size()] == '=')
      return field.substr(name.size() + 1);
    query.remove_prefix(std::min(field.size() + 1, query.size()));
  }
  return {};
}

bool is_same_secret(std::string_view left, std::string_view right) {
  if (left.size() != right.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    difference |= static_cast<unsigned char>(left[i]) ^ static_cast<unsigned char>(right[i]);
  return difference == 0;
}

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error(std::string("live view: cannot get random numbers: ") + std::strerror(errno));
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string token;
  for (const unsigned char byte : bytes) token.append({kDigits[byte >> 4], kDigits[byte & 15]});
  return token;
}

Access decide(const RequestHead& request, const AccessRules& rules) {
  if (!is_own_host(request.host, rules))
    return refuse(403, "expected an address of this server in the header Host, found " + quoted_header(request.host) +
                           "; open it by its address, for example http://127.0.0.1");
  if (request.method != "GET" && request.method != "HEAD")
    return refuse(405, "expected the method GET, found " + quoted_header(request.method));
  return request.is_websocket ? decide_viewer(request, rules) : Access();
}

}  // namespace reorient::live
