// SPDX-License-Identifier: MIT
#include "workbench/recording/mcap/ordered_messages.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace reorient::mcap {

OrderedMessages::OrderedMessages(const Source& source, std::vector<ChunkPlace> places, std::set<std::uint16_t> channels,
                                 std::uint64_t most_memory)
    : source_(source), places_(std::move(places)), channels_(std::move(channels)), most_memory_(most_memory) {
  std::sort(places_.begin(), places_.end(), [](const ChunkPlace& a, const ChunkPlace& b) {
    return std::tie(a.start_time, a.where) < std::tie(b.start_time, b.where);
  });
}

bool OrderedMessages::must_open_next() const {
  if (next_place_ == places_.size()) return false;
  if (open_.empty()) return true;
  const ChunkPlace& place = places_[next_place_];
  const OpenChunk& first = *open_.front();
  return place.start_time != first.time() ? place.start_time < first.time() : place.where < first.where;
}

void OrderedMessages::open_next() {
  const ChunkPlace& place = places_[next_place_++];
  if (!open_.empty() && memory_ + place.size > most_memory_) {
    throw Damage(place.where, "expected chunks that overlap in time to need at most " +
                                  std::to_string(most_memory_ >> 20) + " MB, found " +
                                  std::to_string((memory_ + place.size) >> 20) + " MB");
  }
  auto chunk = std::make_unique<OpenChunk>(source_, place);
  try {
    std::size_t at = 0;
    for (Message message; chunk->records.next(message); at = chunk->records.at())
      if (channels_.contains(message.channel))
        chunk->messages.push_back({message.time, static_cast<std::uint32_t>(at)});
  } catch (const Damage& damage) {
    if (chunk->messages.empty()) throw;
    chunk->damage = damage;
  }
  if (chunk->messages.empty()) return;
  std::stable_sort(chunk->messages.begin(), chunk->messages.end(),
                   [](const Indexed& a, const Indexed& b) { return a.time < b.time; });
  chunk->size = place.size;
  memory_ += place.size;
  open_.push_back(std::move(chunk));
  std::push_heap(open_.begin(), open_.end(), Later());
}

bool OrderedMessages::next(Message& message) {
  if (current_ && ++current_->at < current_->messages.size()) {
    open_.push_back(std::move(current_));
    std::push_heap(open_.begin(), open_.end(), Later());
  } else if (current_) {
    memory_ -= current_->size;
    const std::optional<Damage> damage = current_->damage;
    current_.reset();
    if (damage) throw *damage;
  }
  while (must_open_next()) open_next();
  if (open_.empty()) return false;
  std::pop_heap(open_.begin(), open_.end(), Later());
  current_ = std::move(open_.back());
  open_.pop_back();
  current_->records.go_to(current_->messages[current_->at].at);
  return current_->records.next(message);
}

}  // namespace reorient::mcap
