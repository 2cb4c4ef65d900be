#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace zenosphere {

/// Allocates large blocks on huge pages where the system offers them. What is read at random over
/// hundreds of megabytes spends a good part of its time on looking up pages of four kilobytes.
template <class T>
struct HugePages {
  using value_type = T;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t count) {
    constexpr std::size_t page = std::size_t{1} << 21;
    constexpr std::size_t cache_line = 64;
    if (count > static_cast<std::size_t>(-1) / sizeof(T) - page) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    const std::size_t alignment = bytes < page ? cache_line : page;
    void* const block = std::aligned_alloc(alignment, (bytes / alignment + 1) * alignment);
    if (block == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (alignment == page) madvise(block, bytes, MADV_HUGEPAGE);  // a wish: without it all is well
#endif
    return static_cast<T*>(block);
  }
  void deallocate(T* block, std::size_t) { std::free(block); }

  friend bool operator==(const HugePages&, const HugePages&) { return true; }
};

/// A vector that may be large and is read at random.
template <class T>
using HugePageVector = std::vector<T, HugePages<T>>;

}  // namespace zenosphere
