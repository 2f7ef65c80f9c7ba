#include "compiler/analysis/analysis_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace mbgen {
namespace {

template <class T>
concept Plain = std::is_arithmetic_v<T>;

/// Appends values to `bytes`.
struct BytesOut {
  std::string bytes;

  template <Plain T>
  void take(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void take(const std::string& text) {
    take(static_cast<std::uint64_t>(text.size()));
    bytes += text;
  }
  template <class T>
  void take(const std::vector<T>& values) {
    take(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) take(value);
  }
  template <class T>
  void take(const T& value) {
    each_field(*this, value);
  }
};

/// Takes values from the front of `bytes`. After the first that is not there all are as they were.
struct BytesIn {
  std::string_view bytes;
  bool is_good = true;

  template <Plain T>
  void take(T& value) {
    is_good = is_good && bytes.size() >= sizeof value;
    if (!is_good) return;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
  }
  /// A number of things of at least a byte each, 0 where so many cannot follow.
  std::uint64_t count() {
    std::uint64_t number = 0;
    take(number);
    is_good = is_good && number <= bytes.size();
    return is_good ? number : 0;
  }
  void take(std::string& text) {
    const std::uint64_t size = count();
    text = bytes.substr(0, size);
    bytes.remove_prefix(size);
  }
  template <class T>
  void take(std::vector<T>& values) {
    values.resize(count());
    for (T& value : values) take(value);
  }
  void take(std::vector<bool>& values) {
    values.resize(count());
    for (std::size_t i = 0; i < values.size(); ++i) {
      bool value = false;
      take(value);
      values[i] = value;
    }
  }
  template <class T>
  void take(T& value) {
    each_field(*this, value);
  }
};

template <class Bytes, class... Fields>
void take_all(Bytes& bytes, Fields&... fields) {
  (bytes.take(fields), ...);
}

/// T, as Bytes takes it.
template <class Bytes, class T>
using Of = std::conditional_t<std::is_same_v<Bytes, BytesOut>, const T, T>;

// The bindings do not compile when a struct has another number of members.

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, Pivot>& value) {
  auto& [equation, coordinate, reference] = value;
  take_all(bytes, equation, coordinate, reference);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, LoopPartition>& value) {
  auto& [dependent, independent, driven, pivots] = value;
  take_all(bytes, dependent, independent, driven, pivots);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, ActuatedDirections>& value) {
  auto& [partitions, held] = value;
  take_all(bytes, partitions, held);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, RankCount>& value) {
  auto& [rank, configurations] = value;
  take_all(bytes, rank, configurations);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, SingularConfiguration>& value) {
  auto& [rank, times, z] = value;
  take_all(bytes, rank, times, z);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, RedundantEquation>& value) {
  auto& [equation, loop, name, meaning, residual] = value;
  take_all(bytes, equation, loop, name, meaning, residual);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, Certificate>& value) {
  auto& [closed, reach, ranks, singular, kept, dropped, steps, redundant, immobile, freedoms] = value;
  take_all(bytes, closed, reach, ranks, singular, kept, dropped, steps, redundant, immobile, freedoms);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, LateRows>& value) {
  auto& [equations, early_rank] = value;
  take_all(bytes, equations, early_rank);
}

// A struct with a base has no bindings.

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, PartitionCandidate>& value) {
  Of<Bytes, LoopPartition>& partition = value;
  take_all(bytes, partition, value.triangular_sizes, value.worst_pivot_ratio, value.score, value.estimate, value.traced,
           value.operations, value.symmetric);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, BlockAnalysis>& value) {
  Of<Bytes, LoopPartition>& partition = value;
  take_all(bytes, partition, value.rank, value.late, value.redundant_equations, value.redundant_names,
           value.triangular_sizes, value.typical_pivot, value.worst_pivot_ratio, value.certificate, value.quasi,
           value.candidates, value.chosen, value.first_alike, value.chosen_like);
}

template <class Bytes>
void each_field(Bytes& bytes, Of<Bytes, Analysis>& value) {
  auto& [closed, independent, ranks, freedoms, position_freedoms, blocks, driven, motion_of, directions, actuation,
         typical_actuation, unactuated] = value;
  take_all(bytes, closed, independent, ranks, freedoms, position_freedoms, blocks, driven, motion_of, directions,
           actuation, typical_actuation, unactuated);
}

}  // namespace

std::string bytes_of(const Analysis& analysis) {
  BytesOut out;
  out.take(analysis);
  return std::move(out.bytes);
}

std::optional<Analysis> analysis_of_bytes(std::string_view bytes) {
  BytesIn in{bytes};
  Analysis analysis;
  in.take(analysis);
  if (!in.is_good || !in.bytes.empty()) return std::nullopt;
  return analysis;
}

}  // namespace mbgen
