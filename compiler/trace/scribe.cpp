#include "compiler/trace/scribe.hpp"

namespace mbgen {

void Scribe<Expr>::step(Step step, const std::string& part) {
  static constexpr const char* kMultipliers = "step 9: multipliers of the closures and driving forces";
  static constexpr const char* kOutputs = "step 9: outputs, energies, power";
  static const char* const kTitles[] = {"step 1: poses, axes b, accumulated inertias MR (50)",
                                        "step 2: closure Jacobian Phi_z and its factors (60)",
                                        "step 3: Rz (61)",
                                        "step 4: velocities Z (36)",
                                        "step 5: applied forces Q (48)",
                                        "step 6: c and dRz/dt zd (62)",
                                        "step 7: accelerations Zdot and accumulated forces QR - PR (51), (52)",
                                        "step 8: Rz' M Rz and right-hand side (63)",
                                        "step 9: independent and all accelerations (63), (62)",
                                        kMultipliers,
                                        kOutputs};
  static const char* const kRecursiveTitles[] = {"step 1: poses and axes b",
                                                 "step 2: closure Jacobian Phi_z and its factors (60)",
                                                 "step 3: Rz (61)",
                                                 "step 4: velocities",
                                                 "step 5: applied forces Q (48)",
                                                 "step 6: c and dRz/dt zd (62)",
                                                 "step 7: inertias of the bodies and forces on joints",
                                                 "step 8: elimination from the leaves to the root (63)",
                                                 "step 9: accelerations from the root to the leaves (63), (62)",
                                                 kMultipliers,
                                                 kOutputs};
  const std::string title = (form == Form::matrix ? kTitles : kRecursiveTitles)[static_cast<int>(step) - 1];
  builder.set_section(part.empty() ? title : title + ", " + part);
  builder.set_block("");
}

}  // namespace mbgen
