#pragma once
// The formulation's titles and names, written into a program under construction.

#include <cmath>

#include "compiler/formulation/scribe.hpp"
#include "compiler/program/program.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {

/// Whether a traced value is the constant zero.
inline bool is_zero(const Expr& value) { return value.is_constant() && value.constant() == 0.0; }

/// Size of a traced constant, 0 of a value that is only known at run time.
inline double known_size(const Expr& value) { return value.is_constant() ? std::abs(value.constant()) : 0.0; }

template <>
struct Scribe<Expr> {
  ProgramBuilder& builder;
  Form form = Form::matrix;
  void step(Step step, const std::string& part = "");
  /// Goes back to the heading before.
  class Heading {
   public:
    Heading(ProgramBuilder& builder, const std::string& title) : builder_(builder), before_(builder.block()) {
      builder.set_block(title);
    }
    Heading(const Heading&) = delete;
    Heading& operator=(const Heading&) = delete;
    ~Heading() { builder_.set_block(before_); }

   private:
    ProgramBuilder& builder_;
    std::string before_;
  };
  [[nodiscard]] Heading within(const std::string& title) { return {builder, title}; }
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
