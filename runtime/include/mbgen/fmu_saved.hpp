#pragma once
// Saved runs of an instance of FMI 2 or 3, and their bytes.

#include <cstring>

#include "mbgen/fmu/fmu_state.hpp"

namespace mbgen::fmu {

/// A saved run in the list of its instance.
template <class Model>
struct Saved {
  Run<Model> run;
  Saved* next = nullptr;
};

/// The run that a pointer of the importer's means, null where this instance has made none there.
template <class Model>
Saved<Model>* find_saved(Saved<Model>* first, const void* pointer) noexcept {
  while (first != nullptr && first != pointer) first = first->next;
  return first;
}

/// Removes a run from the list. Requires: the list contains it.
template <class Model>
void remove_saved(Saved<Model>*& first, const Saved<Model>* one) noexcept {
  Saved<Model>** place = &first;
  while (*place != one) place = &(*place)->next;
  *place = one->next;
}

/// Why a pointer is refused.
constexpr const char* kForeignState = "the state is none of this instance's, or was freed";

/// Takes over a saved run. Answer: error for one of the other interface.
template <class Model>
Answer restore(const Run<Model>& saved, Core<Model>& core) noexcept {
  if (saved.interface != core.run.interface) {
    core.refusal.reason = "the state is one of the other interface, co-simulation or model exchange";
    return Answer::error;
  }
  core.run = saved;
  core.is_solved = false;
  core.evaluations.has_front = false;
  core.evaluations.count = 0;
  return Answer::ok;
}

/// FNV-1a, 64 bits.
inline unsigned long long checksum(const unsigned char* bytes, unsigned long size) noexcept {
  unsigned long long hash = 0xcbf29ce484222325u;
  for (unsigned long i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
  return hash;
}

/// Bytes of a saved run: the model's token, the run, and a checksum of the run.
template <class Model>
constexpr unsigned long kSerialisedSize = sizeof(Model::kToken) + sizeof(Run<Model>) + sizeof(unsigned long long);

template <class Model, class Byte>
Answer serialise(const Run<Model>& saved, Byte* bytes, unsigned long size) noexcept {
  static_assert(sizeof(Byte) == 1);
  if (bytes == nullptr || size < kSerialisedSize<Model>) return Answer::error;
  const auto* source = reinterpret_cast<const unsigned char*>(&saved);
  const unsigned long long sum = checksum(source, sizeof(saved));
  std::memcpy(bytes, Model::kToken, sizeof(Model::kToken));
  std::memcpy(bytes + sizeof(Model::kToken), source, sizeof(saved));
  std::memcpy(bytes + sizeof(Model::kToken) + sizeof(saved), &sum, sizeof(sum));
  return Answer::ok;
}

/// Result: null, or why these bytes are no run of this model.
template <class Model, class Byte>
const char* deserialise(const Byte* bytes, unsigned long size, Run<Model>& saved) noexcept {
  static_assert(sizeof(Byte) == 1);
  if (bytes == nullptr || size != kSerialisedSize<Model>) return "the bytes have another size than a state of this FMU";
  if (std::memcmp(bytes, Model::kToken, sizeof(Model::kToken)) != 0) return "the bytes are a state of another FMU";
  unsigned char run[sizeof(saved)];
  unsigned long long sum = 0;
  std::memcpy(run, bytes + sizeof(Model::kToken), sizeof(saved));
  std::memcpy(&sum, bytes + sizeof(Model::kToken) + sizeof(saved), sizeof(sum));
  if (sum != checksum(run, sizeof(run))) return "the bytes are damaged: their checksum is another";
  std::memcpy(static_cast<void*>(&saved), run, sizeof(saved));
  return nullptr;
}

}  // namespace mbgen::fmu
