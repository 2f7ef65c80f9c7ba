#pragma once
// Rows of a batch: one number of every instance, as one or several vectors of the processor. Programs work on the
// vectors of one group of instances at a time; iterations and integrators on whole rows.

#include <cstddef>
#include <type_traits>

#include "mbgen/lanes.hpp"
#include "mbgen/lanes/array_lanes.hpp"

namespace mbgen {

/// Lanes of the vectors that a row of so many numbers is cut into: the processor's, and not more than the row has.
/// Compilers write wider vectors than the processor's through memory.
constexpr int lanes_of_vectors(int row) noexcept { return row < array_detail::kLanes<> ? row : array_detail::kLanes<>; }

/// Vectors side by side. Arithmetic, comparisons and masks go vector by vector; a plain number counts for every lane.
template <class Vector, int G>
struct VectorRow {
  using Element = decltype(Vector{}[0] + Vector{}[0]);
  typedef Element InRow __attribute__((may_alias));

  Vector part[G];

  InRow& operator[](int lane) noexcept { return reinterpret_cast<InRow*>(part)[lane]; }
  Element operator[](int lane) const noexcept { return reinterpret_cast<const InRow*>(part)[lane]; }
};

/// A row of G vectors: the vector itself where there is one.
template <class Vector, int G>
using RowOf = std::conditional_t<G == 1, Vector, VectorRow<Vector, G>>;

/// Numbers or masks of one group of a row.
template <class Row>
struct VectorsOf {
  using Vector = Row;
  static constexpr int kGroups = 1;
};
template <class V, int G>
struct VectorsOf<VectorRow<V, G>> {
  using Vector = V;
  static constexpr int kGroups = G;
};

template <class Vector, int G>
[[gnu::always_inline]] inline Vector& part_of(VectorRow<Vector, G>& row, int group) noexcept {
  return row.part[group];
}
template <class Vector, int G>
[[gnu::always_inline]] inline const Vector& part_of(const VectorRow<Vector, G>& row, int group) noexcept {
  return row.part[group];
}
/// A vector is the one group of its row; a plain number counts for every group.
template <class Vector>
[[gnu::always_inline]] inline Vector& part_of(Vector& value, int /*group*/) noexcept {
  return value;
}

namespace rows_detail {

template <class Value>
constexpr bool kIsRow = false;
template <class Vector, int G>
constexpr bool kIsRow<VectorRow<Vector, G>> = true;

template <class A, class B = A>
constexpr int kGroupsOf = VectorsOf<A>::kGroups > VectorsOf<B>::kGroups ? VectorsOf<A>::kGroups : VectorsOf<B>::kGroups;

template <class Vector>
using Plain = std::remove_cv_t<std::remove_reference_t<Vector>>;

/// The row of function(parts of the arguments).
template <int G, class Function, class... Arguments>
[[gnu::always_inline]] inline auto by_parts(Function function, const Arguments&... arguments) noexcept {
  VectorRow<Plain<decltype(function(part_of(arguments, 0)...))>, G> row;
  for (int g = 0; g < G; ++g) row.part[g] = function(part_of(arguments, g)...);
  return row;
}

template <class A, class B>
using IfRow = std::enable_if_t<kIsRow<A> || kIsRow<B>>;

}  // namespace rows_detail

template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator+(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x + y; }, a, b);
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator-(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x - y; }, a, b);
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator*(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x * y; }, a, b);
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator/(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x / y; }, a, b);
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator<(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x < y; }, a, b);
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator>(const A& a, const B& b) noexcept {
  return b < a;
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator<=(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x <= y; }, a, b);
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator>=(const A& a, const B& b) noexcept {
  return b <= a;
}
template <class A, class B, class = rows_detail::IfRow<A, B>>
[[gnu::always_inline]] inline auto operator==(const A& a, const B& b) noexcept {
  return rows_detail::by_parts<rows_detail::kGroupsOf<A, B>>([](const auto& x, const auto& y) { return x == y; }, a, b);
}
template <class Vector, int G>
[[gnu::always_inline]] inline auto operator&(const VectorRow<Vector, G>& a, const VectorRow<Vector, G>& b) noexcept {
  return rows_detail::by_parts<G>([](const auto& x, const auto& y) { return x & y; }, a, b);
}
template <class Vector, int G>
[[gnu::always_inline]] inline auto operator|(const VectorRow<Vector, G>& a, const VectorRow<Vector, G>& b) noexcept {
  return rows_detail::by_parts<G>([](const auto& x, const auto& y) { return x | y; }, a, b);
}
template <class Vector, int G>
[[gnu::always_inline]] inline auto operator~(const VectorRow<Vector, G>& a) noexcept {
  return rows_detail::by_parts<G>([](const auto& x) { return ~x; }, a);
}
template <class Vector, int G, class B>
[[gnu::always_inline]] inline VectorRow<Vector, G>& operator+=(VectorRow<Vector, G>& a, const B& b) noexcept {
  return a = a + b;
}
template <class Vector, int G, class B>
[[gnu::always_inline]] inline VectorRow<Vector, G>& operator&=(VectorRow<Vector, G>& a, const B& b) noexcept {
  return a = a & b;
}
template <class Vector, int G, class B>
[[gnu::always_inline]] inline VectorRow<Vector, G>& operator|=(VectorRow<Vector, G>& a, const B& b) noexcept {
  return a = a | b;
}

template <class Mask, class Vector, int G>
[[gnu::always_inline]] inline auto choose(const VectorRow<Mask, G>& mask, const VectorRow<Vector, G>& chosen,
                                          const VectorRow<Vector, G>& other) noexcept {
  return rows_detail::by_parts<G>([](const auto& m, const auto& x, const auto& y) { return choose(m, x, y); }, mask,
                                  chosen, other);
}

template <class Vector, int G>
[[gnu::always_inline]] inline auto abs(const VectorRow<Vector, G>& a) noexcept {
  return rows_detail::by_parts<G>([](const auto& x) { return mbgen::abs(x); }, a);
}

/// The lanes of a group in a row of plain numbers.
template <class Vector, int W>
[[gnu::always_inline]] inline Vector load_group(const double (&row)[W], int group) noexcept {
  constexpr int width = kLanesOf<Vector>;
  return *reinterpret_cast<const typename LaneTypes<width>::InArray*>(row + group * width);
}

/// A whole row of plain numbers, and back.
template <class Row, int W>
[[gnu::always_inline]] inline Row load_row(const double (&from)[W]) noexcept {
  Row row;
  for (int g = 0; g < VectorsOf<Row>::kGroups; ++g)
    part_of(row, g) = load_group<typename VectorsOf<Row>::Vector>(from, g);
  return row;
}
template <class Row, int W>
[[gnu::always_inline]] inline void store_row(const Row& row, double (&to)[W]) noexcept {
  constexpr int width = W / VectorsOf<Row>::kGroups;
  for (int g = 0; g < VectorsOf<Row>::kGroups; ++g)
    *reinterpret_cast<typename LaneTypes<width>::InArray*>(to + g * width) = part_of(row, g);
}

/// A struct of arrays of plain numbers as the struct of the same arrays of rows, without a copy.
template <class Rows, class Plain>
[[gnu::always_inline]] inline const Rows& as_rows(const Plain& plain) noexcept {
  static_assert(sizeof(Rows) == sizeof(Plain) && alignof(Rows) <= alignof(Plain));
  return reinterpret_cast<const Rows&>(plain);
}

/// One struct of vectors for every group of instances: programs read it, iterations only pass it on.
template <class Struct, int G>
struct Grouped {
  Struct group[G];
};

namespace rows_detail {

/// A struct of rows as one struct of vectors per group; without a copy if a row is one vector.
template <template <class> class Struct, class Row>
class InGroups {
 public:
  using Vector = typename VectorsOf<Row>::Vector;
  static constexpr int kGroups = VectorsOf<Row>::kGroups;
  static constexpr std::size_t kRows = sizeof(Struct<Row>) / sizeof(Row);
  static_assert(sizeof(Struct<Vector>) == kRows * sizeof(Vector));

  explicit InGroups(const Struct<Row>& rows) noexcept {
    const Row* from = reinterpret_cast<const Row*>(&rows);
    for (int g = 0; g < kGroups; ++g) {
      Vector* to = reinterpret_cast<Vector*>(&groups_[g]);
      for (std::size_t i = 0; i < kRows; ++i) to[i] = part_of(from[i], g);
    }
  }
  const Struct<Vector>* groups() const noexcept { return groups_; }

 private:
  Struct<Vector> groups_[kGroups];
};

template <template <class> class Struct, class Vector>
class AsItIs {
 public:
  explicit AsItIs(const Struct<Vector>& rows) noexcept : rows_(rows) {}
  const Struct<Vector>* groups() const noexcept { return &rows_; }

 private:
  const Struct<Vector>& rows_;
};

template <template <class> class Struct, class Vector, int G>
InGroups<Struct, VectorRow<Vector, G>> in_groups(const Struct<VectorRow<Vector, G>>& rows) noexcept {
  return InGroups<Struct, VectorRow<Vector, G>>(rows);
}
template <template <class> class Struct, class Vector, class = std::enable_if_t<!kIsRow<Vector>>>
AsItIs<Struct, Vector> in_groups(const Struct<Vector>& rows) noexcept {
  return AsItIs<Struct, Vector>(rows);
}

template <class Struct, int G>
class StoredGroups {
 public:
  explicit StoredGroups(const Grouped<Struct, G>& all) noexcept : all_(all) {}
  const Struct* groups() const noexcept { return all_.group; }

 private:
  const Grouped<Struct, G>& all_;
};
template <class Struct, int G>
StoredGroups<Struct, G> in_groups(const Grouped<Struct, G>& all) noexcept {
  return StoredGroups<Struct, G>(all);
}

template <template <class> class Struct, class Vector, int G>
void join(const Struct<Vector> (&groups)[G], Struct<VectorRow<Vector, G>>& rows) noexcept {
  using Row = VectorRow<Vector, G>;
  Row* to = reinterpret_cast<Row*>(&rows);
  for (int g = 0; g < G; ++g) {
    const Vector* from = reinterpret_cast<const Vector*>(&groups[g]);
    for (std::size_t i = 0; i < sizeof rows / sizeof(Row); ++i) to[i].part[g] = from[i];
  }
}

}  // namespace rows_detail

/// Runs a program of all groups: program(arguments of every group..., results of every group). arguments: structs of
/// rows, or Grouped.
template <class Program, template <class> class Result, class Row, class... Arguments>
void run_groups(Program program, Result<Row>& result, const Arguments&... arguments) noexcept {
  using namespace rows_detail;
  if constexpr (kIsRow<Row>) {
    Result<typename VectorsOf<Row>::Vector> results[VectorsOf<Row>::kGroups];
    program(in_groups(arguments).groups()..., results);
    join(results, result);
  } else {
    program(in_groups(arguments).groups()..., &result);
  }
}

}  // namespace mbgen
