#pragma once

#include <cstddef>
#include <vector>

namespace tether_monitor::monitor
{
/// The last N things, oldest first. A thing that goes leaves its memory to the one that comes.
template <typename T>
class RingBuffer
{
 public:
  explicit RingBuffer(std::size_t capacity) : storage_(capacity) {}

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return storage_.size(); }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return storage_[(first_ + i) % storage_.size()]; }
  const T& operator[](std::size_t i) const { return storage_[(first_ + i) % storage_.size()]; }
  T& back() { return (*this)[size_ - 1]; }
  const T& back() const { return (*this)[size_ - 1]; }
  const T& front() const { return (*this)[0]; }
  /// Room for one more, with the content of an old one; the oldest goes if there is none.
  T& emplaceBack()
  {
    if (size_ == storage_.size())
      first_ = (first_ + 1) % storage_.size();
    else
      ++size_;
    return back();
  }
  /// Keeps the oldest `count`.
  void resizeTo(std::size_t count) { size_ = count < size_ ? count : size_; }
  /// Forgets the oldest.
  void popFront()
  {
    first_ = (first_ + 1) % storage_.size();
    --size_;
  }
  void clear() { first_ = size_ = 0; }
  /// Every slot, used or not.
  std::vector<T>& storage() { return storage_; }
  bool isValid(std::size_t capacity) const
  {
    return storage_.size() == capacity && (first_ < capacity || first_ == 0) && size_ <= capacity;
  }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(first_, size_, storage_);
  }

 private:
  std::vector<T> storage_;
  std::size_t first_ = 0, size_ = 0;
};

}  // namespace tether_monitor::monitor
