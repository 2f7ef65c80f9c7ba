#pragma once
// Arrays of doubles or floats several at a time: vectors as wide as the processor's (the vector_size extension of GCC
// and clang). The result for an entry does not depend on the lanes that compute it, except in a Total. Numbers that are
// structs are taken one at a time.

#include <cstddef>
#include <type_traits>

namespace mbgen {

namespace array_detail {

#if defined(__AVX512F__)
constexpr int kVectorBytes = 64;
#elif defined(__AVX__)
constexpr int kVectorBytes = 32;
#else
constexpr int kVectorBytes = 16;
#endif

/// Lanes of the processor's vectors.
template <class Real = double>
constexpr int kLanes = std::is_class_v<Real> ? 1 : kVectorBytes / static_cast<int>(sizeof(Real));

template <int W, class Real = double, class = void>
struct Vector {
  using Lanes __attribute__((vector_size(8 * W))) = double;
  /// Lanes at the address of doubles, with their alignment.
  using InArray __attribute__((vector_size(8 * W), aligned(8), may_alias)) = double;
};
template <int W>
struct Vector<W, float> {
  using Lanes __attribute__((vector_size(4 * W))) = float;
  using InArray __attribute__((vector_size(4 * W), aligned(4), may_alias)) = float;
};
template <class Real>
struct Vector<1, Real, std::enable_if_t<std::is_class_v<Real>>> {
  using Lanes = Real;
  using InArray = Real;
};
template <int W, class Real = double>
using LanesOf = typename Vector<W, Real>::Lanes;

/// Lanes for an array of so many entries: as many as the processor has and the array fills, 1 for fewer than two.
template <class Real = double>
constexpr int width_for(std::size_t entries) noexcept {
  int width = kLanes<Real>;
  while (width > 1 && static_cast<std::size_t>(width) > entries) width /= 2;
  return width;
}

template <int W, class Real>
[[gnu::always_inline]] inline LanesOf<W, Real> lanes_at(const Real* values) noexcept {
  return *reinterpret_cast<const typename Vector<W, Real>::InArray*>(values);
}
template <class L, class Real>
[[gnu::always_inline]] inline void put_lanes(const L& lanes, Real* values) noexcept {
  constexpr int width = static_cast<int>(sizeof(L) / sizeof(Real));
  *reinterpret_cast<typename Vector<width, Real>::InArray*>(values) = lanes;
}

template <class L>
[[gnu::always_inline]] inline auto lane_of(const L& lanes, [[maybe_unused]] int lane) noexcept {
  if constexpr (std::is_class_v<L> || std::is_same_v<L, bool>)
    return lanes;
  else
    return lanes[lane];
}

/// Calls `several` with the first index of W = width_for(N) entries until all N have been met; the last call ends with
/// the array and may meet entries again. Calls `one` for a single entry.
template <std::size_t N, class Real = double, class Several, class One>
[[gnu::always_inline]] inline void for_all(Several several, One one) noexcept {
  constexpr std::size_t width = width_for<Real>(N);
  if constexpr (N == 1) {
    one(0);
  } else {
    for (std::size_t i = 0; i < N; i += width) several(i + width <= N ? i : N - width);
  }
}

}  // namespace array_detail

/// to = from; the arrays must not overlap.
template <class Real, std::size_t N>
[[gnu::always_inline]] inline void copy_array(const Real (&from)[N], Real (&to)[N]) noexcept {
  using namespace array_detail;
  for_all<N, Real>([&](std::size_t i) { put_lanes(lanes_at<width_for<Real>(N)>(from + i), to + i); },
                   [&](std::size_t i) { to[i] = from[i]; });
}

/// Sum of arrays, in no order that counts: not finite when an entry is not.
template <class Real>
class Total {
 public:
  explicit Total(Real start) noexcept : rest_(start) {}

  [[gnu::always_inline]] void add(const Real* values, int count) noexcept {
    using namespace array_detail;
    constexpr int width = kLanes<Real>;
    int i = 0;
    if constexpr (width == 1) {
      // Two sums at a time: an addition waits for the one before it.
      for (; i + 2 <= count; i += 2) {
        lanes_ += lanes_at<width>(values + i);
        rest_ += values[i + 1];
      }
    }
    for (; i + width <= count; i += width) lanes_ += lanes_at<width>(values + i);
    for (; i < count; ++i) rest_ += values[i];
  }

  [[gnu::always_inline]] Real value() const noexcept {
    Real total = rest_;
    for (int lane = 0; lane < array_detail::kLanes<Real>; ++lane) total += array_detail::lane_of(lanes_, lane);
    return total;
  }

 private:
  array_detail::LanesOf<array_detail::kLanes<Real>, Real> lanes_ = {};
  Real rest_;
};

/// Whether every entry is above zero; a NaN is not.
template <class Real>
[[gnu::always_inline]] inline bool all_positive(const Real* values, int count) noexcept {
  using namespace array_detail;
  constexpr int width = kLanes<Real>;
  auto above = LanesOf<width, Real>{} == 0;
  for (int i = 0; i + width <= count; i += width) above &= lanes_at<width>(values + i) > 0;
  bool all = true;
  for (int lane = 0; lane < width; ++lane) all = all && lane_of(above, lane) != 0;
  for (int i = count - count % width; i < count; ++i) all = all && values[i] > 0;
  return all;
}

}  // namespace mbgen
