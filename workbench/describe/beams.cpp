#include "workbench/describe/beams.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/algebra/dense.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {
namespace {

constexpr double kStraight = 1e-6;  // rad
constexpr int kMostTried = 64;
constexpr double kSlender = 1e-9;  // rotary inertia of a mass at a node, where the section has none

/// Roots of the frequency equation for a pair of ends.
struct EndRoots {
  BeamEnd first, last;
  double roots[2];
};
constexpr EndRoots kRoots[] = {{BeamEnd::welded, BeamEnd::free, {1.875104068711961, 4.694091132974175}},
                               {BeamEnd::welded, BeamEnd::welded, {4.730040744862704, 7.853204624095838}},
                               {BeamEnd::free, BeamEnd::free, {4.730040744862704, 7.853204624095838}},
                               {BeamEnd::welded, BeamEnd::pinned, {3.926602312047919, 7.068582745628732}},
                               {BeamEnd::pinned, BeamEnd::free, {3.926602312047919, 7.068582745628732}},
                               {BeamEnd::pinned, BeamEnd::pinned, {std::numbers::pi, 2 * std::numbers::pi}}};

const EndRoots* roots_of(BeamEnd first, BeamEnd last) {
  for (const EndRoots& row : kRoots)
    if ((row.first == first && row.last == last) || (row.first == last && row.last == first)) return &row;
  return nullptr;
}

const char* name_of(BeamEnd end) {
  return end == BeamEnd::welded ? "welded" : end == BeamEnd::pinned ? "pinned" : "free";
}

double length_of(const Beam& beam) {
  double length = 0;
  for (std::size_t i = 1; i < beam.nodes.size(); ++i) length += norm(from_to(beam.nodes[i - 1], beam.nodes[i]));
  return length;
}

/// A beam of equal length, mass and stiffness in one plane: deflection and slope of each node.
struct PlaneBeam {
  double length = 1, line = 1, bending = 1, rotary = 0;  ///< m, kg/m, N m^2, kg m
  BeamEnd first = BeamEnd::free, last = BeamEnd::free;
};

/// Two lowest bending frequencies of a beam of n segments, rad/s: the bodies and connections that the reader makes.
std::array<double, 2> segmented(const PlaneBeam& beam, int n) {
  const double h = beam.length / n, half = beam.line * h / 2;
  const Eigen::Index size = 2 * (n + 1);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size), m = k;
  for (Eigen::Index e = 0; e < n; ++e) {
    Eigen::VectorXd shear = Eigen::VectorXd::Zero(size), turn = shear;
    shear.segment(2 * e, 4) << -1, -h / 2, 1, -h / 2;
    turn.segment(2 * e, 4) << 0, -1, 0, 1;
    k += 12 * beam.bending / (h * h * h) * shear * shear.transpose() + beam.bending / h * turn * turn.transpose();
  }
  for (Eigen::Index i = 0; i <= n; ++i) {
    const double halves = i == 0 || i == n ? 1 : 2, offset = i == 0 ? h / 6 : i == n ? -h / 6 : 0;
    m(2 * i, 2 * i) += halves * half;
    m(2 * i, 2 * i + 1) += half * offset;
    m(2 * i + 1, 2 * i) += half * offset;
    m(2 * i + 1, 2 * i + 1) +=
        half * offset * offset + halves * h / 2 * std::max(beam.rotary, kSlender * beam.line * h * h);
  }
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < size; ++i) {
    const BeamEnd end = i < 2 ? beam.first : i >= size - 2 ? beam.last : BeamEnd::free;
    if (end == BeamEnd::free || (end == BeamEnd::pinned && i % 2 == 1)) free.push_back(i);
  }
  const Eigen::MatrixXd stiffness = k(free, free), mass = m(free, free);
  const SymmetricEigenVectors inertia = symmetric_eigenvectors(mass);
  const Eigen::MatrixXd root = inertia.vectors * inertia.values.cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::VectorXd squares = symmetric_eigenvalues(root.transpose() * stiffness * root);
  const int rigid = (beam.first == BeamEnd::free) + (beam.last == BeamEnd::free) -
                    (beam.first == BeamEnd::welded || beam.last == BeamEnd::welded ? 1 : 0);
  std::array<double, 2> result{0, 0};
  for (int i = 0; i < 2; ++i)
    if (const Eigen::Index place = std::max(0, rigid) + i; place < squares.size())
      result[static_cast<std::size_t>(i)] = std::sqrt(std::max(0.0, squares[place]));
  return result;
}

BeamBending bending_of(const Beam& beam, char about, const PlaneBeam& plane, const EndRoots& roots) {
  BeamBending result{.about = about};
  const double unit = std::sqrt(plane.bending / plane.line) / (plane.length * plane.length) / (2 * std::numbers::pi);
  const std::array<double, 2> own = segmented(plane, static_cast<int>(beam.nodes.size()) - 1);
  for (std::size_t i = 0; i < 2; ++i) {
    result.exact[i] = roots.roots[i] * roots.roots[i] * unit;
    result.segmented[i] = own[i] / (2 * std::numbers::pi);
  }
  const std::array<double, 2> limit = segmented(plane, kMostTried);
  for (int n = 2; n <= kMostTried && result.segments_for_1_percent == 0; ++n) {
    const std::array<double, 2> found = segmented(plane, n);
    const auto is_near = [&](std::size_t i) { return std::abs(found[i] / limit[i] - 1) < 0.01; };
    if (is_near(0) && is_near(1)) result.segments_for_1_percent = n;
  }
  return result;
}

bool is_straight(const Beam& beam) {
  for (std::size_t i = 2; i < beam.nodes.size(); ++i)
    if (angle_between(from_to(beam.nodes[i - 2], beam.nodes[i - 1]), from_to(beam.nodes[i - 1], beam.nodes[i])) >
        kStraight)
      return false;
  return std::all_of(beam.supports.begin() + 1, beam.supports.end() - 1,
                     [](BeamEnd end) { return end == BeamEnd::free; });
}

}  // namespace

std::vector<BeamFrequencies> beam_frequencies(const Model& model) {
  std::vector<BeamFrequencies> all;
  for (const Beam& beam : model.beams) {
    BeamFrequencies found{.beam = &beam, .length = length_of(beam)};
    const double line = beam.material.density * beam.section.area;
    found.mass = line * found.length;
    found.ends = fmt::format("{}-{}", name_of(beam.supports.front()), name_of(beam.supports.back()));
    const EndRoots* roots = roots_of(beam.supports.front(), beam.supports.back());
    if (is_straight(beam) && roots) {
      for (const char about : {'y', 'z'}) {
        const double second = about == 'y' ? beam.section.iy : beam.section.iz;
        const PlaneBeam plane{found.length,
                              line,
                              beam.material.youngs_modulus * second,
                              beam.material.density * second,
                              beam.supports.front(),
                              beam.supports.back()};
        found.bending.push_back(bending_of(beam, about, plane, *roots));
      }
    }
    all.push_back(std::move(found));
  }
  return all;
}

std::string beams_text(const std::vector<BeamFrequencies>& beams) {
  std::string text;
  for (const BeamFrequencies& found : beams) {
    text += fmt::format("  beam {}: {} segments, {:.4g} m, {:.4g} kg, {}\n", found.beam->name,
                        found.beam->nodes.size() - 1, found.length, found.mass, found.ends);
    for (const BeamBending& bending : found.bending) {
      text +=
          fmt::format("    bending about {}: {:.5g} and {:.5g} Hz; of the whole beam {:.5g} and {:.5g} Hz",
                      bending.about, bending.segmented[0], bending.segmented[1], bending.exact[0], bending.exact[1]);
      text += bending.segments_for_1_percent > 0
                  ? fmt::format("; {} segments are right to 1 %\n", bending.segments_for_1_percent)
                  : "\n";
    }
  }
  return text;
}

nlohmann::ordered_json beams_json(const std::vector<BeamFrequencies>& beams) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const BeamFrequencies& found : beams) {
    Json bending = Json::array();
    for (const BeamBending& one : found.bending)
      bending.push_back({{"about", std::string(1, one.about)},
                         {"frequency", {one.segmented[0], one.segmented[1]}},
                         {"exact", {one.exact[0], one.exact[1]}},
                         {"segments_for_1_percent", one.segments_for_1_percent}});
    list.push_back({{"name", found.beam->name},
                    {"segments", found.beam->nodes.size() - 1},
                    {"length", found.length},
                    {"mass", found.mass},
                    {"ends", found.ends},
                    {"bending", std::move(bending)}});
  }
  return list;
}

}  // namespace mbgen
