// SPDX-License-Identifier: MIT
// Converts values to bytes and back. One declaration serves both directions. With it, everything that decides the next
// frame can be saved, and a record can be written and read again. Little-endian, without padding.
//
// A plain struct lists its members in a free function beside it,
//   template <typename Visit, ConstOr<Pose2> T>
//   void fields(Visit&& visit, T& pose) { visit(pose.position, pose.rotation); }
// a class in a static member function,
//   template <typename Archive> static void archive(Archive& archive, auto& self) { archive(self.x_, self.y_); }
// and an enum gives the number of its values,
//   constexpr int enum_count(Posture) { return 5; }
// A writer receives const values.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/const_or.h"

namespace reorient {

static_assert(std::endian::native == std::endian::little, "the byte order in memory must be that of the format");

/// Bytes that a reader does not expect: truncated, of another version, or forged.
struct BadBytes : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Checks that values that were read are values that this program could have written.
inline void check_bytes(bool sound, const char* what) {
  if (!sound) throw BadBytes(what);
}

template <typename T, typename Archive>
concept HasArchive = requires(T& value, Archive& archive) {
  T::archive(archive, value);
};

/// Limits how deep values of one type contain values of the same type.
class NestedBytes {
 public:
  int depth() const { return depth_; }

  struct Level {
    explicit Level(NestedBytes& outer) : bytes(outer) { ++bytes.depth_; }
    ~Level() { --bytes.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    NestedBytes& bytes;
  };

 private:
  int depth_ = 0;
};

/// Appends values to bytes.
class ByteWriter : public NestedBytes {
 public:
  static constexpr bool kReads = false;

  explicit ByteWriter(std::vector<std::byte>& bytes) : bytes_(&bytes) {}

  template <typename... T>
  void operator()(const T&... values) {
    (write(values), ...);
  }

  /// Writes the elements without their number.
  void raw(const void* data, std::size_t size) {
    const auto* const begin = static_cast<const std::byte*>(data);
    bytes_->insert(bytes_->end(), begin, begin + size);
  }

 private:
  template <typename T>
  void write(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      write(static_cast<std::uint8_t>(value ? 1 : 0));
    } else if constexpr (std::is_enum_v<T>) {
      write(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
      raw(&value, sizeof(T));
    } else if constexpr (HasArchive<T, ByteWriter>) {
      T::archive(*this, value);
    } else {
      fields(*this, value);
    }
  }
  void write(const std::string& text) {
    write(static_cast<std::uint32_t>(text.size()));
    raw(text.data(), text.size());
  }
  template <typename T>
  void write(const std::vector<T>& values) {
    write(static_cast<std::uint32_t>(values.size()));
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::byte>) {
      raw(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) write(value);
    }
  }
  template <typename T, std::size_t Size>
  void write(const std::array<T, Size>& values) {
    for (const T& value : values) write(value);
  }
  template <typename T>
  void write(const std::optional<T>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <typename A, typename B>
  void write(const std::pair<A, B>& pair) {
    write(pair.first);
    write(pair.second);
  }
  template <typename Key, typename Value, typename Less>
  void write(const std::map<Key, Value, Less>& map) {
    write(static_cast<std::uint32_t>(map.size()));
    for (const auto& [key, value] : map) {
      write(key);
      write(value);
    }
  }
  template <typename... T>
  void write(const std::variant<T...>& value) {
    write(static_cast<std::uint8_t>(value.index()));
    std::visit([this](const auto& held) { this->write(held); }, value);
  }
  template <typename Scalar, int Rows, int Columns, int Options>
  void write(const Eigen::Matrix<Scalar, Rows, Columns, Options>& matrix) {
    static_assert(Rows != Eigen::Dynamic && Columns != Eigen::Dynamic);
    for (Eigen::Index i = 0; i < matrix.size(); ++i) write(matrix.data()[i]);
  }
  template <int Options>
  void write(const Eigen::Transform<double, 3, Eigen::Isometry, Options>& transform) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) write(transform(i, j));
    }
  }

  std::vector<std::byte>* bytes_;
};

/// Reads values from bytes. For any bytes, it neither reads beyond their end nor creates more values than they can
/// contain. It throws BadBytes for impossible values.
class ByteReader : public NestedBytes {
 public:
  static constexpr bool kReads = true;

  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <typename... T>
  void operator()(T&... values) {
    (read(values), ...);
  }

  void raw(void* data, std::size_t size) {
    if (size > bytes_.size())
      throw BadBytes("the data ends too early: expected " + std::to_string(size) + " more bytes, found " +
                     std::to_string(bytes_.size()));
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }

  std::size_t left() const { return bytes_.size(); }

  /// Throws if bytes remain.
  void finish() const {
    if (!bytes_.empty())
      throw BadBytes("expected the end of the data, found " + std::to_string(bytes_.size()) + " more bytes");
  }

 private:
  template <typename T>
  void read(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = read_index(2) == 1;
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(read_index(enum_count(T{})));
    } else if constexpr (std::is_arithmetic_v<T>) {
      raw(&value, sizeof(T));
    } else if constexpr (HasArchive<T, ByteReader>) {
      T::archive(*this, value);
    } else {
      fields(*this, value);
    }
  }
  void read(std::string& text) {
    text.resize(read_size(1));
    raw(text.data(), text.size());
  }
  template <typename T>
  void read(std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::byte>) {
      values.resize(read_size(sizeof(T)));
      raw(values.data(), values.size() * sizeof(T));
    } else {
      const std::size_t size = read_size(1);
      values.clear();
      for (std::size_t i = 0; i < size; ++i) read(values.emplace_back());
    }
  }
  template <typename T, std::size_t Size>
  void read(std::array<T, Size>& values) {
    for (T& value : values) read(value);
  }
  template <typename T>
  void read(std::optional<T>& value) {
    value.reset();
    if (read_index(2) == 1) read(value.emplace());
  }
  template <typename A, typename B>
  void read(std::pair<A, B>& pair) {
    read(pair.first);
    read(pair.second);
  }
  template <typename Key, typename Value, typename Less>
  void read(std::map<Key, Value, Less>& map) {
    const std::size_t size = read_size(1);
    map.clear();
    for (std::size_t i = 0; i < size; ++i) {
      Key key{};
      read(key);
      read(map[std::move(key)]);
    }
  }
  template <typename... T>
  void read(std::variant<T...>& value) {
    read_alternative<0>(read_index(static_cast<int>(sizeof...(T))), value);
  }
  template <std::size_t Index, typename... T>
  void read_alternative(int selected, std::variant<T...>& value) {
    if constexpr (Index < sizeof...(T)) {
      if (selected == static_cast<int>(Index)) return read(value.template emplace<Index>());
      read_alternative<Index + 1>(selected, value);
    }
  }
  template <typename Scalar, int Rows, int Columns, int Options>
  void read(Eigen::Matrix<Scalar, Rows, Columns, Options>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) read(matrix.data()[i]);
  }
  template <int Options>
  void read(Eigen::Transform<double, 3, Eigen::Isometry, Options>& transform) {
    transform.setIdentity();
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) read(transform(i, j));
    }
  }

  /// The number of elements that follow, each of which has at least `least` bytes.
  std::size_t read_size(std::size_t least) {
    std::uint32_t size = 0;
    raw(&size, sizeof(size));
    if (size > bytes_.size() / least)
      throw BadBytes("a list of " + std::to_string(size) + " elements does not fit into the remaining " +
                     std::to_string(bytes_.size()) + " bytes");
    return size;
  }
  int read_index(int count) {
    std::uint8_t index = 0;
    raw(&index, 1);
    if (index >= count)
      throw BadBytes("invalid value " + std::to_string(index) + " (expected 0 to " + std::to_string(count - 1) + ")");
    return index;
  }

  std::span<const std::byte> bytes_;
};

}  // namespace reorient
