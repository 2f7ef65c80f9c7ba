#pragma once
// The door of the passes room: the passes, each with its contract, and the list of them in order.
// A pass is a pure function Program -> Program. Every pass keeps name, outputs, sections, owners and labels, and
// verifies its result. Each states its factor of error: the most that it may make of the error of the outputs before
// it, the root of its mean square around a state. tests/system/lowering/rounding_test.cpp holds it to that.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compiler/solver/programs.hpp"

namespace mbgen {

/// Removes values and inputs that no output needs. Ensures: the same outputs bit for bit, the same order of what
/// remains. Factor of error: 1.
///   %0 = input z[0]; %1 = sin %0; %2 = cos %0; out zdd[0] = %1   =>   %0 = input z[0]; %1 = sin %0; out zdd[0] = %1
Program remove_dead_values(Program program);

/// Values that are equal by algebra, up to sign, become one, the first of them; zeros leave. See identities.hpp for
/// equality by algebra. Ensures: values equal up to rounding. Factor of error: 2.
///   %2 = mul %0 %1; %3 = mul %2 %0; %4 = mul %0 %0; %5 = mul %4 %1   =>   %5 is %3
Program merge_equal_values(const Program& program);

/// A value whose operations nothing else needs becomes one sum, difference or product of earlier values where it is
/// equal to that by algebra (identities.hpp) and fewer operations are left. Factor of error: 2, of the bound of each
/// form at two ordinary states. A program with pairs stays as it is.
///   %3 = mul %0 %1; %4 = mul %0 %2; %5 = mul %4 %1, out %3, out %5   =>   %5 = mul %3 %2, %4 is dead
Program write_shorter_forms(const Program& program);

/// Three or more divisions by one value become one reciprocal and products: a division costs several products.
/// Ensures: each replaced quotient within 1.5 units in the last place while the reciprocal is a normal number; the
/// reciprocal stands where the first of the divisions stood. Leaves single reciprocals as they are. A division by a
/// constant is a product with its reciprocal, however often. Factor of error: 2.
///   %4 = div %0 %3; %5 = div %1 %3; %6 = div %2 %3
///   =>   %4 = constant 1; %5 = div %4 %3; %6 = mul %0 %5; %7 = mul %1 %5; %8 = mul %2 %5
Program merge_divisions(const Program& program);

/// Approximate bytes of code of a program without calls, with products fused into sums, for the comparison of programs
/// with the same values.
long size_of_code(const Program& program);

/// Writes every sum as one chain: terms that cancel leave it, constants become one, a factor that several products
/// share is taken out, plain terms come before products so that each product fuses with an addition. A sum is what
/// additions, subtractions and negations of unnamed values of one use make; named values stay as they are. Ensures:
/// fewer operations or as many; values equal up to rounding. Factor of error: 2, of the bound of each sum at two
/// ordinary states, where its largest term comes last, or it stays as it stands, for that. Only where the operands of
/// a sum are known to no digit does neither help.
///   %3 = mul %0 %1; %4 = mul %0 %2; %5 = add %3 %4   =>   %3 = add %1 %2; %4 = mul %0 %3
Program factor_sums(const Program& program);

/// Values that depend on inputs of one group alone leave the programs: they become inputs of Array::derived, and the
/// result is the program `name` that gives them, each value once for all programs. Values that are no more than an
/// input of the group, or its negative, stay. Operations are neither added nor put in another order. Factor of error:
/// 1.
///   %0 = input par[0]; %1 = input z[0]; %2 = mul %0 %0; %3 = mul %2 %1
///   =>   %0 = input derived[0]; %1 = input z[0]; %2 = mul %0 %1     and     %0 = input par[0]; %1 = mul %0 %0
Program take_out_derived(std::span<Program* const> programs, SlotGroup group, const std::string& name);

/// Products that only sums and differences need go into all of them, rounded once: the choice that compilers make in
/// contracting, each in its own way, made here for all of them. Of two such products in one sum the later one goes, so
/// that the sum waits for one operation less. Labelled products and outputs stay.
/// Ensures: every other value as it was; each contracted one with one rounding less. A product of several sums counts
/// in each of them. Factor of error: 1 of bounds, 2 of an error that happened to be small.
///   %3 = mul %0 %1; %4 = sub %2 %3   =>   %3 = submul %2 %0 %1
Program contract(const Program& program);

/// A program and its derivatives in two programs: the first one runs once for as many directions as the second one has
/// in its vectors.
struct DerivativesApart {
  Program values;  ///< the program, and the slopes that the derivatives need as outputs of Array::slope
  Program along;   ///< takes slopes, values of inputs and the derivatives of inputs, gives the derivatives of outputs
  int slopes = 0;
};

/// Takes the derivatives of a program apart. Every operation of `along` is linear in derivatives, which have the groups
/// derivative_of(group) of their values. moves: whether an input has a derivative. is_wanted: whether the derivative of
/// an output is; one that is 0 is no output. Pairs remain in `values`; `along` has numbers, contracted. At kinks the
/// side counts that the value takes; a slope without bound counts where its argument moves. slope_cost: of an operation
/// on slopes, over one on derivatives; derivatives on the way are passed over where that is cheaper.
///   %2 = mul %0 %1, out zdd[0]   =>   the same, and   %4 = mul %1 d_z[1]; %5 = muladd %0 d_z[0] %4, out d_zdd[0]
DerivativesApart take_derivatives_apart(const Program& program, const std::function<bool(const Slot&)>& moves,
                                        const std::function<bool(const Slot&)>& is_wanted, double slope_cost = 1);

/// A slot, and the one that takes its place.
struct SlotPlace {
  Slot slot, place;
};

/// The transpose of a program that is linear in the inputs `columns`: of a weight for each row, an output at its place
/// among the inputs, the weighted sum of the rows' derivatives by each column, at its place among the outputs. The same
/// operations, from the results to the direction. Fails: std::logic_error for a program that is not linear, or for an
/// output that is no row.
///   %2 = mul %0 d_z[1], out d_zdd[0]   =>   %2 = mul %0 d_zdd[0], out d_z[1]
Program transposed(const Program& linear, const std::vector<SlotPlace>& rows, const std::vector<SlotPlace>& columns);

/// The adjoint of a program: it takes the values that the program takes and a weight of each output, as
/// derivative_of(group), and gives the derivative of the weighted sum of the outputs by each input, likewise. moves:
/// whether an input has one; is_weighted: whether an output has a weight; is_kept: whether an output is given as well.
/// One pass, from the outputs to the inputs, over the slopes of take_derivatives_apart: a slope without bound is not
/// finite here, though its argument may stand still. Contracted. Requires: a program without pairs.
Program adjoint(const Program& program, const std::function<bool(const Slot&)>& moves,
                const std::function<bool(const Slot&)>& is_weighted, const std::function<bool(const Slot&)>& is_kept);

/// The same values in the order of the paper's steps, each step once, and in a step from one part of the mechanism to
/// the next as far as operands allow. Dead values and inputs leave. Ensures: the same outputs bit for bit. Factor of
/// error: 1.
Program in_reading_order(const Program& program);

/// The programs of a text for people: neither merged nor contracted, with no derived constants. Requires: traced for
/// reading.
WrittenPrograms written_for_reading(Programs programs);

/// One pass over all programs of a solver. run: pure.
struct WholePass {
  const char* name;  ///< of the stage: --dump=NAME
  WholePrograms (*run)(WholePrograms, const AlikeInputs&);
};
struct WrittenPass {
  const char* name;
  WrittenPrograms (*run)(WrittenPrograms);
};

/// The two lists are the architecture: every decision about a program before it is arranged into functions. Derivatives
/// are taken of whole programs, written ones are rounded and ordered as the C++ text is.
std::span<const WholePass> whole_passes();
std::span<const WrittenPass> written_passes();

/// The passes of whole programs on all of them, without a word.
WholePrograms optimise(WholePrograms whole, const AlikeInputs& alike = {});
/// The same on one program.
Program optimise(const Program& program);

/// The programs without values of tunable parameters alone, which become the derived constants: what runs is counted
/// so.
Programs with_derived_constants(Programs programs);

}  // namespace mbgen
