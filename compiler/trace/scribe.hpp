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
  void place(const std::string& title) { builder.set_block(title); }
  template <class... Parts>
  void name(const Expr& value, const Parts&... parts) {
    if (value.is_constant()) return;
    std::string text;
    (text.append(parts), ...);
    builder.label(value.value(builder), text);
  }
};

}  // namespace mbgen
