#include "engine/world/arbiter.h"

#include <algorithm>

namespace reorient {
namespace {

// As in the state machines: thirty frames of 1/30 s shall be a second.
constexpr double kTimeTolerance = 1e-6;

bool is_same(const Lease& left, const Lease& right) {
  return left.command == right.command && left.issuer == right.issuer && left.state == right.state;
}

}  // namespace

double Arbiter::cooldown(Command command) const {
  switch (command) {
    case Command::flip_pose:
      return parameters_.flip_cooldown;
    case Command::purge_reflection:
      return parameters_.purge_cooldown;
    case Command::reset_orientation:
      return parameters_.reset_cooldown;
    default:
      return 0.0;
  }
}

/// As if there were no other request.
Verdict Arbiter::judge(const CommandRequest& request, const World& world) const {
  if (request.command == Command::pause_training || request.command == Command::pause_evaluation)
    return Verdict::not_allowed;
  if (world.carried) return Verdict::not_allowed;
  if (world.fallen && request.command != Command::reset_orientation) return Verdict::not_allowed;
  const std::optional<double>& before = granted_at_[static_cast<int>(request.command)];
  if (before && world.time - *before + kTimeTolerance < cooldown(request.command)) return Verdict::too_soon;
  return Verdict::granted;
}

/// A lease that was not held in the frame before is one line of the timeline.
void Arbiter::note_leases(std::span<const Lease> leases, double time) {
  result_.train = true;
  result_.evaluate = true;
  for (const Lease& lease : leases) {
    (lease.command == Command::pause_training ? result_.train : result_.evaluate) = false;
    const bool is_new =
        std::none_of(held_.begin(), held_.end(), [&](const Lease& held) { return is_same(held, lease); });
    if (!is_new) continue;
    result_.records.push_back(
        {time, {lease.command, lease.issuer, lease.state, lease.reason, lease.priority}, Verdict::granted});
  }
  const auto in_both = [&](const Lease& left, const Lease& right) { return is_same(left, right); };
  if (!std::equal(held_.begin(), held_.end(), leases.begin(), leases.end(), in_both))
    held_.assign(leases.begin(), leases.end());
}

const Arbitration& Arbiter::arbitrate(std::span<const CommandRequest> requests, std::span<const Lease> leases,
                                      const World& world) {
  result_.records.clear();
  result_.reorientation.reset();
  note_leases(leases, world.time);
  const std::size_t first = result_.records.size();
  std::size_t winner = result_.records.size() + requests.size();
  for (const CommandRequest& request : requests) {
    const Verdict verdict = judge(request, world);
    result_.records.push_back({world.time, request, verdict});
    if (verdict != Verdict::granted) continue;
    const std::size_t index = result_.records.size() - 1;
    const bool leads = winner >= first + requests.size() || request.priority > result_.records[winner].request.priority;
    if (leads) winner = index;
  }
  for (std::size_t i = first; i < result_.records.size(); ++i) {
    CommandRecord& record = result_.records[i];
    if (record.verdict != Verdict::granted) continue;
    if (i == winner) {
      result_.reorientation = record.request.command;
      granted_at_[static_cast<int>(record.request.command)] = world.time;
    } else {
      record.verdict = Verdict::outranked;
    }
  }
  return result_;
}

}  // namespace reorient
