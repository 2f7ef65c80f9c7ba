#pragma once
// From a model of mbgen to what acts on it.

#include "compiler/text/diagnostic.hpp"
#include "tests/system/oracle/force_elements.hpp"

namespace mbgen::foreign {

/// Springs, air springs, bushings, bump stops, joint springs, frictions, applied and joint forces and motions of a
/// model at its default parameters and inputs; an input with a derivative moves from its default at t = 0. Derivatives
/// of motions are by differences in extended precision, good to 1e-13 of the motion's own size, and owe nothing to
/// mbgen's derivatives. Fails: where the model has tyres, or bushings with Maxwell branches, each with its place: no
/// foreign solver here knows them.
Result<ForceElements> force_elements_of(const Model& model, const Topology& topology);

/// Values of the inputs at a time when they have their defaults at t = 0 and go on by their derivatives.
std::vector<double> inputs_at(const Model& model, double t);

}  // namespace mbgen::foreign
