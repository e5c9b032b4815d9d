#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace tether_monitor::core
{
/**
 * Bytes of a state, and back, bit for bit, on machines of the same byte order.
 *
 * A class that can be archived has one member `template <class Archive> void serialize(Archive& a) { a(x, y); }`,
 * which serves both ways. Numbers, enumerations, strings, Eigen vectors and quaternions, std::vector, std::array,
 * std::optional and such classes can be listed.
 */
class BinaryWriter
{
 public:
  static constexpr bool READS = false;

  template <typename... Items>
  void operator()(const Items&... items)
  {
    (put(items), ...);
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  template <typename T>
  void put(const T& x)
  {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      raw(&x, sizeof x);
    else
      const_cast<T&>(x).serialize(*this);  // which changes nothing when it writes
  }
  void put(const std::string& x)
  {
    size(x.size());
    raw(x.data(), x.size());
  }
  template <int Rows, int Columns>
  void put(const Eigen::Matrix<double, Rows, Columns>& x)
  {
    raw(x.data(), sizeof(double) * x.size());
  }
  void put(const Eigen::Quaterniond& x) { raw(x.coeffs().data(), 4 * sizeof(double)); }
  template <typename T>
  void put(const std::vector<T>& x)
  {
    size(x.size());
    for (const T& item : x)
      put(item);
  }
  template <typename T, std::size_t N>
  void put(const std::array<T, N>& x)
  {
    for (const T& item : x)
      put(item);
  }
  template <typename T>
  void put(const std::optional<T>& x)
  {
    size(x ? 1 : 0);
    if (x)
      put(*x);
  }
  void size(std::uint64_t n) { raw(&n, sizeof n); }
  void raw(const void* from, std::size_t n)
  {
    const auto* begin = static_cast<const std::uint8_t*>(from);
    bytes_.insert(bytes_.end(), begin, begin + n);
  }

  std::vector<std::uint8_t> bytes_;
};

/// The way back. Bytes that are too few or too many make ok() false; nothing is read beyond them.
class BinaryReader
{
 public:
  static constexpr bool READS = true;

  explicit BinaryReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  template <typename... Items>
  void operator()(Items&... items)
  {
    (get(items), ...);
  }
  /// Everything was there, and nothing is left.
  bool finished() const { return ok_ && at_ == bytes_.size(); }
  bool ok() const { return ok_; }

 private:
  void get(bool& x)
  {
    std::uint8_t byte = 0;
    raw(&byte, 1);
    ok_ = ok_ && byte <= 1;
    x = byte == 1;
  }
  template <typename T>
  void get(T& x)
  {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      raw(&x, sizeof x);
    else
      x.serialize(*this);
  }
  void get(std::string& x)
  {
    x.resize(size(1));
    raw(x.data(), x.size());
  }
  template <int Rows, int Columns>
  void get(Eigen::Matrix<double, Rows, Columns>& x)
  {
    raw(x.data(), sizeof(double) * x.size());
  }
  void get(Eigen::Quaterniond& x) { raw(x.coeffs().data(), 4 * sizeof(double)); }
  template <typename T>
  void get(std::vector<T>& x)
  {
    x.resize(size(1));
    for (T& item : x)
      get(item);
  }
  template <typename T, std::size_t N>
  void get(std::array<T, N>& x)
  {
    for (T& item : x)
      get(item);
  }
  template <typename T>
  void get(std::optional<T>& x)
  {
    if (size(0) == 0)
    {
      x.reset();
      return;
    }
    x.emplace();
    get(*x);
  }
  // A count of items of at least `least` bytes each; zero if there cannot be so many.
  std::uint64_t size(std::uint64_t least)
  {
    std::uint64_t n = 0;
    raw(&n, sizeof n);
    if (n * least > bytes_.size() - at_ || n > bytes_.size())
    {
      ok_ = false;
      return 0;
    }
    return n;
  }
  void raw(void* to, std::size_t n)
  {
    if (!ok_ || n > bytes_.size() - at_)
    {
      ok_ = false;
      return;
    }
    if (n > 0)
      std::memcpy(to, bytes_.data() + at_, n);
    at_ += n;
  }

  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

/// FNV-1a, 64 bit.
inline std::uint64_t checksum(const std::vector<std::uint8_t>& bytes)
{
  std::uint64_t sum = 14695981039346656037ull;
  for (const std::uint8_t byte : bytes)
    sum = (sum ^ byte) * 1099511628211ull;
  return sum;
}

/// Puts the checksum behind the bytes.
inline void appendChecksum(std::vector<std::uint8_t>& bytes)
{
  const std::uint64_t sum = checksum(bytes);
  for (int i = 0; i < 8; ++i)
    bytes.push_back(static_cast<std::uint8_t>(sum >> (8 * i)));
}

/// Accepts the checksum off. @return false, and the bytes are unusable, if it is not theirs.
inline bool verifyChecksum(std::vector<std::uint8_t>& bytes)
{
  if (bytes.size() < 8)
    return false;
  std::vector<std::uint8_t> content(bytes.begin(), bytes.end() - 8);
  std::vector<std::uint8_t> again = content;
  appendChecksum(again);
  const bool is_whole = again == bytes;
  bytes = std::move(content);
  return is_whole;
}

}  // namespace tether_monitor::core
