#pragma once

#include <cstddef>
#include <vector>

namespace tether_monitor::monitor
{
/// The last N things, oldest first. A thing that goes leaves its memory to the one that comes.
template <typename T>
class Ring
{
 public:
  explicit Ring(std::size_t capacity) : slots_(capacity) {}

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return slots_.size(); }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return slots_[(first_ + i) % slots_.size()]; }
  const T& operator[](std::size_t i) const { return slots_[(first_ + i) % slots_.size()]; }
  T& back() { return (*this)[size_ - 1]; }
  const T& front() const { return (*this)[0]; }
  /// Room for one more, with the content of an old one; the oldest goes if there is none.
  T& extend()
  {
    if (size_ == slots_.size())
      first_ = (first_ + 1) % slots_.size();
    else
      ++size_;
    return back();
  }
  /// Keeps the oldest `count`.
  void truncate(std::size_t count) { size_ = count < size_ ? count : size_; }
  /// Forgets the oldest.
  void dropFront()
  {
    first_ = (first_ + 1) % slots_.size();
    --size_;
  }
  void clear() { first_ = size_ = 0; }
  /// Every slot, used or not.
  std::vector<T>& slots() { return slots_; }
  bool isSound(std::size_t capacity) const
  {
    return slots_.size() == capacity && (first_ < capacity || first_ == 0) && size_ <= capacity;
  }

  template <class Archive>
  void archive(Archive& a)
  {
    a(first_, size_, slots_);
  }

 private:
  std::vector<T> slots_;
  std::size_t first_ = 0, size_ = 0;
};

}  // namespace tether_monitor::monitor
