#pragma once
// A value that one thread writes and another takes over whole, without waiting on either side.

#include <atomic>

namespace mbgen {

/// Three buffers: one of the writer, one of the reader, one between them. A published value is taken whole or not at
/// all; of several values published between two takes the last one counts. One writer and one reader at a time.
template <class Value>
class Exchange {
 public:
  /// Called by the writer.
  void publish(const Value& value) noexcept {
    buffers_[writers_] = value;
    writers_ = between_.exchange(writers_ | kFresh, std::memory_order_acq_rel) & kPlace;
  }

  /// Called by the reader. Result: whether there is a value that it has not taken.
  bool has_new() const noexcept { return (between_.load(std::memory_order_relaxed) & kFresh) != 0; }

  /// Called by the reader. Result: whether there was a value that it had not taken.
  bool take(Value& value) noexcept {
    if (!has_new()) return false;
    readers_ = between_.exchange(readers_, std::memory_order_acq_rel) & kPlace;
    value = buffers_[readers_];
    return true;
  }

 private:
  static constexpr unsigned kPlace = 3, kFresh = 4;
  Value buffers_[3] = {};
  unsigned writers_ = 0, readers_ = 1;
  std::atomic<unsigned> between_{2};
};

}  // namespace mbgen
