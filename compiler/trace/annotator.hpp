#pragma once
// The formulation's origins and names, written into a program under construction.

#include <cmath>

#include "compiler/formulation/annotator.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// Whether a traced value is the constant zero.
inline bool is_zero(const Expr& value) { return value.is_constant() && value.constant() == 0.0; }

/// Size of a traced constant, 0 of a value that is only known at run time.
inline double known_size(const Expr& value) { return value.is_constant() ? std::abs(value.constant()) : 0.0; }

template <>
struct Annotator<Expr> {
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
    if (value.is_constant() && value.builder_of_name() == nullptr) return;
    std::string text;
    (text.append(parts), ...);
    if (value.is_constant())
      builder.name_fold(value.name(), text);
    else
      label(value.value(builder), text);
  }
  /// A number that follows from tunable parameters is a value like others.
  template <class... Parts>
  void constant(Expr& value, const Parts&... parts) {
    std::string text;
    (text.append(parts), ...);
    if (!value.is_constant()) {
      builder.label(value.value(builder), text);
    } else if (value.builder_of_name() != nullptr) {
      builder.name_fold(value.name(), text);
    } else {
      value = value.named(builder.name_constant(value.constant(), text), &builder);
    }
  }
  template <class... Parts>
  void detail(const Expr& value, const Parts&... parts) {
    if (builder.is_for_reading()) name(value, parts...);
  }
  bool has_details() const { return builder.is_for_reading(); }
  template <class... Parts>
  void detail_by(const Expr& number, const Expr& form, const Parts&... parts) {
    if (!builder.is_for_reading()) return;
    const bool are_folds = number.builder_of_name() == &builder && form.builder_of_name() == &builder;
    if (are_folds && number.constant() == form.constant()) {
      name(form, parts...);
      builder.equate_folds(number.name(), form.name());
    } else {
      name(number, parts...);
    }
  }
  template <class... Parts>
  void bound(Expr& value, const char* note, const Parts&... parts) {
    if (!builder.is_for_reading()) return;
    constant(value, parts...);
    if (value.is_constant() && value.name() >= 0) builder.explain_constant(value.name(), note);
  }
  /// Users of a negative take the value itself: for reading it is named as its negative.
  void label(ValueId value, const std::string& text) {
    builder.label(value, text);
    const Node& node = builder.node(value);
    if (builder.is_for_reading() && node.op == Op::negate) builder.label(node.operands[0], "minus_" + text);
  }
  [[nodiscard]] Scope detail_within(OwnerKind kind, std::size_t index) {
    if (builder.is_for_reading()) return within(kind, index);
    return {builder, builder.section(), builder.owner()};
  }
};

}  // namespace mbgen
