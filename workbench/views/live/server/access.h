// SPDX-License-Identifier: MIT
// Who may watch a run, and who may change it. Decided for each request from its head, without sockets.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reorient::live {

/// The head of a request, as the client sent it.
struct RequestHead {
  std::string method, path, query;
  std::string host;                   ///< header Host; empty: missing
  std::optional<std::string> origin;  ///< header Origin: browsers send it for a WebSocket, other programs do not
  bool is_websocket = false;
  std::string subprotocols;  ///< header Sec-WebSocket-Protocol
};

struct AccessRules {
  std::string address = "127.0.0.1";         ///< at which the server listens, as a number; 0.0.0.0 or ::: all
  std::string token;                         ///< of the link, not empty
  std::vector<std::string> allowed_origins;  ///< "http://lab.example:8080": other pages that may change things
};

/// The decision about a request.
struct Access {
  int refusal = 0;       ///< status code of HTTP; 0: accepted
  std::string reason;    ///< of a refusal: one line that says what to do
  bool changes = false;  ///< the viewer may change the run
  std::string why_not;   ///< if not: one line that says what to do
};

Access decide(const RequestHead& request, const AccessRules& rules);

/// Whether the request is of a page that the same server served.
bool is_own_page(const RequestHead& request);

/// 128 random bits of the operating system, as 32 hexadecimal digits. Throws std::runtime_error.
std::string make_token();

/// Takes the same time wherever two texts of the same length differ.
bool is_same_secret(std::string_view left, std::string_view right);

/// The value of a field of a query "a=1&token=..."; empty if it is missing.
std::string_view query_field(std::string_view query, std::string_view name);

bool is_loopback(std::string_view address);
/// Whether it is an IPv4 or IPv6 address, without brackets.
bool is_numeric_address(const std::string& address);

}  // namespace reorient::live
