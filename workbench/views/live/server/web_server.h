// SPDX-License-Identifier: MIT
// The web server of a run: the page, and one WebSocket for each viewer. civetweb reads requests and does the handshake;
// then this class reads and writes the connection, with bounded messages.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "workbench/views/live/server/access.h"
#include "workbench/views/live/server/viewer_mailbox.h"

namespace reorient::live {

/// One viewer, as the rest of the program knows it. Its functions are called on the viewer's own thread, one at a time.
class ViewerSession {
 public:
  virtual ~ViewerSession() = default;
  virtual void receive_text(std::string_view text) = 0;
  virtual void receive_binary(std::span<const std::byte> bytes) = 0;
};

struct ServedFile {
  std::string_view type, text;
  std::string_view gzip{};  ///< the same text, compressed; empty: not compressed
};

struct WebServerOptions {
  std::string address = "127.0.0.1";  ///< as a number
  int port = 8765;                    ///< 0: a free one
  std::vector<std::string> allowed_origins{};
  std::string token{};
  int most_viewers = 32;
  ViewerMailbox::Limits mailbox{};
};

class WebServer {
 public:
  /// Called for a new viewer, whose messages are added to the mailbox. The session is destroyed when the viewer is
  /// gone.
  using Open = std::function<std::unique_ptr<ViewerSession>(const std::shared_ptr<ViewerMailbox>& mailbox,
                                                            const Access& access)>;
  /// The file at a path; nullptr: the path is unknown.
  using Find = std::function<const ServedFile*(std::string_view path)>;

  /// Listens at once. Throws std::runtime_error with one line.
  WebServer(WebServerOptions options, Find find, Open open);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  int port() const;
  /// Ends all connections, with this reason for the viewers, and all threads, within a second.
  void stop(const std::string& reason);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace reorient::live
