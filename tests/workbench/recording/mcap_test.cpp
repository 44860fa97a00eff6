// SPDX-License-Identifier: MIT
// MCAP files: the written data is read again, and damage is reported with its position.
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "geometry/random.h"
#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/data.h"
#include "workbench/recording/mcap/source.h"
#include "workbench/recording/mcap/writer.h"

namespace reorient::mcap {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

struct Written {
  std::uint16_t channel;
  std::uint64_t time;
  Bytes data;
  bool operator==(const Written&) const = default;
};

/// A file with several chunks of messages and an attachment between them.
class McapFile : public testing::Test {
 protected:
  McapFile() {
    Writer writer([this](std::span<const std::byte> bytes) { file_.insert(file_.end(), bytes.begin(), bytes.end()); },
                  "a test");
    const std::uint16_t schema = writer.add_schema("Thing", "jsonschema", R"({"type":"object"})");
    writer.add_channel("/things", "json", schema, {{"who", "we"}});
    writer.add_channel("/bytes", "own", 0);
    writer.add_metadata("run", {{"seed", "7"}, {"place", "hall"}});
    Random random(3);
    for (int i = 0; i < 60; ++i) {
      Bytes data = i % 3 == 0 ? bytes_of("{\"i\":" + std::to_string(i) + "}") : Bytes();
      while (i % 3 != 0 && data.size() < 40u * static_cast<unsigned>(i))
        data.push_back(static_cast<std::byte>(static_cast<int>(16.0 * random.uniform())));
      written_.push_back({static_cast<std::uint16_t>(i % 3 == 0 ? 0 : 1), 1000u * static_cast<unsigned>(i), data});
      writer.add_message(written_.back().channel, written_.back().time, data);
      if (i % 10 == 9) {
        writer.close_chunk();
        chunk_ends_.push_back(file_.size());
      }
      if (i == 35) writer.add_attachment("notes.txt", "text/plain", 35000, bytes_of("nothing to note"));
    }
    writer.finish();
  }

  /// All readable messages, chunk by chunk. `damages`: number of damages.
  static std::vector<Written> read(const Source& source, const Contents& contents, int& damages) {
    std::vector<Written> all;
    for (const ChunkPlace& place : contents.chunks) {
      try {
        ChunkMessages messages(source, place);
        for (Message message; messages.next(message);)
          all.push_back({message.channel, message.time, {message.data.begin(), message.data.end()}});
      } catch (const Damage& damage) {
        EXPECT_NE(std::string(damage.what()).find("at byte "), std::string::npos);
        EXPECT_LT(damage.where, source.size());
        ++damages;
      }
    }
    return all;
  }

  Bytes file_;
  std::vector<Written> written_;
  std::vector<std::size_t> chunk_ends_;
};

TEST_F(McapFile, IsReadAsWritten) {
  const MemorySource source(file_);
  const Contents contents = read_contents(source);
  EXPECT_TRUE(contents.is_complete);
  EXPECT_FALSE(contents.damage);
  EXPECT_EQ(contents.library, "a test");
  ASSERT_EQ(contents.channels.size(), 2u);
  EXPECT_EQ(contents.channel("/things")->metadata.at("who"), "we");
  EXPECT_EQ(contents.schema(contents.channel("/things")->schema)->name, "Thing");
  ASSERT_EQ(contents.metadata.size(), 1u);
  EXPECT_EQ(contents.metadata[0].texts.at("place"), "hall");
  ASSERT_TRUE(contents.statistics);
  EXPECT_EQ(contents.statistics->messages, 60u);
  EXPECT_EQ(contents.statistics->messages_of.at(0), 20u);
  EXPECT_EQ(contents.statistics->last_time, 59000u);
  ASSERT_EQ(contents.attachments.size(), 1u);
  EXPECT_EQ(read_attachment(source, contents.attachments[0]), bytes_of("nothing to note"));
  int damages = 0;
  EXPECT_EQ(read(source, contents, damages), written_);
  EXPECT_EQ(damages, 0);
}

TEST_F(McapFile, UsesTheSummaryIfItsBeginningIsDamaged) {
  const std::size_t first_chunk = read_contents(MemorySource(file_)).chunks.at(0).where;
  for (std::size_t place = 8; place < first_chunk; ++place) {
    Bytes damaged = file_;
    damaged[place] ^= std::byte{4};
    const MemorySource source(damaged);
    const Contents contents = read_contents(source);
    ASSERT_NE(contents.channel("/things"), nullptr) << place;
    ASSERT_NE(contents.channel("/bytes"), nullptr) << place;
    ASSERT_EQ(contents.schemas.size(), 1u) << place;
    EXPECT_EQ(contents.schemas[0].name, "Thing") << place;
    EXPECT_TRUE(std::any_of(contents.metadata.begin(), contents.metadata.end(),
                            [](const Metadata& one) { return one.name == "run"; }) ||
                contents.damage)
        << place;
    int damages = 0;
    EXPECT_EQ(read(source, contents, damages), written_) << place;
  }
}

TEST_F(McapFile, ThatWasTruncatedGivesAllCompleteChunksAndReportsItsEnd) {
  for (std::size_t size = 0; size < file_.size(); size += 1 + size / 97) {
    const MemorySource source(std::span<const std::byte>(file_).first(size));
    if (size < 8) {
      EXPECT_THROW(read_contents(source), Damage);
      continue;
    }
    const Contents contents = read_contents(source);
    EXPECT_FALSE(contents.is_complete);
    ASSERT_TRUE(contents.damage) << size;
    EXPECT_LE(contents.damage->where, size);
    int damages = 0;
    const std::vector<Written> all = read(source, contents, damages);
    const auto whole = static_cast<std::size_t>(
        std::count_if(chunk_ends_.begin(), chunk_ends_.end(), [&](std::size_t end) { return end <= size; }));
    EXPECT_GE(all.size(), 10 * whole) << size;
    EXPECT_TRUE(std::equal(all.begin(), all.end(), written_.begin())) << size;
    EXPECT_EQ(damages, 0);
  }
}

TEST_F(McapFile, WithAChangedByteGivesNoMessageThatWasNotWritten) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    Bytes damaged = file_;
    const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(file_.size()));
    damaged[place] ^= static_cast<std::byte>(1 + static_cast<int>(255.0 * random.uniform()));
    const MemorySource source(damaged);
    try {
      const Contents contents = read_contents(source);
      int damages = 0;
      for (const Written& one : read(source, contents, damages))
        EXPECT_NE(std::find(written_.begin(), written_.end(), one), written_.end()) << "changed at " << place;
    } catch (const Damage& damage) {
      EXPECT_LT(place, 8u) << damage.what();
    }
  }
}

TEST_F(McapFile, WithADamagedHeadLosesWhatThatHeadDescribes) {
  const MemorySource whole(file_);
  for (const ChunkPlace& lost : read_contents(whole).chunks) {
    // The opcode, the length and the description of the messages, and the end of the previous record.
    for (const std::ptrdiff_t from : {-8, 0, 1, 25}) {
      Bytes damaged = file_;
      const auto place = static_cast<std::ptrdiff_t>(lost.where) + from;
      std::fill_n(damaged.begin() + place, 16, std::byte{0x74});
      const MemorySource source(damaged);
      const Contents contents = read_contents(source);
      int damages = contents.damage ? 1 : 0;
      const std::vector<Written> all = read(source, contents, damages);
      EXPECT_GE(all.size(), 50u) << "damaged at " << place;
      EXPECT_GT(damages, 0) << "damaged at " << place;
      EXPECT_EQ(contents.channels.size(), 2u);
      for (const Written& one : all) EXPECT_NE(std::find(written_.begin(), written_.end(), one), written_.end());
    }
  }
}

TEST_F(McapFile, WithATooLargeLengthIsRejectedWithoutAllocatingMemory) {
  for (const std::uint64_t length : {std::uint64_t{1} << 60, ~std::uint64_t{0}, std::uint64_t{1} << 31}) {
    Bytes hostile(file_.begin(), file_.begin() + 8);
    ByteWriter{hostile}(Opcode::header, length);
    const MemorySource source(hostile);
    const Contents contents = read_contents(source);
    ASSERT_TRUE(contents.damage);
    EXPECT_NE(std::string(contents.damage->what()).find("expected a record of at most 0 bytes, found "),
              std::string::npos)
        << contents.damage->what();
  }
}

TEST_F(McapFile, WithAChunkLargerThanStatedIsRejected) {
  Bytes hostile(file_.begin(), file_.begin() + 8);
  ByteWriter out(hostile);
  const std::string none;
  for (const std::uint64_t claimed : {std::uint64_t{1} << 60, std::uint64_t{5}}) {
    out(Opcode::chunk, std::uint64_t{8 + 8 + 8 + 4 + 4 + 8 + 3}, std::uint64_t{0}, std::uint64_t{0}, claimed,
        std::uint32_t{0}, none, std::uint64_t{3}, std::uint8_t{5}, std::uint16_t{0});
  }
  const MemorySource source(hostile);
  const Contents contents = read_contents(source);
  ASSERT_TRUE(contents.damage);
  EXPECT_NE(std::string(contents.damage->what()).find("expected a chunk of at most "), std::string::npos)
      << contents.damage->what();
  ASSERT_EQ(contents.chunks.size(), 1u) << "the next record is read";
  EXPECT_THROW(ChunkMessages(source, contents.chunks[0]), Damage) << "it has 3 bytes, not 5";
}

/// A hole of a sparse file, or blocks that a flash memory lost. Records of no bytes would take hours.
TEST_F(McapFile, WithManyZerosIsNotReadAsRecords) {
  struct Sparse : Source {
    explicit Sparse(Bytes begin) : bytes(std::move(begin)) {}
    std::uint64_t size() const override { return std::uint64_t{1} << 40; }
    void read(std::uint64_t from, std::span<std::byte> into) const override {
      read_bytes += into.size();
      for (std::size_t i = 0; i < into.size(); ++i) into[i] = from + i < bytes.size() ? bytes[from + i] : std::byte{};
    }
    Bytes bytes;
    mutable std::uint64_t read_bytes = 0;
  };
  const std::size_t end_of_chunks = chunk_ends_.back();
  const Sparse hole(Bytes(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(end_of_chunks)));
  const Contents contents = read_contents(hole);
  ASSERT_TRUE(contents.damage);
  EXPECT_EQ(std::string(contents.damage->what()),
            "at byte " + std::to_string(end_of_chunks) + ": expected a record, found a byte of value 0");
  EXPECT_EQ(contents.chunks.size(), chunk_ends_.size());
  EXPECT_LT(hole.read_bytes, 100'000u);

  // A record that extends over the hole is not read, either.
  for (const Opcode opcode : {Opcode::header, Opcode::schema, Opcode::channel, Opcode::metadata, Opcode::chunk,
                              Opcode::attachment, Opcode::message}) {
    Bytes begin(file_.begin(), file_.begin() + 8);
    ByteWriter out(begin);
    out(opcode, std::uint64_t{1} << 39);
    if (opcode == Opcode::chunk)
      out(std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{5}, std::uint32_t{0}, std::string("zstd"),
          std::uint64_t{1} << 38);
    const Sparse large(begin);
    const Contents found = read_contents(large);
    EXPECT_TRUE(found.damage) << static_cast<int>(opcode);
    EXPECT_TRUE(found.chunks.empty() && found.loose.empty()) << static_cast<int>(opcode);
    EXPECT_LT(large.read_bytes, 100'000u) << static_cast<int>(opcode);
  }
}

/// 30 000 entries that all name the same large record, whose list is longer than the record.
TEST_F(McapFile, WhoseSummaryListsMetadataManyTimesIsReadInLinearTime) {
  Bytes bytes(file_.begin(), file_.begin() + 8);
  ByteWriter out(bytes);
  out(std::uint8_t{0});  // a damage, after which only the summary is known
  const std::uint64_t where = bytes.size();
  constexpr std::uint32_t kText = 1u << 20;
  constexpr std::uint64_t kLength = 5 + 4 + 4 + 4 + kText;
  out(Opcode::metadata, kLength, std::string("x"), std::uint32_t{2 * kText}, std::string(), std::string(kText, 'y'));
  const std::uint64_t summary = bytes.size();
  for (int i = 0; i < 30'000; ++i)
    out(Opcode::metadata_index, std::uint64_t{8 + 8 + 4 + 1}, where, std::uint64_t{kText}, std::string("x"));
  out(Opcode::footer, std::uint64_t{20}, summary, std::uint64_t{0}, std::uint32_t{0});
  out.raw(kMagic.data(), kMagic.size());
  struct Counting : MemorySource {
    using MemorySource::MemorySource;
    void read(std::uint64_t from, std::span<std::byte> into) const override {
      read_bytes += into.size();
      MemorySource::read(from, into);
    }
    mutable std::uint64_t read_bytes = 0;
  };
  const Counting source(bytes);
  const Contents contents = read_contents(source);
  EXPECT_TRUE(contents.is_complete);
  EXPECT_LT(source.read_bytes, 10 * bytes.size());
}

TEST(McapWriter, PassesExceptionsOfItsSinkOn) {
  int calls = 0;
  Writer writer(
      [&](std::span<const std::byte>) {
        if (++calls > 3) throw std::runtime_error("the disk is full");
      },
      "a test");
  writer.add_channel("/bytes", "own", 0);
  writer.add_message(0, 1, bytes_of("something"));
  EXPECT_THROW(
      {
        writer.close_chunk();
        writer.finish();
      },
      std::runtime_error);
}

/// For any available space: if the chunks are larger than the summary, the file is complete and begins with the first
/// messages.
TEST(McapWriter, ReplacesChunksByTheSummaryIfTheSpaceIsNotEnough) {
  constexpr std::size_t kChunks = 60;
  int whole = 0, made_room = 0;
  for (std::size_t most = 500; most < 30000; most += 37) {
    std::vector<std::byte> file;
    Writer writer(
        [&](std::span<const std::byte> bytes) {
          if (file.size() + bytes.size() > most) throw std::runtime_error("the disk is full");
          file.insert(file.end(), bytes.begin(), bytes.end());
        },
        "a test");
    writer.add_channel("/bytes", "own", 0);
    std::size_t closed = 0;
    bool is_whole = true;
    try {
      for (; closed < kChunks; ++closed) {
        if (closed % 7 == 6) writer.add_channel("/more/" + std::to_string(closed), "own", 0);
        writer.add_message(0, closed, std::vector<std::byte>(40 + closed % 50, std::byte(closed)));
        if (closed % 7 == 6) writer.add_message(static_cast<std::uint16_t>(closed / 7 + 1), closed, bytes_of("more"));
        writer.close_chunk();
      }
    } catch (const std::runtime_error&) {
    }
    try {
      writer.finish();
    } catch (const std::runtime_error&) {
      is_whole = writer.make_room();
      if (is_whole) {
        ++made_room;
        file.resize(writer.size());
        writer.finish();
      }
    }
    EXPECT_EQ(file.size(), writer.size());
    if (!is_whole) continue;
    ++whole;
    const MemorySource source(file);
    const Contents contents = read_contents(source);
    ASSERT_FALSE(contents.damage) << most << ": " << contents.damage->what();
    ASSERT_LE(contents.chunks.size(), closed) << most;
    ASSERT_TRUE(contents.is_complete && contents.statistics) << most;
    ASSERT_EQ(contents.statistics->chunks, contents.chunks.size()) << most;
    ASSERT_EQ(contents.statistics->channels, contents.channels.size()) << most;
    ASSERT_EQ(writer.messages_of(0), contents.chunks.size()) << most;
    for (std::size_t i = 0; i < contents.chunks.size(); ++i) ASSERT_EQ(contents.chunks[i].start_time, i) << most;
  }
  EXPECT_GT(whole, 100);
  EXPECT_GT(made_room, 50);
}

TEST(McapReader, ListsARepeatedTopicOnceAndRejectsTensOfThousands) {
  std::vector<std::byte> bytes;
  mcap::Writer writer([&](std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); },
                      "");
  const std::size_t begin = bytes.size();
  writer.add_channel("/a", "json", 0);
  const std::vector<std::byte> record(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
  std::vector<std::byte> twice = bytes;
  twice.insert(twice.end(), record.begin(), record.end());
  EXPECT_EQ(mcap::read_contents(mcap::MemorySource(twice)).channels.size(), 1u);
  for (int i = 0; i < 60000; ++i) writer.add_channel("/b", "json", 0);
  const mcap::Contents many = mcap::read_contents(mcap::MemorySource(bytes));
  EXPECT_LE(many.channels.size(), 4096u);
  ASSERT_TRUE(many.damage);
  EXPECT_NE(std::string(many.damage->what()).find("topics or schemas"), std::string::npos) << many.damage->what();
}

}  // namespace
}  // namespace reorient::mcap
