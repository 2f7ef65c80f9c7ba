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

template <int W>
struct Vector {
  using Lanes __attribute__((vector_size(8 * W))) = double;
  /// Lanes where doubles stand: as little aligned as they are.
  using InArray __attribute__((vector_size(8 * W), aligned(8), may_alias)) = double;
};
template <int W>
using LanesOf = typename Vector<W>::Lanes;
using Lanes = LanesOf<kLanes>;

/// Lanes for an array of so many entries: as many as the processor has and the array fills, 1 for fewer than two.
constexpr int width_for(std::size_t entries) noexcept {
  int width = kLanes;
  while (width > 1 && static_cast<std::size_t>(width) > entries) width /= 2;
  return width;
}

template <int W = kLanes>
[[gnu::always_inline]] inline LanesOf<W> lanes_at(const double* values) noexcept {
  return *reinterpret_cast<const typename Vector<W>::InArray*>(values);
}
template <class L>
[[gnu::always_inline]] inline void put_lanes(const L& lanes, double* values) noexcept {
  constexpr int width = static_cast<int>(sizeof(L) / sizeof(double));
  *reinterpret_cast<typename Vector<width>::InArray*>(values) = lanes;
}

/// Calls `several` with the first index of W = width_for(N) entries until all N have been met; the last call ends with
/// the array and may meet entries again. Calls `one` for a single entry.
template <std::size_t N, class Several, class One>
[[gnu::always_inline]] inline void for_all(Several several, One one) noexcept {
  constexpr std::size_t width = width_for(N);
  if constexpr (N == 1) {
    one(0);
  } else {
    for (std::size_t i = 0; i + width <= N; i += width) several(i);
    if constexpr (N % width != 0) several(N - width);
  }
}

}  // namespace array_detail

/// to = from; the arrays must not overlap.
template <std::size_t N>
[[gnu::always_inline]] inline void copy_array(const double (&from)[N], double (&to)[N]) noexcept {
  using namespace array_detail;
  for_all<N>([&](std::size_t i) { put_lanes(lanes_at<width_for(N)>(from + i), to + i); },
             [&](std::size_t i) { to[i] = from[i]; });
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
