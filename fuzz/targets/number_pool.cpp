// GMP's numbers from free lists while the differential target is fuzzed. Its time would else go into the sanitizer's
// malloc: two thirds of it, measured. Limbs that leak are not seen here; the other targets have no pool.

#include <gmp.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

constexpr std::size_t kLimb = 8;
constexpr std::size_t kLargest = 8 * kLimb;  // larger numbers are rare, and malloc's
constexpr std::size_t kArena = std::size_t{1} << 20;

struct Free {
  Free* next;
};

std::array<Free*, kLargest / kLimb + 1> free_lists{};
char* arena = nullptr;
std::size_t arena_left = 0;

std::size_t limbs(std::size_t size) { return (size + kLimb - 1) / kLimb; }

void* allocate(std::size_t size) {
  if (size > kLargest) return std::malloc(size);
  Free*& list = free_lists[limbs(size)];
  if (list != nullptr) {
    Free* block = list;
    list = block->next;
    return block;
  }
  if (arena_left < kLargest) {
    arena = static_cast<char*>(std::malloc(kArena));
    arena_left = kArena;
  }
  void* block = arena;
  arena += limbs(size) * kLimb;
  arena_left -= limbs(size) * kLimb;
  return block;
}

void release(void* block, std::size_t size) {
  if (size > kLargest) return std::free(block);
  Free*& list = free_lists[limbs(size)];
  list = new (block) Free{list};
}

void* reallocate(void* block, std::size_t size, std::size_t wanted) {
  if (size > kLargest && wanted > kLargest) return std::realloc(block, wanted);
  void* moved = allocate(wanted);
  std::memcpy(moved, block, size < wanted ? size : wanted);
  release(block, size);
  return moved;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  mp_set_memory_functions(allocate, reallocate, release);
  return 0;
}
