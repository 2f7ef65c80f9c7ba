#pragma once
// Arrays of doubles several at a time: vectors as wide as the processor's (the vector_size extension of GCC and clang).
// What an operation gives for an entry does not depend on the lanes it is computed in, except in a Total.

#include <cstddef>

namespace mbgen {

namespace array_detail {

#if defined(__AVX512F__)
constexpr int kLanes = 8;
#elif defined(__AVX__)
constexpr int kLanes = 4;
#else
constexpr int kLanes = 2;
#endif
typedef double Lanes __attribute__((vector_size(8 * kLanes)));
/// Lanes where doubles stand: as little aligned as they are.
typedef double LanesInArray __attribute__((vector_size(8 * kLanes), aligned(8), may_alias));

[[gnu::always_inline]] inline Lanes lanes_at(const double* values) noexcept {
  return *reinterpret_cast<const LanesInArray*>(values);
}
[[gnu::always_inline]] inline void put_lanes(const Lanes& lanes, double* values) noexcept {
  *reinterpret_cast<LanesInArray*>(values) = lanes;
}

/// Calls `several` with the first index of kLanes entries until all N have been met; the last call ends with the array
/// and may meet entries again. Calls `one` for each entry where there are fewer than kLanes.
template <std::size_t N, class Several, class One>
[[gnu::always_inline]] inline void for_all(Several several, One one) noexcept {
  if constexpr (N < kLanes) {
    for (std::size_t i = 0; i < N; ++i) one(i);
  } else {
    for (std::size_t i = 0; i + kLanes <= N; i += kLanes) several(i);
    if constexpr (N % kLanes != 0) several(N - kLanes);
  }
}

}  // namespace array_detail

/// to = from; the arrays must not overlap.
template <std::size_t N>
[[gnu::always_inline]] inline void copy_array(const double (&from)[N], double (&to)[N]) noexcept {
  using namespace array_detail;
  for_all<N>([&](std::size_t i) { put_lanes(lanes_at(from + i), to + i); }, [&](std::size_t i) { to[i] = from[i]; });
}

/// Sum of arrays, in no order that counts: not finite when an entry is not.
class Total {
 public:
  explicit Total(double start) noexcept : rest_(start) {}

  [[gnu::always_inline]] void add(const double* values, int count) noexcept {
    using namespace array_detail;
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) lanes_ += lanes_at(values + i);
    for (; i < count; ++i) rest_ += values[i];
  }

  [[gnu::always_inline]] double value() const noexcept {
    double total = rest_;
    for (int lane = 0; lane < array_detail::kLanes; ++lane) total += lanes_[lane];
    return total;
  }

 private:
  array_detail::Lanes lanes_ = {};
  double rest_;
};

}  // namespace mbgen
