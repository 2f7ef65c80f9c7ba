#include "compiler/program/slot.hpp"

#include <fmt/format.h>

namespace mbgen {

const char* name_of(Array array) {
  constexpr const char* kNames[] = {"Jz",
                                    "Phi",
                                    "Rz",
                                    "actuation",
                                    "c",
                                    "charts",
                                    "derived",
                                    "direction",
                                    "drift",
                                    "drive",
                                    "driven_acceleration",
                                    "due",
                                    "dz",
                                    "energy",
                                    "force",
                                    "held",
                                    "hold",
                                    "in",
                                    "inertia",
                                    "lambda",
                                    "law_argument",
                                    "law_result",
                                    "missing",
                                    "par",
                                    "pivot",
                                    "place",
                                    "position",
                                    "power",
                                    "rate",
                                    "required",
                                    "residual",
                                    "seed",
                                    "slope",
                                    "step",
                                    "state_pivot",
                                    "t",
                                    "tangent",
                                    "tau",
                                    "x",
                                    "xd",
                                    "y",
                                    "z",
                                    "zd",
                                    "zdd",
                                    "zdd_star"};
  static_assert(std::size(kNames) == static_cast<std::size_t>(Array::zdd_star) + 1);
  return kNames[static_cast<std::size_t>(array)];
}

std::string text_of(const SlotGroup& group) {
  std::string text;
  for (int i = 0; i < group.derivative; ++i) text += "d_";
  text += name_of(group.array);
  return group.block < 0 ? text : text + std::to_string(group.block);
}

std::string text_of(const Slot& slot) { return fmt::format("{}[{}]", text_of(slot.group), slot.index); }

}  // namespace mbgen
