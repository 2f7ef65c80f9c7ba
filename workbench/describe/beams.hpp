#pragma once
// First bending frequencies of a model's beams: of the segments, and of the whole beam.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Two lowest bending frequencies in one plane, Hz.
struct BeamBending {
  char about = 'y';                ///< axis of the section
  double segmented[2] = {};        ///< of the beam's bodies and connections
  double exact[2] = {};            ///< of the Euler-Bernoulli beam
  int segments_for_1_percent = 0;  ///< fewest with which both err by less than 1 %; 0: more than 64
};

struct BeamFrequencies {
  const Beam* beam = nullptr;
  double length = 0, mass = 0;  ///< m, kg
  std::string ends = {};        ///< "welded-free"
  std::vector<BeamBending> bending =
      {};  ///< about y and z; empty where there is no closed form: bends, supports between
};

/// Of every beam, by itself: supports on bodies at rest, without loads at its points. Source of the closed
/// forms: omega = (beta l)^2 sqrt(EI/(rho A l^4)), roots of the frequency equations (S. Timoshenko, Vibration Problems
/// in Engineering).
std::vector<BeamFrequencies> beam_frequencies(const Model& model);

std::string beams_text(const std::vector<BeamFrequencies>& beams);
nlohmann::ordered_json beams_json(const std::vector<BeamFrequencies>& beams);

}  // namespace mbgen
