#pragma once

#include <cstdint>
#include <string_view>

namespace asts {

/// FNV-1a (Fowler, Noll, Vo), 64 bits: a hash of a text that is the same on every machine, for names and for noticing
/// accidents.
constexpr std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3ULL;
  return hash;
}

}  // namespace asts
