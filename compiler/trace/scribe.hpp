#pragma once
// The formulation's origins and names, written into a program under construction.

#include <cmath>

#include "compiler/formulation/scribe.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// Whether a traced value is the constant zero.
inline bool is_zero(const Expr& value) { return value.is_constant() && value.constant() == 0.0; }

/// Size of a traced constant, 0 of a value that is only known at run time.
inline double known_size(const Expr& value) { return value.is_constant() ? std::abs(value.constant()) : 0.0; }

template <>
struct Scribe<Expr> {
  ProgramBuilder& builder;
  /// Goes back to the origin before.
  class Scope {
   public:
    Scope(ProgramBuilder& builder, const Section& section, const Owner& owner)
        : builder_(builder), section_(builder.section()), owner_(builder.owner()) {
      builder.set_section(section);
      builder.set_owner(owner);
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() {
      builder_.set_section(section_);
      builder_.set_owner(owner_);
    }

   private:
    ProgramBuilder& builder_;
    Section section_;
    Owner owner_;
  };
  [[nodiscard]] Scope step(Step step, int block = -1) { return {builder, {step, block}, {}}; }
  [[nodiscard]] Scope within(OwnerKind kind, std::size_t index) {
    return {builder, builder.section(), {kind, static_cast<int>(index)}};
  }
  template <class... Parts>
  void name(const Expr& value, const Parts&... parts) {
    if (value.is_constant()) return;
    std::string text;
    (text.append(parts), ...);
    builder.label(value.value(builder), text);
  }
  /// A number that follows from tunable parameters is a value like others.
  template <class... Parts>
  void constant(Expr& value, const Parts&... parts) {
    std::string text;
    (text.append(parts), ...);
    if (value.is_constant()) {
      value = value.named(builder.name_constant(value.constant(), text));
    } else {
      builder.label(value.value(builder), text);
    }
  }
};

}  // namespace mbgen
