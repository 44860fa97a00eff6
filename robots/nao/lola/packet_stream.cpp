// SPDX-License-Identifier: MIT
#include "robots/nao/lola/packet_stream.h"

#include <algorithm>

#include "robots/nao/lola/packed.h"

namespace reorient::nao {

PacketStream::State PacketStream::next(std::span<const std::byte>& packet) {
  const std::span<const std::byte> waiting = std::span(bytes_).subspan(begin_, end_ - begin_);
  const PackedExtent extent = first_packed_value(waiting);
  if (extent.state == PackedExtent::State::whole && extent.size <= kLongest) {
    packet = waiting.first(extent.size);
    begin_ += extent.size;
    return State::packet;
  }
  if (extent.state != PackedExtent::State::cut_short || waiting.size() >= kLongest) return State::invalid;
  std::copy(waiting.begin(), waiting.end(), bytes_.begin());
  end_ = waiting.size();
  begin_ = 0;
  return State::waiting;
}

}  // namespace reorient::nao
