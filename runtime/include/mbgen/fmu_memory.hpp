#pragma once
// Memory and texts of the functions of FMI 2 and 3, without the C library.

#include <atomic>

namespace mbgen::fmu {

/// Room for a fixed number of values, in static memory: an FMU may import no allocator, and the importers of FMI 3
/// offer none. Any thread may take and give.
template <class Value, int most>
class Pool {
 public:
  /// Null when all places are taken.
  void* take() noexcept {
    for (int i = 0; i < most; ++i) {
      if (!taken_[i].exchange(true, std::memory_order_acquire)) return memory_[i];
    }
    return nullptr;
  }

  /// Result: whether it was a place of this pool.
  bool give(void* place) noexcept {
    for (int i = 0; i < most; ++i) {
      if (place != memory_[i]) continue;
      taken_[i].store(false, std::memory_order_release);
      return true;
    }
    return false;
  }

 private:
  alignas(Value) unsigned char memory_[most][sizeof(Value)] = {};
  std::atomic<bool> taken_[most] = {};
};

/// Instances and saved runs that one FMU has at a time where the importer offers no memory.
constexpr int kMostInstances = 64, kMostSavedRuns = 1024;

inline bool is_same(const char* a, const char* b) noexcept {
  while (*a != 0 && *a == *b) ++a, ++b;
  return *a == *b;
}

/// A message of several parts, cut where it grows too long.
class Message {
 public:
  Message& add(const char* part) noexcept {
    while (*part != 0 && size_ + 1 < static_cast<int>(sizeof(text_))) text_[size_++] = *part++;
    text_[size_] = 0;
    return *this;
  }
  const char* text() const noexcept { return text_; }

 private:
  char text_[256] = {};
  int size_ = 0;
};

/// Categories of messages, by the names of the standard.
constexpr const char* kCategories[] = {"logStatusDiscard", "logStatusError"};

/// Bits of all categories.
constexpr unsigned kAllCategories = 3;

/// Switches the categories that are named on or off, all of them where none is named; the others stay as they are.
/// Result: whether all of them are known; nothing changes otherwise.
inline bool switch_categories(const char* const* names, unsigned long count, bool on, unsigned& categories) noexcept {
  if (count > 0 && names == nullptr) return false;
  unsigned named = count == 0 ? kAllCategories : 0u;
  for (unsigned long i = 0; i < count; ++i) {
    if (names[i] == nullptr) return false;
    const unsigned bit = is_same(names[i], kCategories[0]) ? 1u : is_same(names[i], kCategories[1]) ? 2u : 0u;
    if (bit == 0) return false;
    named |= bit;
  }
  categories = on ? categories | named : categories & ~named;
  return true;
}

/// Whether the processor has what this file was compiled for.
inline bool processor_fits() noexcept {
#if defined(__x86_64__) && defined(__AVX2__) && defined(__FMA__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

}  // namespace mbgen::fmu
