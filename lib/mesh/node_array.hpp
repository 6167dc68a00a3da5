#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace asts {

/// What all node arrays together hold in pages of their own, which mallinfo() does not know of, in bytes.
inline std::atomic<std::size_t> node_array_pages{0};

/// A vector of plain values for arrays that get large and are read all over: from 8 MB on it asks the system for large
/// pages. Throws std::bad_alloc.
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
  ~NodeArray() { release(); }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

  void push_back(const T& value) {
    const T copy = value;  // it may be an element of this array
    if (size_ == capacity_) reserve(std::max<std::size_t>(16, 2 * capacity_));
    data_[size_++] = copy;
  }

  /// New values are not set. REQUIRES: size <= capacity().
  void resize_unset(std::size_t size) { size_ = size; }

  void reserve(std::size_t capacity) {
    if (capacity <= capacity_) return;
    if (capacity * sizeof(T) >= kLarge) {
      move_to_large_pages(capacity);
    } else {
      void* data = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
      if (data == nullptr) throw std::bad_alloc();
      data_ = static_cast<T*>(data);
    }
    capacity_ = capacity;
  }

 private:
  static constexpr std::size_t kPage = std::size_t{1} << 21;
  static constexpr std::size_t kLarge = 4 * kPage;

  /// Pages of 2 MB where the system has them: a search through a large tree misses the table of small ones at every
  /// step. To grow, pages are moved, not what is in them.
  void move_to_large_pages(std::size_t capacity) {
    const std::size_t bytes = (capacity * sizeof(T) + kPage - 1) / kPage * kPage;
    void* const place = aligned_range(bytes);
    const int fixed = MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED;
    void* const data = pages_ > 0 ? mremap(data_, pages_, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, place)
                                  : mmap(place, bytes, PROT_READ | PROT_WRITE, fixed, -1, 0);
    if (data == MAP_FAILED) {
      munmap(place, bytes);
      throw std::bad_alloc();
    }
    madvise(data, bytes, MADV_HUGEPAGE);  // advice: it may fail
    if (pages_ == 0 && size_ > 0) std::memcpy(data, data_, size_ * sizeof(T));
    if (pages_ == 0) std::free(data_);
    data_ = static_cast<T*>(data);
    node_array_pages += bytes - pages_;
    pages_ = bytes;
  }

  /// A range of addresses that begins where a large page may, without memory.
  static void* aligned_range(std::size_t bytes) {
    void* const range = mmap(nullptr, bytes + kPage, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (range == MAP_FAILED) throw std::bad_alloc();
    const std::size_t before = (kPage - reinterpret_cast<std::uintptr_t>(range) % kPage) % kPage;
    char* const place = static_cast<char*>(range) + before;
    if (before > 0) munmap(range, before);
    munmap(place + bytes, kPage - before);
    return place;
  }

  void release() {
    if (pages_ > 0) {
      munmap(data_, pages_);
      node_array_pages -= pages_;
    } else {
      std::free(data_);
    }
  }

  void swap(NodeArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(pages_, other.pages_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  std::size_t pages_ = 0;  ///< bytes of pages that are this array's own; 0: it comes from malloc
};

}  // namespace asts
