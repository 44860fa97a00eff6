// SPDX-License-Identifier: MIT
// One viewer's messages, on its own thread: subscriptions are done here, everything that concerns the run becomes a
// request to the thread of the frames.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "workbench/views/live/requests.h"
#include "workbench/views/live/script_services.h"
#include "workbench/views/live/server/web_server.h"
#include "workbench/views/live/viewers.h"
#include "workbench/views/live/what_ifs.h"

namespace reorient::live {

/// What the sessions of all viewers use. It outlives them.
struct SessionParts {
  Viewers& viewers;
  BoundedQueue<FrameRequest>& requests;
  const ScriptServices& scripts;
  WhatIfs& what_ifs;
  ServerInfo info;
  /// Of a replay with a time bar; may be empty.
  std::function<void(ViewerId, const ControlPlayback&)> control_playback{};
};

class Session : public ViewerSession {
 public:
  Session(const SessionParts& parts, std::shared_ptr<ViewerMailbox> mailbox, Access access);
  ~Session() override;

  void receive_text(std::string_view text) override;
  void receive_binary(std::span<const std::byte> bytes) override;

 private:
  void receive(const ClientMessage& message);
  void take(const Subscribe& message);
  void take(const Unsubscribe& message);
  void take(const GetParameters& message);
  void take(const SetParameters& message);
  void take(const WatchParameters& message);
  void take(const CallService& message);
  void take(const FetchAsset& message);
  void take(const ControlPlayback& message);
  void take(const NotOffered& message);

  FrameTask read_call(const CallService& message, AnswerAddress& to) const;
  bool post(FrameRequest request);
  void warn(const std::string& problem);

  const SessionParts& parts_;
  std::shared_ptr<ViewerMailbox> mailbox_;
  Access access_;
  ViewerId viewer_;
};

}  // namespace reorient::live
