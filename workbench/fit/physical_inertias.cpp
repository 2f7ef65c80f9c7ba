#include "workbench/fit/physical_inertias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"

namespace mbgen::fit {
namespace {

using Matrix = Eigen::Matrix3d;
constexpr int kRow[6] = {0, 1, 2, 1, 2, 2}, kColumn[6] = {0, 1, 2, 0, 0, 1};  // of the lower triangle

/// The unknown that an entry of an inertia is, -1 for none.
int physical_unknown(const Model& model, const Quantity& entry, const std::vector<Unknown>& unknowns) {
  if (entry.expression < 0) return -1;
  const std::vector<ExpressionNode>& nodes = model.expressions[static_cast<std::size_t>(entry.expression)].nodes;
  if (nodes.size() != 1 || nodes.front().kind != ExpressionNode::Kind::parameter) return -1;
  const std::string& name = model.parameters[static_cast<std::size_t>(nodes.front().index)].name;
  for (std::size_t u = 0; u < unknowns.size(); ++u)
    if (unknowns[u].is_physical && unknowns[u].name == name) return static_cast<int>(u);
  return -1;
}

bool is_whole(const Body& body, const std::array<int, 6>& unknowns) {
  if (std::any_of(unknowns.begin(), unknowns.begin() + 3, [](int u) { return u < 0; })) return false;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (unknowns[i] >= 0 && unknowns[i] == unknowns[k]) return false;
  const auto is_zero = [&](std::size_t i) { return body.inertia[i].expression < 0 && body.inertia[i].value == 0; };
  if (unknowns[3] < 0) return is_zero(3) && is_zero(4) && is_zero(5);
  return unknowns[4] >= 0 && unknowns[5] >= 0;
}

Matrix moments_of(const FreeInertia& inertia, const std::vector<double>& values) {
  Matrix j = Matrix::Zero();
  for (std::size_t i = 0; i < 6; ++i)
    if (inertia.unknowns[i] >= 0)
      j(kRow[i], kColumn[i]) = j(kColumn[i], kRow[i]) = values[static_cast<std::size_t>(inertia.unknowns[i])];
  return j.trace() / 2 * Matrix::Identity() - j;
}

Matrix triangle_of(const std::array<double, 6>& factor) {
  Matrix l = Matrix::Zero();
  for (std::size_t i = 0; i < 6; ++i) l(kRow[i], kColumn[i]) = factor[i];
  return l;
}

Matrix inertia_of(const Matrix& moments) { return moments.trace() * Matrix::Identity() - moments; }

}  // namespace

std::vector<FreeInertia> free_inertias(const Model& model, std::vector<Unknown>& unknowns) {
  std::vector<FreeInertia> list;
  std::vector<bool> is_taken(unknowns.size(), false);
  for (const Body& body : model.bodies) {
    FreeInertia inertia{body.name, {}};
    for (std::size_t i = 0; i < 6; ++i) inertia.unknowns[i] = physical_unknown(model, body.inertia[i], unknowns);
    const auto is_new = [&](int u) { return u < 0 || !is_taken[static_cast<std::size_t>(u)]; };
    if (!is_whole(body, inertia.unknowns) || !std::ranges::all_of(inertia.unknowns, is_new)) continue;
    double trace = 0;
    for (std::size_t i = 0; i < 3; ++i) trace += unknowns[static_cast<std::size_t>(inertia.unknowns[i])].start;
    if (trace > 0) inertia.size = std::sqrt(trace / 2);
    for (const int u : inertia.unknowns) {
      if (u < 0) continue;
      is_taken[static_cast<std::size_t>(u)] = true;
      unknowns[static_cast<std::size_t>(u)].scale = inertia.size * inertia.size;
    }
    list.push_back(std::move(inertia));
  }
  for (std::size_t u = 0; u < unknowns.size(); ++u)
    if (unknowns[u].is_physical && !is_taken[u])
      throw UserError(fmt::format(
          "--free {0}=physical: belongs to no inertia whose entries are all found\n  hint: make each entry of the "
          "body's inertia a parameter of its own, and name them all: xx, yy and zz of a body without products, or "
          "six\n",
          unknowns[u].name));
  return list;
}

std::array<double, 6> factor_of(const FreeInertia& inertia, const std::vector<double>& values) {
  const Matrix moments = moments_of(inertia, values) / (inertia.size * inertia.size);
  Matrix l = Matrix::Zero();
  for (int c = 0; c < 3; ++c) {
    const double rest = moments(c, c) - l.row(c).squaredNorm();
    l(c, c) = std::sqrt(std::max(rest, kLeastOfFactor * kLeastOfFactor));
    for (int r = c + 1; r < 3; ++r) l(r, c) = (moments(r, c) - l.row(r).dot(l.row(c))) / l(c, c);
  }
  std::array<double, 6> factor;
  for (std::size_t i = 0; i < 6; ++i) factor[i] = l(kRow[i], kColumn[i]);
  return factor;
}

void set_inertia(const FreeInertia& inertia, const std::array<double, 6>& factor, std::vector<double>& values) {
  const Matrix l = inertia.size * triangle_of(factor), j = inertia_of(l * l.transpose());
  for (std::size_t i = 0; i < 6; ++i)
    if (inertia.unknowns[i] >= 0) values[static_cast<std::size_t>(inertia.unknowns[i])] = j(kRow[i], kColumn[i]);
}

std::vector<int> columns_of(const FreeInertia& inertia) {
  std::vector<int> columns(inertia.unknowns.begin(), inertia.unknowns.end());
  std::erase(columns, -1);
  return columns;
}

const FreeInertia* inertia_of_unknown(const std::vector<FreeInertia>& inertias, std::size_t unknown,
                                      std::size_t& entry) {
  for (const FreeInertia& inertia : inertias) {
    const auto found = std::ranges::find(inertia.unknowns, static_cast<int>(unknown));
    if (found == inertia.unknowns.end()) continue;
    entry = static_cast<std::size_t>(found - inertia.unknowns.begin());
    return &inertia;
  }
  return nullptr;
}

Eigen::MatrixXd slopes_of_inertia(const FreeInertia& inertia, const std::array<double, 6>& factor) {
  const Matrix l = triangle_of(factor);
  Eigen::Matrix<double, 6, 6> slopes;
  for (std::size_t k = 0; k < 6; ++k) {
    Matrix change = Matrix::Zero();
    change.row(kRow[k]) = l.col(kColumn[k]).transpose();  // of L L' along entry k: e l' + l e'
    const Matrix j = inertia.size * inertia.size * inertia_of(change + change.transpose());
    for (std::size_t i = 0; i < 6; ++i)
      slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = j(kRow[i], kColumn[i]);
  }
  const auto size = static_cast<Eigen::Index>(columns_of(inertia).size());  // three without products, or six
  return slopes.topLeftCorner(size, size);
}

bool is_at_limit(const FreeInertia& inertia, const std::vector<double>& values) {
  constexpr double kRounding = 1.001;
  const std::array<double, 6> factor = factor_of(inertia, values);
  return std::any_of(factor.begin(), factor.begin() + 3,
                     [](double entry) { return entry < kRounding * kLeastOfFactor; });
}

}  // namespace mbgen::fit
