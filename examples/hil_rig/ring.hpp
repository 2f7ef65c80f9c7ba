#pragma once
// A queue from one thread to another that neither waits for: how messages leave the real-time thread.

#include <array>
#include <atomic>
#include <cstddef>

namespace hil_rig {

/// At most Size values wait; Size is a power of two. One writer and one reader.
template <class Value, std::size_t Size>
class Ring {
  static_assert((Size & (Size - 1)) == 0, "the size is a power of two");

 public:
  /// Called by the writer. Result: whether there was room.
  bool push(const Value& value) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == Size) return false;
    values_[end % Size] = value;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// Called by the reader. Result: whether there was a value.
  bool pop(Value& value) noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return false;
    value = values_[begin % Size];
    begin_.store(begin + 1, std::memory_order_release);
    return true;
  }

 private:
  std::array<Value, Size> values_{};
  alignas(64) std::atomic<std::size_t> begin_{0};
  alignas(64) std::atomic<std::size_t> end_{0};
};

}  // namespace hil_rig
