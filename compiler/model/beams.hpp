#pragma once
// Beams as the reader made them: bodies at nodes, elastic connections between them. For checks: bodies and bushings
// move the model.

#include <string>
#include <vector>

#include "compiler/model/bodies.hpp"
#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// Properties of a cross-section in axes y and z through its centre.
struct BeamSection {
  double area = 0;               ///< m^2
  double iy = 0, iz = 0, j = 0;  ///< m^4: of bending about y and about z, of torsion
};

struct BeamMaterial {
  double youngs_modulus = 0, shear_modulus = 0, density = 0;  ///< Pa, Pa, kg/m^3
};

/// Support of a node.
enum class BeamEnd { free, pinned, welded };

struct Beam {
  std::string name;
  Where where;
  BeamSection section;
  BeamMaterial material;
  std::vector<Vector3> nodes;     ///< m, global axes at the reference
  std::vector<BeamEnd> supports;  ///< per node
};

}  // namespace mbgen
