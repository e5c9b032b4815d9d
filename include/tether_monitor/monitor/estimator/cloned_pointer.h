#pragma once

#include <memory>
#include <utility>

namespace tether_monitor::monitor
{
/// Owns an object of a class with clone(), write() and read(); copying the pointer copies the object.
template <class T>
class ClonedPointer
{
 public:
  explicit ClonedPointer(std::unique_ptr<T> object) : object_(std::move(object)) {}
  ClonedPointer(const ClonedPointer& other) : object_(other.object_->clone()) {}
  ClonedPointer(ClonedPointer&&) noexcept = default;
  ClonedPointer& operator=(const ClonedPointer& other)
  {
    object_ = other.object_->clone();
    return *this;
  }
  ClonedPointer& operator=(ClonedPointer&&) noexcept = default;
  ~ClonedPointer() = default;

  T& operator*() { return *object_; }
  const T& operator*() const { return *object_; }
  T* operator->() { return object_.get(); }
  const T* operator->() const { return object_.get(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    if constexpr (Archive::READS)
      object_->read(a);
    else
      object_->write(a);
  }

 private:
  std::unique_ptr<T> object_;
};

}  // namespace tether_monitor::monitor
