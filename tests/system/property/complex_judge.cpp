#include "tests/system/property/complex_judge.hpp"

#include <algorithm>
#include <utility>

namespace mbgen::testing::complex_step {
namespace {

constexpr int kFirstBody = 1;  // of the model; ground is before it

Vector vector_of(const Point& p) { return Vector(p[0], p[1], p[2]); }
/// Of complex vectors without conjugates, which are not analytic.
Vector cross(const Vector& a, const Vector& b) {
  return Vector(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}
Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Turn crossing(const Vector& a) {
  Turn result;
  result << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return result;
}
Turn turn_about(const Vector& axis, Number angle) {
  const Turn k = crossing(axis);
  return Turn::Identity() + std::sin(angle) * k + (1.0 - std::cos(angle)) * (k * k);
}

Vector at(const Seen& seen, const Vector& point) { return seen.turn * point + seen.shift; }
Vector velocity_at(const Seen& seen, const Vector& place) {
  return seen.velocity.tail<3>() + cross(seen.velocity.head<3>(), place);
}

/// Gauss, pivots by their absolute values; equations that repeat others leave.
Numbers solution(Matrix a, Numbers right) {
  const Eigen::Index n = a.rows();
  std::vector<Eigen::Index> column(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) column[static_cast<std::size_t>(i)] = i;
  Eigen::Index rank = 0;
  double first = 0;
  for (; rank < n; ++rank) {
    Eigen::Index r = 0, c = 0;
    const double largest = a.bottomRightCorner(n - rank, n - rank).cwiseAbs().maxCoeff(&r, &c);
    first = std::max(first, largest);
    if (largest < 1e-9 * first) break;
    a.row(rank).swap(a.row(rank + r));
    std::swap(right[rank], right[rank + r]);
    a.col(rank).swap(a.col(rank + c));
    std::swap(column[static_cast<std::size_t>(rank)], column[static_cast<std::size_t>(rank + c)]);
    for (Eigen::Index i = rank + 1; i < n; ++i) {
      const Number factor = a(i, rank) / a(rank, rank);
      a.row(i) -= factor * a.row(rank);
      right[i] -= factor * right[rank];
    }
  }
  Numbers found = Numbers::Zero(n), result(n);
  for (Eigen::Index i = rank; i-- > 0;) {
    found[i] = right[i];
    for (Eigen::Index j = i + 1; j < rank; ++j) found[i] -= a(i, j) * found[j];
    found[i] /= a(i, i);
  }
  for (Eigen::Index i = 0; i < n; ++i) result[column[static_cast<std::size_t>(i)]] = found[i];
  return result;
}

}  // namespace

bool ComplexJudge::is_in_tree(int joint) const {
  return std::ranges::any_of(topology_.bodies, [&](const TreeBody& body) { return body.joint == joint; });
}

Vector ComplexJudge::pin_of(const RandomJoint& joint) const {
  const bool moves = &joint == &random_.joints.back();
  return vector_of(joint.at) + (moves ? varied_.pin : 0.0) * Vector::Unit(0);
}

Vector ComplexJudge::start_of(std::size_t link) const {
  return vector_of(random_.links[link].start) + (link == 0 ? varied_.hook : 0.0) * Vector::Unit(0);
}

Matrix ComplexJudge::all_rows() const {
  Matrix rows(static_cast<Eigen::Index>(rows_.size()), force_.size());
  for (Eigen::Index r = 0; r < rows.rows(); ++r) rows.row(r) = rows_[static_cast<std::size_t>(r)].transpose();
  return rows;
}

Numbers ComplexJudge::accelerations(const Numbers& z, const Numbers& zd, const std::vector<double>& tau) {
  see(z, zd);
  const Eigen::Index n = z.size(), rows = static_cast<Eigen::Index>(rows_.size());
  Matrix all = Matrix::Zero(n + rows, n + rows);
  Numbers right(n + rows);
  all.topLeftCorner(n, n) = mass_;
  all.bottomLeftCorner(rows, n) = all_rows();
  all.topRightCorner(n, rows) = all_rows().transpose();
  for (Eigen::Index i = 0; i < n; ++i) right[i] = force_[i] + tau[static_cast<std::size_t>(i)];
  for (Eigen::Index r = 0; r < rows; ++r) right[n + r] = sides_[static_cast<std::size_t>(r)];
  return solution(all, right).head(n);
}

Numbers ComplexJudge::shortest(const Numbers& products) const {
  const Matrix rows = all_rows();
  const Eigen::Index n = rows.cols();
  Matrix all = Matrix::Identity(n + rows.rows(), n + rows.rows());
  all.bottomRightCorner(rows.rows(), rows.rows()).setZero();
  all.bottomLeftCorner(rows.rows(), n) = rows;
  all.topRightCorner(n, rows.rows()) = rows.transpose();
  Numbers right = Numbers::Zero(n + rows.rows());
  right.tail(rows.rows()) = products;
  return solution(all, right).head(n);
}

void ComplexJudge::close(Numbers& z, Numbers& zd) {
  for (int k = 0; k < 3; ++k) {
    see(z, zd);
    if (rows_.empty()) return;
    z -= shortest(Eigen::Map<const Numbers>(gaps_.data(), static_cast<Eigen::Index>(gaps_.size())));
  }
  see(z, zd);
  zd -= shortest(all_rows() * zd);
}

void ComplexJudge::step(Numbers& z, Numbers& zd, double h) {
  const std::vector<double> none(static_cast<std::size_t>(z.size()));
  const Numbers v1 = zd, a1 = accelerations(z, zd, none);
  const Numbers v2 = zd + h / 2 * a1, a2 = accelerations(z + h / 2 * v1, v2, none);
  const Numbers v3 = zd + h / 2 * a2, a3 = accelerations(z + h / 2 * v2, v3, none);
  const Numbers v4 = zd + h * a3, a4 = accelerations(z + h * v3, v4, none);
  z += h / 6 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
  zd += h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  close(z, zd);
}

/// Poses, velocities and accelerations at zdd = 0, from the root outwards.
void ComplexJudge::see(const Numbers& z, const Numbers& zd) {
  const Eigen::Index n = z.size();
  seen_.clear();
  along_.clear();
  rows_.clear();
  sides_.clear();
  gaps_.clear();
  mass_ = Matrix::Zero(n, n);
  force_ = Numbers::Zero(n);
  for (std::size_t i = 0; i < topology_.bodies.size(); ++i) {
    const TreeBody& tree = topology_.bodies[i];
    Seen seen = tree.parent == kGround ? ground_ : seen_[static_cast<std::size_t>(tree.parent)];
    const Vector axis(tree.axis[0], tree.axis[1], tree.axis[2]);
    const Vector pin = pin_of(random_.joints[static_cast<std::size_t>(tree.joint)]);
    const Vector now = seen.turn * axis, here = at(seen, pin);
    Twist along;
    if (tree.kind == FreedomKind::revolute) {
      along << now, cross(here, now);
      const Turn turn = turn_about(now, z[static_cast<Eigen::Index>(i)]);
      seen.shift = turn * (seen.shift - here) + here;
      seen.turn = turn * seen.turn;
    } else {
      along << Vector::Zero(), now;
      seen.shift += now * z[static_cast<Eigen::Index>(i)];
    }
    const Twist v = seen.velocity;
    Twist turned;
    turned << cross(v.head<3>(), along.head<3>()),
        cross(v.head<3>(), along.tail<3>()) + cross(v.tail<3>(), along.head<3>());
    seen.bias += turned * zd[static_cast<Eigen::Index>(i)];
    seen.velocity += along * zd[static_cast<Eigen::Index>(i)];
    seen.path.push_back(static_cast<int>(i));
    along_.push_back(along);
    if (tree.model_body >= 0) place_[tree.model_body - kFirstBody] = i;
    seen_.push_back(seen);
  }
  for (std::size_t b = 0; b < random_.bodies.size(); ++b) add_body(static_cast<int>(b));
  for (std::size_t k = 0; k < random_.links.size(); ++k) add_link(k);
  for (std::size_t j = 0; j < random_.joints.size(); ++j)
    if (!is_in_tree(static_cast<int>(j))) add_joint(random_.joints[j]);
}

/// A wrench of moment and force at the origin acts on a body.
void ComplexJudge::push(const Seen& seen, const Twist& wrench) {
  for (const int i : seen.path) force_[i] += (along_[static_cast<std::size_t>(i)].transpose() * wrench)(0);
}

void ComplexJudge::add_body(int index) {
  const RandomBody& data = random_.bodies[static_cast<std::size_t>(index)];
  if (data.mass == 0) return;
  const Number mass = index == 0 ? varied_.mass : Number(data.mass);
  const Seen& seen = body(index);
  const auto& I = data.inertia;
  Turn about;
  about << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
  const Vector c = at(seen, vector_of(data.com));
  const Turn moved = crossing(c);
  Eigen::Matrix<Number, 6, 6> inertia;
  inertia.topLeftCorner<3, 3>() = seen.turn * about * seen.turn.transpose() - mass * (moved * moved);
  inertia.topRightCorner<3, 3>() = mass * moved;
  inertia.bottomLeftCorner<3, 3>() = -mass * moved;
  inertia.bottomRightCorner<3, 3>() = mass * Turn::Identity();
  for (const int i : seen.path)
    for (const int j : seen.path)
      mass_(i, j) +=
          (along_[static_cast<std::size_t>(i)].transpose() * inertia * along_[static_cast<std::size_t>(j)])(0);
  const Twist momentum = inertia * seen.velocity, rest = inertia * seen.bias;
  const Vector w = seen.velocity.head<3>(), v = seen.velocity.tail<3>();
  Twist wrench;
  wrench << cross(w, momentum.head<3>()) + cross(v, momentum.tail<3>()), cross(w, momentum.tail<3>());
  const Vector weight = mass * varied_.gravity * vector_of(random_.gravity);
  Twist pull;
  pull << cross(c, weight), weight;
  push(seen, pull - wrench - rest);
}

void ComplexJudge::add_link(std::size_t k) {
  const RandomLink& link = random_.links[k];
  const Seen &a = body(link.from), &b = body(link.to);
  const Vector from = at(a, start_of(k)), to = at(b, vector_of(link.end)), way = to - from;
  if (link.stiffness == 0) {
    const Vector length = vector_of(link.end) - start_of(k);
    const Vector rate = velocity_at(b, to) - velocity_at(a, from);
    add_row(a, from, b, to, way, -dot(rate, rate), (dot(way, way) - dot(length, length)) / 2.0);
    return;
  }
  const Number distance = std::sqrt(dot(way, way)), stiffness = k == 0 ? varied_.stiffness : Number(link.stiffness);
  const Vector pull = way * (stiffness * (distance - kFreeLength) / distance);
  Twist on_a, on_b;
  on_a << cross(from, pull), pull;
  on_b << -cross(to, pull), -pull;
  push(a, on_a);
  push(b, on_b);
}

/// The row of a closure with this gap: direction times the difference of the accelerations of two points is `side`.
void ComplexJudge::add_row(const Seen& a, const Vector& from, const Seen& b, const Vector& to, const Vector& direction,
                           Number side, Number gap) {
  const auto bias_at = [](const Seen& seen, const Vector& place) {
    return Vector(seen.bias.tail<3>() + cross(seen.bias.head<3>(), place) +
                  cross(seen.velocity.head<3>(), velocity_at(seen, place)));
  };
  Numbers row = Numbers::Zero(force_.size());
  const auto add = [&](const Seen& seen, const Vector& place, double sign) {
    for (const int i : seen.path) {
      const Twist& along = along_[static_cast<std::size_t>(i)];
      row[i] += sign * dot(direction, Vector(along.tail<3>() + cross(along.head<3>(), place)));
    }
  };
  add(b, to, 1);
  add(a, from, -1);
  rows_.push_back(row);
  gaps_.push_back(gap);
  sides_.push_back(side - dot(direction, Vector(bias_at(b, to) - bias_at(a, from))));
}

/// Point by point: a spherical joint holds one, a revolute one two on its axis.
void ComplexJudge::add_joint(const RandomJoint& joint) {
  const Seen &a = body(joint.from), &b = body(joint.to);
  const Vector pin = pin_of(joint);
  for (int point = 0; point < (joint.type == "revolute" ? 2 : 1); ++point) {
    const Vector place = pin + Number(point) * vector_of(joint.axis);
    for (int i = 0; i < 3; ++i)
      add_row(a, at(a, place), b, at(b, place), Vector::Unit(i), 0.0, at(b, place)[i] - at(a, place)[i]);
  }
}

}  // namespace mbgen::testing::complex_step
