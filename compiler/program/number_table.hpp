#pragma once
// Numbers that are found again by hashes: the tables behind shared values and known functions.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mbgen {

/// Numbers by the upper halves of hashes, side by side in one array that is half full at most: a look-up takes one line
/// of the cache, and the array, in the order of the hashes, grows in one pass.
class NumberTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// A number that was inserted with this half of a hash and that `is_same` accepts, or kNone.
  template <class IsSame>
  std::uint32_t find(std::uint64_t hash, const IsSame& is_same) const {
    const auto half = static_cast<std::uint32_t>(hash >> 32);
    for (std::size_t i = half >> shift_; slots_[i].number != kNone; i = next(i))
      if (slots_[i].half == half && is_same(slots_[i].number)) return slots_[i].number;
    return kNone;
  }

  void insert(std::uint64_t hash, std::uint32_t number) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    put(slots_, shift_, {static_cast<std::uint32_t>(hash >> 32), number});
    ++count_;
  }

  /// Makes room for so many numbers.
  void reserve(std::size_t count) {
    std::size_t size = slots_.size();
    unsigned shift = shift_;
    for (; 2 * count > size; size *= 2) --shift;
    if (size > slots_.size()) resize(size, shift);
  }

 private:
  struct Slot {
    std::uint32_t half = 0, number = kNone;
  };
  static constexpr unsigned kLeastBits = 6;

  static std::size_t next(std::size_t i, std::size_t size) { return i + 1 == size ? 0 : i + 1; }
  std::size_t next(std::size_t i) const { return next(i, slots_.size()); }
  static void put(std::vector<Slot>& slots, unsigned shift, const Slot& slot) {
    std::size_t i = slot.half >> shift;
    while (slots[i].number != kNone) i = next(i, slots.size());
    slots[i] = slot;
  }
  void grow() { resize(2 * slots_.size(), shift_ - 1); }
  void resize(std::size_t size, unsigned shift) {
    std::vector<Slot> larger(size);
    for (const Slot& slot : slots_)
      if (slot.number != kNone) put(larger, shift, slot);
    slots_ = std::move(larger);
    shift_ = shift;
  }

  unsigned shift_ = 32 - kLeastBits;
  std::size_t count_ = 0;
  std::vector<Slot> slots_ = std::vector<Slot>(std::size_t{1} << kLeastBits);
};

}  // namespace mbgen
