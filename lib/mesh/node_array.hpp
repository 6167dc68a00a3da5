#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace asts {

/// A vector of plain values that grows by realloc: the system moves the pages of a large array to a new address
/// instead of copying what is on them, which std::vector cannot ask for. Throws std::bad_alloc.
template <typename T>
class NodeArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  NodeArray() = default;
  NodeArray(const NodeArray& other) {
    reserve(other.size_);
    size_ = other.size_;
    if (size_ > 0) std::memcpy(static_cast<void*>(data_), other.data_, size_ * sizeof(T));
  }
  NodeArray(NodeArray&& other) noexcept { swap(other); }
  NodeArray& operator=(NodeArray other) noexcept {
    swap(other);
    return *this;
  }
  ~NodeArray() { std::free(data_); }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

  void push_back(const T& value) {
    const T copy = value;  // it may be an element of this array
    if (size_ == capacity_) reserve(std::max<std::size_t>(16, 2 * capacity_));
    data_[size_++] = copy;
  }

  void reserve(std::size_t capacity) {
    if (capacity <= capacity_) return;
    void* data = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
    if (data == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(data);
    capacity_ = capacity;
  }

 private:
  void swap(NodeArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace asts
