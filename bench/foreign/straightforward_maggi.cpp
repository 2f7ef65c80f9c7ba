#include "bench/foreign/straightforward_maggi.hpp"

#include <Eigen/Dense>
#include <stdexcept>

#include "compiler/topology/topology.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSingular = 1e-9;  // pivot over largest one, below it equations are redundant

Matrix3d skew(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// A wrench about the origin: force and moment of a force at a place.
Eigen::Matrix<double, 6, 1> wrench(const Vector3d& force, const Vector3d& place) {
  Eigen::Matrix<double, 6, 1> w;
  w << force, place.cross(force);
  return w;
}

Eigen::Matrix<double, 6, 1> couple(const Vector3d& moment) {
  Eigen::Matrix<double, 6, 1> w;
  w << Vector3d::Zero(), moment;
  return w;
}

void add_point_mass(RigidMass& body, double mass, const Vector3d& place) {
  const double sum = body.mass + mass;
  if (sum == 0) return;
  const Vector3d com = (body.mass * body.com + mass * place) / sum;
  const Matrix3d own = skew(body.com - com), other = skew(place - com);
  body.inertia -= body.mass * own * own + mass * other * other;
  body.mass = sum;
  body.com = com;
}

std::vector<int> joints_below(const ReferenceMechanism& mechanism, int body) {
  std::vector<int> joints;
  for (; body != kGround; body = mechanism.bodies[body].parent) joints.push_back(body);
  return joints;
}

/// The solver; members named as in theory.md end in an underscore.
class Equations {
 public:
  Equations(const ReferenceMechanism& mechanism, const Topology& topology);
  const VectorXd& accelerations(const VectorXd& z, const VectorXd& zd, const VectorXd& tau);

 private:
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  using Matrix6d = Eigen::Matrix<double, 6, 6>;

  /// A closed point of a body, world axes, and its acceleration at the joint accelerations of the last sweep.
  struct End {
    Vector3d place, velocity, acceleration;
  };
  /// A rod's coupling mass m_jk and the joints below either end.
  struct Coupling {
    const ReferenceClosure* rod;
    double mass;
    std::vector<int> below_from, below_to;
  };

  void place_bodies(const VectorXd& z);
  void set_velocities(const VectorXd& zd);
  void set_accelerations(const VectorXd& zdd);
  void accumulate_inertias();
  void accumulate_forces(const VectorXd& tau);
  Matrix3d axes_of(int body) const;
  Vector3d angular_of(int body) const;
  Vector3d angular_acceleration_of(int body) const;
  End end_of(int body, const Vector3d& at) const;
  void add_row(int row, int block, const ReferenceClosure& closure, const Vector6d& on_from, const Vector6d& on_to,
               double acceleration);
  int add_rows(int row, int block, const ReferenceClosure& closure);
  void fill_block(int block);
  void solve_blocks();
  void form_mass_matrix();
  void apply(int body, const Vector3d& place, const Vector3d& force);

  ReferenceMechanism mechanism_;
  Topology topology_;
  int n_ = 0;
  std::vector<std::vector<int>> column_;  ///< per block and joint: its column, -1
  std::vector<Coupling> couplings_;
  std::vector<Matrix3d> axes_;                    ///< turn from the reference
  std::vector<Vector3d> shift_;                   ///< the point that was at r is at axes r + shift
  std::vector<Vector6d> b_, Z_, Zd_, d_, force_;  ///< (32), (36), (37) in the field convention; (51)
  std::vector<Matrix6d> mr_;                      ///< (50)
  MatrixXd jacobian_, Rz_, M_;                    ///< Phi_z and c of one block
  VectorXd c_, zdd_star_, tree_force_, zdd_;
  Eigen::Index free_ = 0;  ///< columns of Rz in use
};

Equations::Equations(const ReferenceMechanism& mechanism, const Topology& topology)
    : mechanism_(mechanism), topology_(topology), n_(topology.size()) {
  for (const LoopBlock& block : topology.blocks) {
    column_.emplace_back(n_, -1);
    for (std::size_t c = 0; c < block.joints.size(); ++c) column_.back()[block.joints[c]] = static_cast<int>(c);
  }
  for (const ReferenceClosure& closure : mechanism_.closures) {
    const bool known = closure.kind == ClosureKind::spherical || closure.kind == ClosureKind::revolute ||
                       closure.kind == ClosureKind::rod;
    if (!known) throw std::invalid_argument("cut joint " + closure.name);
    if (closure.mass == 0) continue;
    // theory.md section 5: point masses m_jj and m_kk fold into the bodies, m_jk couples them.
    if (closure.from != kGround)
      add_point_mass(mechanism_.bodies[closure.from].mass, closure.mass / 3, closure.at_from);
    if (closure.to != kGround) add_point_mass(mechanism_.bodies[closure.to].mass, closure.mass / 3, closure.at_to);
    couplings_.push_back(
        {&closure, closure.mass / 6, joints_below(mechanism_, closure.from), joints_below(mechanism_, closure.to)});
  }
  axes_.resize(n_);
  shift_.resize(n_);
  for (auto* values : {&b_, &Z_, &Zd_, &d_, &force_}) values->resize(n_);
  mr_.resize(n_);
  M_ = MatrixXd::Zero(n_, n_);
}

void Equations::place_bodies(const VectorXd& z) {
  for (int i = 0; i < n_; ++i) {
    const ReferenceBody& body = mechanism_.bodies[i];
    const bool on_ground = body.parent == kGround;
    const Matrix3d parent = on_ground ? Matrix3d::Identity() : axes_[body.parent];
    const Vector3d parent_shift = on_ground ? Vector3d::Zero() : shift_[body.parent];
    const Vector3d axis = parent * body.axis, pin = parent * body.pin + parent_shift;
    if (body.kind == FreedomKind::revolute) {
      axes_[i] = parent * Eigen::AngleAxisd(z[i], body.axis).toRotationMatrix();
      shift_[i] = pin - axes_[i] * body.pin;
      b_[i] << pin.cross(axis), axis;
    } else {
      axes_[i] = parent;
      shift_[i] = parent_shift + z[i] * axis;
      b_[i] << axis, Vector3d::Zero();
    }
  }
}

void Equations::set_velocities(const VectorXd& zd) {
  for (int i = 0; i < n_; ++i) {
    const int p = mechanism_.bodies[i].parent;
    const Vector6d below = p == kGround ? Vector6d(Vector6d::Zero()) : Z_[p];
    Z_[i] = below + b_[i] * zd[i];
    const Vector3d s = below.head<3>(), w = below.tail<3>(), linear = b_[i].head<3>(), angular = b_[i].tail<3>();
    d_[i] << w.cross(linear) + s.cross(angular), w.cross(angular);
    d_[i] *= zd[i];
  }
}

void Equations::set_accelerations(const VectorXd& zdd) {
  for (int i = 0; i < n_; ++i) {
    const int p = mechanism_.bodies[i].parent;
    Zd_[i] = b_[i] * zdd[i] + d_[i];
    if (p != kGround) Zd_[i] += Zd_[p];
  }
}

void Equations::accumulate_inertias() {
  for (int i = 0; i < n_; ++i) {
    const RigidMass& body = mechanism_.bodies[i].mass;
    const Matrix3d g = skew(axes_[i] * body.com + shift_[i]);
    mr_[i].topLeftCorner<3, 3>() = body.mass * Matrix3d::Identity();
    mr_[i].topRightCorner<3, 3>() = -body.mass * g;
    mr_[i].bottomLeftCorner<3, 3>() = body.mass * g;
    mr_[i].bottomRightCorner<3, 3>() = axes_[i] * body.inertia * axes_[i].transpose() - body.mass * g * g;
  }
  for (int i = n_ - 1; i >= 0; --i) {
    if (mechanism_.bodies[i].parent != kGround) mr_[mechanism_.bodies[i].parent] += mr_[i];
  }
}

Matrix3d Equations::axes_of(int body) const { return body == kGround ? Matrix3d::Identity() : axes_[body]; }

Vector3d Equations::angular_of(int body) const {
  return body == kGround ? Vector3d(Vector3d::Zero()) : Vector3d(Z_[body].tail<3>());
}

Vector3d Equations::angular_acceleration_of(int body) const {
  return body == kGround ? Vector3d(Vector3d::Zero()) : Vector3d(Zd_[body].tail<3>());
}

Equations::End Equations::end_of(int body, const Vector3d& at) const {
  if (body == kGround) return {at, Vector3d::Zero(), Vector3d::Zero()};
  End end;
  const Vector3d w = Z_[body].tail<3>();
  end.place = axes_[body] * at + shift_[body];
  end.velocity = Z_[body].head<3>() + w.cross(end.place);
  end.acceleration = Zd_[body].head<3>() + Zd_[body].tail<3>().cross(end.place) + w.cross(end.velocity);
  return end;
}

void Equations::add_row(int row, int block, const ReferenceClosure& closure, const Vector6d& on_from,
                        const Vector6d& on_to, double acceleration) {
  for (int j = closure.from; j != closure.ancestor; j = mechanism_.bodies[j].parent)
    jacobian_(row, column_[block][j]) += b_[j].dot(on_from);
  for (int j = closure.to; j != closure.ancestor; j = mechanism_.bodies[j].parent)
    jacobian_(row, column_[block][j]) -= b_[j].dot(on_to);
  c_[row] = -acceleration;
}

int Equations::add_rows(int row, int block, const ReferenceClosure& closure) {
  const End from = end_of(closure.from, closure.at_from), to = end_of(closure.to, closure.at_to);
  const Vector3d gap = from.place - to.place;
  if (closure.kind == ClosureKind::rod) {  // (55) over 2 l
    const Vector3d along = gap / closure.length;
    add_row(
        row++, block, closure, wrench(along, from.place), wrench(along, to.place),
        (from.velocity - to.velocity).squaredNorm() / closure.length + along.dot(from.acceleration - to.acceleration));
    return row;
  }
  for (int k = 0; k < 3; ++k) {  // (53)
    add_row(row++, block, closure, wrench(Vector3d::Unit(k), from.place), wrench(Vector3d::Unit(k), to.place),
            from.acceleration[k] - to.acceleration[k]);
  }
  if (closure.kind == ClosureKind::spherical) return row;
  const Perpendiculars on_from = perpendiculars(closure.axis);
  const Vector3d u = axes_of(closure.to) * closure.axis;
  const Vector3d wf = angular_of(closure.from), wt = angular_of(closure.to);
  const Vector3d af = angular_acceleration_of(closure.from), at = angular_acceleration_of(closure.to);
  const Vector3d ud = wt.cross(u), udd = at.cross(u) + wt.cross(ud);
  for (const Vector3d& direction : {on_from.first, on_from.second}) {  // (54)
    const Vector3d n = axes_of(closure.from) * direction, nd = wf.cross(n), ndd = af.cross(n) + wf.cross(nd);
    add_row(row++, block, closure, couple(n.cross(u)), couple(n.cross(u)), ndd.dot(u) + 2 * nd.dot(ud) + n.dot(udd));
  }
  return row;
}

void Equations::fill_block(int block) {
  const LoopBlock& loops = topology_.blocks[block];
  jacobian_.setZero(loops.equations, static_cast<Eigen::Index>(loops.joints.size()));
  c_.resize(loops.equations);
  int row = 0;
  for (const int loop : loops.loops) row = add_rows(row, block, mechanism_.closures[loop]);
}

/// Rz (61) and zdd* (62), block by block; joints outside blocks are independent.
void Equations::solve_blocks() {
  zdd_star_.setZero(n_);
  Rz_.setZero(n_, n_);
  free_ = 0;
  std::vector<bool> looped(n_);
  for (std::size_t b = 0; b < topology_.blocks.size(); ++b) {
    fill_block(static_cast<int>(b));
    Eigen::FullPivLU<MatrixXd> lu(jacobian_);
    lu.setThreshold(kSingular);
    const VectorXd x = lu.solve(c_);
    const Eigen::Index directions = lu.dimensionOfKernel();
    const MatrixXd kernel = lu.kernel();
    const std::vector<int>& joints = topology_.blocks[b].joints;
    for (std::size_t c = 0; c < joints.size(); ++c) {
      zdd_star_[joints[c]] = x[static_cast<Eigen::Index>(c)];
      Rz_.row(joints[c]).segment(free_, directions) = kernel.row(static_cast<Eigen::Index>(c)).head(directions);
      looped[joints[c]] = true;
    }
    free_ += directions;
  }
  for (int i = 0; i < n_; ++i)
    if (!looped[i]) Rz_(i, free_++) = 1;
}

/// Tree mass matrix (49) and the rods' couplings m_jk (V_j' V_k + V_k' V_j).
void Equations::form_mass_matrix() {
  M_.setZero();
  for (int i = 0; i < n_; ++i) {
    const Vector6d momentum = mr_[i] * b_[i];
    for (int j = i; j != kGround; j = mechanism_.bodies[j].parent) M_(i, j) = M_(j, i) = momentum.dot(b_[j]);
  }
  for (const Coupling& c : couplings_) {
    const Vector3d from = end_of(c.rod->from, c.rod->at_from).place, to = end_of(c.rod->to, c.rod->at_to).place;
    for (const int i : c.below_from) {
      const Vector3d v = c.mass * (b_[i].head<3>() + b_[i].tail<3>().cross(from));
      for (const int j : c.below_to) {
        const double coupling = v.dot(b_[j].head<3>() + b_[j].tail<3>().cross(to));
        M_(i, j) += coupling;
        M_(j, i) += coupling;
      }
    }
  }
}

void Equations::apply(int body, const Vector3d& place, const Vector3d& force) {
  if (body != kGround) force_[body] += wrench(force, place);
}

/// Rd' sum (Qbar - Mbar Zdot*) + tau (63). Requires: accelerations are those at zdd*.
void Equations::accumulate_forces(const VectorXd& tau) {
  for (int i = 0; i < n_; ++i) {
    const RigidMass& body = mechanism_.bodies[i].mass;
    const End com = end_of(i, body.com);
    const Vector3d w = Z_[i].tail<3>(), wd = Zd_[i].tail<3>();
    const Matrix3d inertia = axes_[i] * body.inertia * axes_[i].transpose();
    force_[i] = wrench(body.mass * (mechanism_.gravity - com.acceleration), com.place) -
                couple(inertia * wd + w.cross(inertia * w));
  }
  for (const Coupling& c : couplings_) {
    const End from = end_of(c.rod->from, c.rod->at_from), to = end_of(c.rod->to, c.rod->at_to);
    apply(c.rod->from, from.place, c.mass * (mechanism_.gravity - to.acceleration));
    apply(c.rod->to, to.place, c.mass * (mechanism_.gravity - from.acceleration));
  }
  tree_force_.resize(n_);
  for (int i = n_ - 1; i >= 0; --i) {
    tree_force_[i] = tau[i] + b_[i].dot(force_[i]);
    if (mechanism_.bodies[i].parent != kGround) force_[mechanism_.bodies[i].parent] += force_[i];
  }
}

const VectorXd& Equations::accelerations(const VectorXd& z, const VectorXd& zd, const VectorXd& tau) {
  place_bodies(z);
  accumulate_inertias();
  set_velocities(zd);
  set_accelerations(VectorXd::Zero(n_));
  solve_blocks();
  set_accelerations(zdd_star_);
  accumulate_forces(tau);
  form_mass_matrix();
  const auto Rz = Rz_.leftCols(free_);
  const MatrixXd reduced = Rz.transpose() * M_ * Rz;
  const VectorXd right_hand_side = Rz.transpose() * tree_force_;
  zdd_ = zdd_star_ + Rz * reduced.ldlt().solve(right_hand_side);
  return zdd_;
}

struct VectorState {
  VectorXd z, zd, tau;
};

VectorState vectors(const ForeignState& state) {
  const auto vector = [](const std::vector<double>& v) {
    return VectorXd(Eigen::Map<const VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
  };
  return {vector(state.z), vector(state.zd), vector(state.tau)};
}

}  // namespace

struct StraightforwardMaggi::Content {
  Equations equations;
  std::vector<VectorState> loaded;
};

StraightforwardMaggi::StraightforwardMaggi(const ReferenceMechanism& mechanism, const Topology& topology)
    : content_(new Content{Equations(mechanism, topology), {}}) {}
StraightforwardMaggi::~StraightforwardMaggi() = default;
StraightforwardMaggi::StraightforwardMaggi(StraightforwardMaggi&&) noexcept = default;

std::vector<double> StraightforwardMaggi::accelerations(const ForeignState& state) {
  const VectorState at = vectors(state);
  const VectorXd& zdd = content_->equations.accelerations(at.z, at.zd, at.tau);
  return {zdd.begin(), zdd.end()};
}

void StraightforwardMaggi::load(const std::vector<ForeignState>& states) {
  content_->loaded.clear();
  for (const ForeignState& state : states) content_->loaded.push_back(vectors(state));
}

void StraightforwardMaggi::run(int repetitions) {
  for (int r = 0; r < repetitions; ++r)
    for (const VectorState& at : content_->loaded) content_->equations.accelerations(at.z, at.zd, at.tau);
}

}  // namespace mbgen::foreign
