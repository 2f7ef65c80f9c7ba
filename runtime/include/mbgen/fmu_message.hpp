#pragma once
// Texts of the functions of FMI 2 and 3.

#include <cstddef>
#include <cstdio>

#include "mbgen/fmu.hpp"

namespace mbgen::fmu {

inline bool is_same(const char* a, const char* b) noexcept {
  while (*a != 0 && *a == *b) ++a, ++b;
  return *a == *b;
}

constexpr const char* name_of(unsigned mode) noexcept {
  constexpr const char* kModes[] = {"instantiated state",      "initialization mode", "event mode",
                                    "continuous-time mode",    "step mode",           "terminated state",
                                    "intermediate update mode"};
  for (int i = 0; i < 7; ++i) {
    if (mode == 1u << i) return kModes[i];
  }
  return "an unknown mode";
}

/// A message of several parts, cut where it grows too long.
class Message {
 public:
  Message& add(const char* part) noexcept {
    while (*part != 0 && size_ + 1 < static_cast<int>(sizeof(text_))) text_[size_++] = *part++;
    text_[size_] = 0;
    return *this;
  }
  Message& add(double number) noexcept {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.10g", number);
    return add(digits);
  }
  /// Why a call was refused; the variable by its name.
  template <class Model>
  Message& add_refusal(const Refusal& refusal) noexcept {
    if (refusal.has_variable) add_variable<Model>(refusal.variable).add(" ");
    if (refusal.subject != nullptr) add(refusal.subject).add(" ");
    add(refusal.reason);
    if (refusal.has_limit) add(" ").add(refusal.limit);
    if (refusal.has_value) add(", got ").add(refusal.value);
    return *this;
  }
  /// Failure of the solver's last call, and advice for the importer.
  template <class Model>
  Message& add_status(const Core<Model>& core) noexcept {
    const Code code = core.status.code;
    add(mbgen::text(code)).add(": ").add(Model::describe(core.status));
    if (core.run.mode == kContinuous && (code == Code::loop_not_closed || code == Code::loop_singular))
      add(", on the way from the last completed step or event; take a smaller step, or complete steps more often");
    return *this;
  }
  const char* text() const noexcept { return text_; }

 private:
  template <class Model>
  Message& add_variable(unsigned reference) noexcept {
    if (place_of<Model>(reference).group != Group::none) return add("\"").add(Model::kNames[reference]).add("\"");
    return add("value reference ").add(static_cast<double>(reference));
  }

  char text_[256] = {};
  int size_ = 0;
};

/// Categories of messages, by the names of the standard.
constexpr const char* kCategories[] = {"logStatusWarning", "logStatusDiscard", "logStatusError"};
constexpr unsigned kCategoryCount = sizeof(kCategories) / sizeof(kCategories[0]);

/// Bits of all categories.
constexpr unsigned kAllCategories = (1u << kCategoryCount) - 1;

/// Place of an answer among the categories.
constexpr unsigned category_of(Answer answer) noexcept {
  return answer == Answer::warning ? 0 : answer == Answer::discard ? 1 : 2;
}

/// Bits of the categories that are named, all of them where none is. Result: whether all of them are known.
inline bool find_categories(const char* const* names, unsigned long count, unsigned& named) noexcept {
  if (count > 0 && names == nullptr) return false;
  named = count == 0 ? kAllCategories : 0u;
  for (unsigned long i = 0; i < count; ++i) {
    unsigned category = 0;
    if (names[i] == nullptr) return false;
    while (category < kCategoryCount && !is_same(names[i], kCategories[category])) ++category;
    if (category == kCategoryCount) return false;
    named |= 1u << category;
  }
  return true;
}

/// Whether the processor has the instructions that this file was compiled for.
inline bool processor_fits() noexcept {
#if defined(__x86_64__) && defined(__AVX2__) && defined(__FMA__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

}  // namespace mbgen::fmu
