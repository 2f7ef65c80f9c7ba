#pragma once
// The door of the formulation room: the equations of theory.md, written once over a scalar T. Numbers make the generic
// runtime, symbols make the emitted programs. T offers + - * / sqrt sin cos ... select; comparisons on symbols do not
// compile.

#include "compiler/formulation/actuators_seen.hpp"
#include "compiler/formulation/closure.hpp"
#include "compiler/formulation/constants.hpp"
#include "compiler/formulation/driven.hpp"
#include "compiler/formulation/dynamics.hpp"
#include "compiler/formulation/inertia.hpp"
#include "compiler/formulation/kinematics.hpp"
#include "compiler/formulation/layout.hpp"
#include "compiler/formulation/loop_solution.hpp"
#include "compiler/formulation/motion.hpp"
#include "compiler/formulation/outputs.hpp"
#include "compiler/formulation/reactions.hpp"
#include "compiler/formulation/recursion/recursion.hpp"
#include "compiler/formulation/recursion/recursion_forces.hpp"
#include "compiler/formulation/solved_state.hpp"
