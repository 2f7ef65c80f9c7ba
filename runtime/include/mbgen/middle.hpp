#pragma once
// Structs by the address of their middle: instructions of x86-64 reach 128 bytes either way of an address by a
// displacement of one byte in place of four, so that twice as many members are near.

namespace mbgen {

/// Bytes of a struct before its middle; none of a small one.
template <class Struct>
constexpr int kBytesBefore = sizeof(Struct) > 128 ? 128 : 0;

/// Stands where the middle of a Struct is.
template <class Struct>
struct Middle {
  char place;
};

template <class Struct>
[[gnu::always_inline]] inline Middle<Struct>& middle_of(Struct& whole) noexcept {
  return *reinterpret_cast<Middle<Struct>*>(reinterpret_cast<char*>(&whole) + kBytesBefore<Struct>);
}

/// The struct again. Requires: a result of middle_of.
template <class Struct>
[[gnu::always_inline]] inline Struct& whole_of(Middle<Struct>& middle) noexcept {
  return *reinterpret_cast<Struct*>(reinterpret_cast<char*>(&middle) - kBytesBefore<Struct>);
}

}  // namespace mbgen
