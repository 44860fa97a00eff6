// SPDX-License-Identifier: MIT
// The container of MCAP files of other programs.
#include "workbench/recording/mcap/ordered_messages.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/workbench/recording/raw_mcap.h"
#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/topics.h"

namespace reorient::mcap {
namespace {

using Bytes = std::vector<std::byte>;

struct Found {
  std::uint16_t channel;
  std::uint64_t time;
  bool operator==(const Found&) const = default;
};

std::vector<Found> read_all(const Bytes& file, std::set<std::uint16_t> channels, Contents* found_contents = nullptr,
                            std::uint64_t memory = OrderedMessages::kMostMemory) {
  const MemorySource source(file);
  Contents contents = read_contents(source);
  read_topics_in_chunks(source, contents);
  OrderedMessages messages(source, contents.places(), std::move(channels), memory);
  std::vector<Found> all;
  for (Message message; messages.next(message);) {
    EXPECT_EQ(message.data.size(), message.time % 100) << "the data must belong to the message";
    all.push_back({message.channel, message.time});
  }
  if (found_contents != nullptr) *found_contents = contents;
  return all;
}

void add(RawMcap& file, std::uint16_t channel, std::uint64_t time) { file.message(channel, time, Bytes(time % 100)); }

TEST(OrderedMessages, ComeFromChunksOfAllCompressions) {
  for (const char* const compression : {"", "lz4", "zstd"}) {
    RawMcap file;
    file.magic();
    file.header();
    for (const std::uint64_t first : {100u, 200u}) {
      RawMcap chunk;
      for (std::uint64_t i = 0; i < 50; ++i) add(chunk, static_cast<std::uint16_t>(i % 2), first + i);
      file.chunk(chunk, compression);
    }
    file.end();
    const std::vector<Found> all = read_all(file.bytes(), {1});
    ASSERT_EQ(all.size(), 50u) << compression;
    EXPECT_EQ(all.front(), (Found{1, 101})) << compression;
    EXPECT_EQ(all.back(), (Found{1, 249})) << compression;
  }
}

TEST(OrderedMessages, ComeFromOutsideOfChunks) {
  RawMcap file;
  file.magic();
  file.header();
  file.schema(1, "Thing");
  file.channel(7, 1, "/things");
  for (const std::uint64_t time : {103u, 101u, 102u}) add(file, 7, time);
  file.record(static_cast<Opcode>(0x77), Bytes(5));  // an unknown record
  add(file, 7, 104);
  file.end();
  Contents contents;
  EXPECT_EQ(read_all(file.bytes(), {7}, &contents), (std::vector<Found>{{7, 101}, {7, 102}, {7, 103}, {7, 104}}));
  EXPECT_FALSE(contents.damage);
  EXPECT_EQ(contents.channel("/things")->id, 7);
}

TEST(OrderedMessages, AreInTheOrderOfTimeAcrossChunks) {
  // One topic after the other, as converters write them.
  RawMcap file;
  file.magic();
  file.header();
  for (const std::uint16_t channel : {1, 2}) {
    for (std::uint64_t first = 100; first < 400; first += 100) {
      RawMcap chunk;
      for (std::uint64_t i = 0; i < 90; i += 10) add(chunk, channel, first + 80 - i);
      file.chunk(chunk, "lz4");
    }
  }
  file.end();
  const std::vector<Found> all = read_all(file.bytes(), {1, 2});
  ASSERT_EQ(all.size(), 54u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LE(all[i - 1].time, all[i].time);
    EXPECT_TRUE(all[i - 1].time < all[i].time || all[i - 1].channel < all[i].channel) << "as in the file";
  }
}

TEST(OrderedMessages, OfChunksThatOverlapMuchAreRejected) {
  RawMcap file;
  file.magic();
  file.header();
  for (int i = 0; i < 3; ++i) {
    RawMcap chunk;
    chunk.message(1, 100, Bytes(1u << 20));
    chunk.message(1, 200, Bytes(1u << 20));
    file.chunk(chunk, "zstd");
  }
  file.end();
  const MemorySource source(file.bytes());
  const Contents contents = read_contents(source);
  OrderedMessages messages(source, contents.chunks, {1}, 5u << 20);
  Message message;
  try {
    while (messages.next(message)) {
    }
    ADD_FAILURE() << "three chunks need 6 MB";
  } catch (const Damage& damage) {
    EXPECT_NE(std::string(damage.what()).find("expected chunks that overlap in time to need at most 5 MB"),
              std::string::npos)
        << damage.what();
  }
}

/// Not all writers add checksums, so a damage may appear within a chunk.
TEST(OrderedMessages, BeforeAndAfterADamageWithinAChunkAreRead) {
  RawMcap file;
  file.magic();
  file.header();
  RawMcap damaged, sound;
  add(damaged, 7, 102);
  add(damaged, 7, 101);
  damaged.record(Opcode::message, Bytes(5));  // too short for a message
  add(damaged, 7, 103);
  const std::size_t where = file.bytes().size();
  file.chunk(damaged, "zstd");
  add(sound, 7, 104);
  file.chunk(sound, "zstd");
  file.end();
  const MemorySource source(file.bytes());
  OrderedMessages messages(source, read_contents(source).places(), {7});
  std::vector<std::uint64_t> times;
  int damages = 0;
  for (bool is_over = false; !is_over;) {
    try {
      Message message;
      is_over = !messages.next(message);
      if (is_over) continue;
      times.push_back(message.time);
      EXPECT_EQ(message.data.size(), message.time % 100);
    } catch (const Damage& damage) {
      ++damages;
      EXPECT_EQ(damage.where, where);
      EXPECT_EQ(times, (std::vector<std::uint64_t>{101, 102})) << "the messages before it come first";
    }
  }
  EXPECT_EQ(times, (std::vector<std::uint64_t>{101, 102, 104}));
  EXPECT_EQ(damages, 1);
}

TEST(OrderedMessages, WithTheSameTimeOpenOneChunkAfterAnother) {
  RawMcap file;
  file.magic();
  file.header();
  for (int i = 0; i < 3; ++i) {
    RawMcap chunk;
    for (int j = 0; j < 2; ++j) chunk.message(1, 0, Bytes());
    chunk.message(2, 0, Bytes(1u << 20));
    file.chunk(chunk, "zstd");
  }
  file.end();
  EXPECT_EQ(read_all(file.bytes(), {1}, nullptr, 2u << 20).size(), 6u);
}

TEST(TopicsInChunks, AreFoundWithoutASummary) {
  RawMcap file, chunk;
  chunk.schema(3, "Thing");
  chunk.channel(4, 3, "/things");
  add(chunk, 4, 101);
  file.magic();
  file.header();
  file.chunk(chunk, "zstd");
  for (const bool is_cut : {true, false}) {
    if (!is_cut) file.end();
    Contents contents;
    EXPECT_EQ(read_all(file.bytes(), {4}, &contents).size(), 1u);
    ASSERT_NE(contents.channel("/things"), nullptr);
    EXPECT_EQ(contents.schema(3)->name, "Thing");
    EXPECT_EQ(contents.damage.has_value(), is_cut);
  }
}

TEST(TopicsInChunks, AreFoundAfterADamagedChunk) {
  RawMcap file;
  file.magic();
  file.header();
  RawMcap lost, found;
  lost.record(Opcode::channel, Bytes(3));
  file.chunk(lost, "lz4");
  found.channel(7, 0, "/things");
  add(found, 7, 101);
  file.chunk(found, "lz4");
  file.end();
  const MemorySource source(file.bytes());
  Contents contents = read_contents(source);
  read_topics_in_chunks(source, contents);
  ASSERT_NE(contents.channel("/things"), nullptr);
}

TEST(Lz4Chunks, ThatAreDamagedOrLargerThanStatedAreRejected) {
  RawMcap file, chunk;
  for (std::uint64_t time = 0; time < 3000; ++time) add(chunk, 1, time);
  file.magic();
  file.header();
  file.chunk(chunk, "lz4");
  const std::size_t begin = read_contents(MemorySource(file.bytes())).chunks.at(0).data;
  for (std::size_t place = begin; place < file.bytes().size(); place += 101) {
    Bytes damaged = file.bytes();
    damaged[place] ^= std::byte{0x10};
    const MemorySource source(damaged);
    try {
      ChunkMessages messages(source, read_contents(source).chunks.at(0));
      for (Message message; messages.next(message);) {
      }
    } catch (const Damage&) {  // other messages are possible, too, because these chunks have no checksum
    }
  }
  Bytes claims_less = file.bytes();
  claims_less[begin - 8 - 7 - 4 - 8] ^= std::byte{1};  // its uncompressed size
  EXPECT_THROW(read_all(claims_less, {1}), Damage);
}

}  // namespace
}  // namespace reorient::mcap
