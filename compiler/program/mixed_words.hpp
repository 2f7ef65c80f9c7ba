#pragma once
// Words that look random and follow from others alone, on every machine: splitmix64.

#include <cstdint>

namespace mbgen {

constexpr std::uint64_t kStepOfWords = 0x9e3779b97f4a7c15u;

/// A hash with one more word mixed into it.
constexpr std::uint64_t mixed_word(std::uint64_t hash, std::uint64_t word) {
  hash += word + kStepOfWords;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

/// Number `number` of the sequence.
constexpr std::uint64_t random_word(std::uint64_t number) { return mixed_word(number * kStepOfWords, 0); }

}  // namespace mbgen
