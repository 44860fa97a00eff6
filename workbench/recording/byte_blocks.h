// SPDX-License-Identifier: MIT
// Memory for bytes that are kept for a while: large blocks that are used again. Hours of allocations of different sizes
// would fragment the heap.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace reorient {

class ByteBlocks {
 public:
  /// A copy of bytes. Any thread may release it.
  struct Kept {
    std::shared_ptr<const void> memory;  ///< of `bytes`, and of others
    std::span<const std::byte> bytes;
  };

  /// Only one thread may call it.
  Kept keep(std::span<const std::byte> bytes) {
    if (!block_ || block_->capacity() - block_->size() < bytes.size()) block_ = take(bytes.size());
    const std::size_t begin = block_->size();
    block_->insert(block_->end(), bytes.begin(), bytes.end());  // within the reserved memory, so nothing moves
    return {block_, std::span<const std::byte>(*block_).subspan(begin)};
  }

 private:
  using Block = std::vector<std::byte>;
  static constexpr std::size_t kBlock = std::size_t{4} << 20;

  struct Unused {
    std::mutex mutex;
    std::vector<std::unique_ptr<Block>> blocks;
  };

  std::shared_ptr<Block> take(std::size_t least) {
    std::unique_ptr<Block> block;
    {
      const std::lock_guard lock(unused_->mutex);
      if (least <= kBlock && !unused_->blocks.empty()) {
        block = std::move(unused_->blocks.back());
        unused_->blocks.pop_back();
      }
    }
    if (!block) {
      block = std::make_unique<Block>();
      block->reserve(std::max(kBlock, least));
    }
    return {block.release(), [unused = unused_](Block* released) {
              std::unique_ptr<Block> owned(released);
              if (owned->capacity() > kBlock) return;
              owned->clear();
              const std::lock_guard lock(unused->mutex);
              unused->blocks.push_back(std::move(owned));
            }};
  }

  std::shared_ptr<Unused> unused_ = std::make_shared<Unused>();  // the last of this object and all blocks deletes it
  std::shared_ptr<Block> block_;
};

}  // namespace reorient
