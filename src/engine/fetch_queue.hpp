#pragma once

#include <array>
#include <cstdint>

namespace zenosphere {

/// Of more spheres than this, what the next events need is fetched ahead of time.
constexpr std::int32_t most_spheres_in_cache = 20000;

/// Fetches a line of memory that is wanted at once.
inline void fetch_at_once(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");  // GCC leaves out calls of a function that only fetches: it has no effect
}

/// Lines of memory that will be read soon, fetched into the cache little by little.
///
/// A processor fetches about a dozen lines at a time. Where a hundred are asked for at once, it
/// waits for most of them; asked for a few at a time, between the steps of a computation, they come
/// while it computes. Nothing but the speed depends on it.
class FetchQueue {
 public:
  void add(const void* address) {
    if (size() == most) fetch(1);
    addresses_[end_++ % most] = address;
  }

  /// Adds the addresses of `count` things, if there is room for so many at all.
  ///
  /// \param address  of the thing with a number from 0 on
  template <class Address>
  void add_each(std::uint32_t count, Address address) {
    if (size() + count > most) {
      if (count > most) return;
      fetch(size() + count - most);
    }
    const std::uint32_t end = end_;
    for (std::uint32_t k = 0; k < count; ++k) addresses_[(end + k) % most] = address(k);
    end_ = end + count;
  }

  /// Asks for the next `count` of them, or for all if there are fewer.
  void fetch(std::uint32_t count) {
    if (begin_ == end_) return;  // always in a small system
    if (count > size()) count = size();
    for (; count > 0; --count) fetch_at_once(addresses_[begin_++ % most]);
  }

  /// Asks for the next few, between two steps of a computation.
  void fetch_a_few() { fetch(4); }

  std::uint32_t size() const { return end_ - begin_; }

 private:
  static constexpr std::uint32_t most = 256;

  std::array<const void*, most> addresses_{};
  std::uint32_t begin_ = 0;  ///< counted on and on, as is the end
  std::uint32_t end_ = 0;
};

}  // namespace zenosphere
