#pragma once
// MF 6.1 once more, transcribed for these tests alone from H. B. Pacejka, Tire and Vehicle Dynamics, 3rd edition, 2012,
// sections 4.3.2 and 4.3.3, in doubles, equation by equation. The readings in which programs differ are switches: with
// those of the reference data it gives the data, with the book's it is what mbgen has to give.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace mbgen::book {

/// True: as the book has it. False: as the programs that made the reference data.
struct Readings {
  bool tangent = true;           ///< alpha* = tan alpha in alpha_y (4.E20); else alpha
  bool digressive = true;        ///< LMUY of lateral shifts by (4.E8); else LMUY itself
  bool one_cosine = true;        ///< cos alpha once in the residual moment (4.E47); else twice
  bool camber_in_shifts = true;  ///< residual moment of (4.E37), (4.E45) with camber; else of an upright wheel
  bool camber_in_arm = true;     ///< SSZ3, SSZ4 of (4.E76) count; else not
  bool sign_of_shifted = true;   ///< sgn alpha_y in (4.E24); else sgn alpha
};

/// A motion under load. Units SI; spin: 1/m, of turning and camber; turn: 1/m, of turning alone.
struct Point {
  double kappa, alpha, fz, pressure, gamma, spin = 0, turn = 0;
  bool turns = false;
};

struct Forces {
  double fx, fy, mz, spin_moment;  ///< mz without the moment of spin
};

namespace detail {

inline double sgn(double x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
inline double cos_atan(double x) { return std::cos(std::atan(x)); }
inline double curve(double b, double c, double e, double x) {
  e = std::min(e, 1.0);
  return c * std::atan(b * x - e * (b * x - std::atan(b * x)));
}

/// Everything of the lateral force that other equations take.
struct Lateral {
  double force, stiffness, mu, b, c, shift;  ///< shift: S_Hf of (4.E38)
};

class Law {
 public:
  Law(const nlohmann::json& numbers, const Readings& read, const Point& at) : numbers_(numbers), read_(read), p_(at) {
    nominal_ = c("FNOMIN") * c("LFZO");
    dfz_ = (p_.fz - nominal_) / nominal_;
    dpi_ = p_.pressure / c("NOMPRES") - 1;
    tan_ = std::tan(p_.alpha);
    cos_ = std::cos(p_.alpha);
    phi_ = c("UNLOADED_RADIUS") * p_.spin;
  }

  Forces forces() const {
    const double gamma = std::sin(p_.gamma), fz = p_.fz, r0 = c("UNLOADED_RADIUS"), kappa = p_.kappa;
    // (4.E50) to (4.E57)
    const double bxa = (c("RBX1") + c("RBX3") * gamma * gamma) * cos_atan(c("RBX2") * kappa) * c("LXAL");
    const double exa = c("REX1") + c("REX2") * dfz_;
    const auto gx = [&](double x) { return std::cos(curve(bxa, c("RCX1"), exa, x)); };
    const double fx = longitudinal() * gx(tan_ + c("RHX1")) / gx(c("RHX1"));
    // (4.E58) to (4.E67)
    const auto gy = [&](double square) {
      const double b = (c("RBY1") + c("RBY4") * square) * cos_atan(c("RBY2") * (tan_ - c("RBY3"))) * c("LYKA");
      const double e = c("REY1") + c("REY2") * dfz_, shift = c("RHY1") + c("RHY2") * dfz_;
      return std::cos(curve(b, c("RCY1"), e, kappa + shift)) / std::cos(curve(b, c("RCY1"), e, shift));
    };
    const Lateral y = lateral(gamma, p_.turns);
    const double dvk =
        y.mu * fz * (c("RVY1") + c("RVY2") * dfz_ + c("RVY3") * gamma) * cos_atan(c("RVY4") * tan_) * zeta_2(p_.turns);
    const double fy =
        gy(gamma * gamma) * y.force + dvk * std::sin(c("RVY5") * std::atan(c("RVY6") * kappa)) * c("LVYKA");
    // (4.E71) to (4.E78)
    const Lateral upright = lateral(0, false);
    const double ratio = kx() / y.stiffness * kappa;
    const auto equivalent = [&](double a) { return std::sqrt(a * a + ratio * ratio); };
    const double at = tan_ + c("QHZ1") + c("QHZ2") * dfz_ + (c("QHZ3") + c("QHZ4") * dfz_) * gamma;
    const double moment = -trail(at, equivalent(at), gamma) * gy(0) * upright.force;
    const double arm =
        r0 *
        (c("SSZ1") + c("SSZ2") * fy / nominal_ + (read_.camber_in_arm ? (c("SSZ3") + c("SSZ4") * dfz_) * gamma : 0)) *
        c("LS");
    // (4.E36), (4.E45) to (4.E47); with turn slip (4.93) to (4.104)
    const Lateral& of_residual = read_.camber_in_shifts || p_.turns ? y : upright;
    const double ar = equivalent(tan_ + of_residual.shift);
    const double br = (c("QBZ9") * c("LKY") / c("LMUY") + c("QBZ10") * of_residual.b * of_residual.c) *
                      (p_.turns ? cos_atan(c("QBRP1") * phi_) : 1);
    const double cosine = read_.one_cosine ? cos_ : cos_ * cos_;
    const double plain = (c("QDZ6") + c("QDZ7") * dfz_) * c("LRES") * zeta_2(p_.turns);
    const double cambered =
        ((c("QDZ8") + c("QDZ9") * dfz_) * (1 + c("PPZ2") * dpi_) + (c("QDZ10") + c("QDZ11") * dfz_) * std::abs(gamma)) *
        gamma * c("LKZC");
    const double dr = fz * r0 * (plain + (p_.turns ? 0 : cambered)) * c("LMUY") * cosine;
    double shape = 1, of_spin = 0;
    if (p_.turns) {
      of_spin = spin_peak(y.mu, gamma);
      shape = zeta_7(y.mu, of_spin, gy(gamma * gamma));
    }
    const double round = std::cos(shape * std::atan(br * ar));
    return {fx, fy, moment + dr * round + arm * fx, -of_spin * round};
  }

 private:
  double c(const char* name) const { return numbers_.value(name, name[0] == 'L' ? 1.0 : 0.0); }

  double kx() const {  // (4.E15)
    return p_.fz * (c("PKX1") + c("PKX2") * dfz_) * std::exp(c("PKX3") * dfz_) *
           (1 + c("PPX1") * dpi_ + c("PPX2") * dpi_ * dpi_) * c("LKX");
  }

  double longitudinal() const {  // (4.E9) to (4.E18), (4.E8), (4.105), (4.106)
    const double turned = c("PDXP1") * (1 + c("PDXP2") * dfz_) * cos_atan(c("PDXP3") * p_.kappa) * phi_;
    const double zeta_1 = p_.turns ? cos_atan(turned) : 1;
    const double mu = (c("PDX1") + c("PDX2") * dfz_) * (1 + c("PPX3") * dpi_ + c("PPX4") * dpi_ * dpi_) *
                      (1 - c("PDX3") * p_.gamma * p_.gamma) * c("LMUX");
    const double d = mu * p_.fz * zeta_1, cx = c("PCX1") * c("LCX");
    const double x = p_.kappa + (c("PHX1") + c("PHX2") * dfz_) * c("LHX");
    const double e = (c("PEX1") + c("PEX2") * dfz_ + c("PEX3") * dfz_ * dfz_) * (1 - c("PEX4") * sgn(x)) * c("LEX");
    const double sv = p_.fz * (c("PVX1") + c("PVX2") * dfz_) * c("LVX") * digressed(c("LMUX")) * zeta_1;
    return d * std::sin(curve(kx() / (cx * d), cx, e, x)) + sv;
  }

  Lateral lateral(double gamma, bool turns) const {  // (4.E19) to (4.E30)
    const double fz = p_.fz, lmu = c("LMUY"), of_shift = read_.digressive ? digressed(lmu) : lmu;
    Lateral y;
    const double zeta_3 = turns ? cos_atan(c("PKYP1") * phi_ * phi_) : 1, zeta2 = zeta_2(turns);
    y.stiffness = cornering_stiffness(gamma) * zeta_3;
    const double of_camber = fz * (c("PKY6") + c("PKY7") * dfz_) * (1 + c("PPY5") * dpi_) * c("LKYC");  // (4.E30)
    const double svg = fz * (c("PVY3") + c("PVY4") * dfz_) * gamma * c("LKYC") * of_shift * zeta2;
    const double sv = fz * (c("PVY1") + c("PVY2") * dfz_) * c("LVY") * of_shift * zeta2 + svg;
    double sh = (c("PHY1") + c("PHY2") * dfz_) * c("LHY");
    sh += turns ? spin_shift(of_camber) - svg / y.stiffness : (of_camber * gamma - svg) / y.stiffness;
    const double slip = read_.tangent ? tan_ : p_.alpha, x = slip + sh;
    y.c = c("PCY1") * c("LCY");
    y.mu = (c("PDY1") + c("PDY2") * dfz_) * (1 + c("PPY3") * dpi_ + c("PPY4") * dpi_ * dpi_) *
           (1 - c("PDY3") * gamma * gamma) * lmu;
    const double d = y.mu * fz * zeta2;
    const double sign = sgn(read_.sign_of_shifted ? x : p_.alpha);
    const double e = (c("PEY1") + c("PEY2") * dfz_) *
                     (1 + c("PEY5") * gamma * gamma - (c("PEY3") + c("PEY4") * gamma) * sign) * c("LEY");
    y.b = y.stiffness / (y.c * d);
    y.force = d * std::sin(curve(y.b, y.c, e, x)) + sv;
    y.shift = sh + sv / y.stiffness;
    return y;
  }

  double cornering_stiffness(double gamma) const {  // (4.E25)
    const double reach = (c("PKY2") + c("PKY5") * gamma * gamma) * (1 + c("PPY2") * dpi_);
    return c("PKY1") * nominal_ * (1 + c("PPY1") * dpi_) * (1 - c("PKY3") * std::abs(gamma)) *
           std::sin(numbers_.value("PKY4", 2.0) * std::atan(p_.fz / (nominal_ * reach))) * c("LKY");
  }

  double trail(double at, double equivalent, double gamma) const {  // (4.E33) to (4.E35), (4.E40) to (4.E44), (4.91)
    const double b = (c("QBZ1") + c("QBZ2") * dfz_ + c("QBZ3") * dfz_ * dfz_) *
                     (1 + c("QBZ4") * gamma + c("QBZ5") * std::abs(gamma)) * c("LKY") / c("LMUY");
    const double d = p_.fz * c("UNLOADED_RADIUS") / nominal_ * (c("QDZ1") + c("QDZ2") * dfz_) * (1 - c("PPZ1") * dpi_) *
                     (1 + c("QDZ3") * std::abs(gamma) + c("QDZ4") * gamma * gamma) * c("LTR") *
                     (p_.turns ? cos_atan(c("QDTP1") * phi_) : 1);
    const double pi = std::acos(-1.0);
    const double e = (c("QEZ1") + c("QEZ2") * dfz_ + c("QEZ3") * dfz_ * dfz_) *
                     (1 + (c("QEZ4") + c("QEZ5") * gamma) * 2 / pi * std::atan(b * c("QCZ1") * at));
    return d * std::cos(curve(b, c("QCZ1"), e, equivalent)) * cos_;
  }

  double digressed(double mu) const { return 10 * mu / (1 + 9 * mu); }       // (4.E8)
  double share() const { return 1 - c("PECP1") * (1 + c("PECP2") * dfz_); }  // (4.90)

  double zeta_2(bool turns) const {  // (4.77), (4.78)
    const double b = c("PDYP1") * (1 + c("PDYP2") * dfz_) * cos_atan(c("PDYP3") * tan_), phi = std::abs(phi_);
    return turns ? cos_atan(b * (phi + c("PDYP4") * std::sqrt(phi))) : 1;
  }

  double spin_shift(double of_camber) const {  // (4.80), (4.85) to (4.89)
    const double d = c("PHYP2") + c("PHYP3") * dfz_;
    const double b = -of_camber / share() / (c("PHYP1") * d * cornering_stiffness(0));
    return d * std::sin(curve(b, c("PHYP1"), c("PHYP4"), phi_));
  }

  double spot_moment(double mu) const {  // (4.95)
    return c("QCRP1") * mu * c("UNLOADED_RADIUS") * p_.fz * std::sqrt(p_.fz / c("FNOMIN")) * c("LMP");
  }

  double spin_peak(double mu, double gamma) const {  // (4.93) to (4.99)
    const double d = spot_moment(mu) / std::sin(std::acos(-1.0) / 2 * c("QDRP1"));
    const double slope = p_.fz * c("UNLOADED_RADIUS") *
                         (c("QDZ8") + c("QDZ9") * dfz_ + (c("QDZ10") + c("QDZ11") * dfz_) * std::abs(gamma)) *
                         c("LKZC") / share();
    return d * std::sin(curve(slope / (c("QDRP1") * d), c("QDRP1"), c("QDRP2"), phi_));
  }

  double zeta_7(double mu, double peak, double weight) const {  // (4.102) to (4.104)
    const double pi = std::acos(-1.0), limit = spot_moment(mu);
    const double sideways = limit * 2 / pi * std::atan(c("QCRP2") * std::abs(c("UNLOADED_RADIUS") * p_.turn)) * weight;
    return 2 / pi * std::acos(sideways / (std::abs(peak) + 1e-3 * limit));
  }

  const nlohmann::json& numbers_;
  const Readings& read_;
  const Point& p_;
  double nominal_, dfz_, dpi_, tan_, cos_, phi_;
};

}  // namespace detail

/// numbers: coefficients by name; absent ones are 0, scaling factors 1, PKY4 2.
inline Forces forces(const nlohmann::json& numbers, const Point& at, const Readings& read = {}) {
  return detail::Law(numbers, read, at).forces();
}

}  // namespace mbgen::book
