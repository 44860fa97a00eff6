// Reads MCAP files, whole ones and damaged ones, with no more memory than their size justifies. It goes through the
// records from the first on and needs no summary, which files that ended early lack; where there is one, it finds what
// lies behind a damage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "workbench/recording/mcap/format.h"

namespace reorient::mcap {

/// Somewhere in a file something is not as it should be.
struct Damage : std::runtime_error {
  /// `place`: the byte at which the record begins.
  Damage(std::uint64_t place, const std::string& what);
  std::uint64_t where;
};

/// Bytes that can be read at any place.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t size() const = 0;
  /// All of `bytes`, which lie within the size. Throws std::runtime_error with one line.
  virtual void read(std::uint64_t from, std::span<std::byte> bytes) const = 0;
};

class FileSource : public Source {
 public:
  /// Throws std::runtime_error with one line.
  explicit FileSource(const std::filesystem::path& file);
  ~FileSource() override;
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  std::uint64_t size() const override { return size_; }
  void read(std::uint64_t from, std::span<std::byte> bytes) const override;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

class MemorySource : public Source {
 public:
  explicit MemorySource(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_.size(); }
  void read(std::uint64_t from, std::span<std::byte> bytes) const override;

 private:
  std::span<const std::byte> bytes_;
};

/// Where a chunk is, and what its head says of it.
struct ChunkPlace {
  std::uint64_t where = 0;                     ///< of its record
  std::uint64_t start_time = 0, end_time = 0;  ///< ns
  std::uint64_t size = 0;                      ///< bytes of its messages
  std::uint32_t crc = 0;                       ///< of those; 0: not told
  std::string compression;
  std::uint64_t data = 0, data_size = 0;  ///< where they lie, and how many bytes that are
};

struct AttachmentPlace {
  std::uint64_t where = 0;
  std::string name, media_type;
  std::uint64_t time = 0;                 ///< ns
  std::uint64_t data = 0, data_size = 0;  ///< where it lies
};

struct Metadata {
  std::string name;
  Texts texts;
};

/// What is in a file, but for the messages.
struct Contents {
  std::string library;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<ChunkPlace> chunks;
  std::vector<AttachmentPlace> attachments;
  std::vector<Metadata> metadata;
  std::optional<Statistics> statistics;  ///< as the summary tells them
  std::optional<Damage> damage;          ///< the first; of what comes after it, what the summary names is listed
  bool is_complete = false;              ///< it has its end

  const Schema* schema(std::uint16_t id) const;
  const Channel* channel(std::uint16_t id) const;
  const Channel* channel(std::string_view topic) const;
};

/// Throws Damage where it is no MCAP file at all.
Contents read_contents(const Source& source);

struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;  ///< ns
  std::span<const std::byte> data;
};

/// The messages of one chunk, in their order.
class ChunkMessages {
 public:
  /// Throws Damage; there may be messages before it all the same.
  ChunkMessages(const Source& source, const ChunkPlace& place);

  /// False: there are no more. Throws Damage.
  bool next(Message& message);

 private:
  std::uint64_t where_;
  std::vector<std::byte> records_;
  std::size_t at_ = 0;
};

/// Bytes of an attachment. Throws Damage where its checksum is another one.
std::vector<std::byte> read_attachment(const Source& source, const AttachmentPlace& place);

/// Uncompressed; larger ones are refused.
inline constexpr std::uint64_t kLargestChunk = 256u << 20;

}  // namespace reorient::mcap
