#pragma once

#include <span>
#include <string>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Values that depend on inputs of one group alone leave the programs: they become inputs of Array::derived, and the
/// result is the program `name` that gives them, each value once for all programs. Values that are no more than an
/// input of the group, or its negative, stay. Operations are neither added nor put in another order.
///   %0 = input par[0]; %1 = input z[0]; %2 = mul %0 %0; %3 = mul %2 %1
///   =>   %0 = input derived[0]; %1 = input z[0]; %2 = mul %0 %1     and     %0 = input par[0]; %1 = mul %0 %0
Program take_out_derived(std::span<Program* const> programs, SlotGroup group, const std::string& name);

}  // namespace mbgen
