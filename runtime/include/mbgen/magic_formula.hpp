#pragma once
// Pacejka's magic formula in two forms: PAC2002 (MF5.2) and the one of 1989, each for pure and combined slip.
// Written over a scalar T (double, or the compiler's symbolic scalar): no comparisons on T.
// Sources: H. B. Pacejka, Tyre and Vehicle Dynamics, 2nd edition, section 4.3; E. Bakker, H. B. Pacejka, L. Lidner,
// "A New Tire Model with an Application in Vehicle Dynamics Studies", SAE 890087.

#include "mbgen/scalar.hpp"

#include <cstddef>
#include <utility>

namespace mbgen {

/// One coefficient of a tyre set: its name in .tir files and the value it has when the set does not give it.
struct TyreField {
  const char* name;
  double default_value;
};

/// The coefficients of PAC2002 (MF5.2), in the order of the members of Pac2002.
inline constexpr TyreField kPac2002Fields[] = {
    // unloaded radius, m; nominal load, N: both must be given, > 0
    {"UNLOADED_RADIUS", 0.0}, {"FNOMIN", 0.0},
    // scaling factors
    {"LFZO", 1.0}, {"LCX", 1.0}, {"LMUX", 1.0}, {"LEX", 1.0}, {"LKX", 1.0}, {"LHX", 1.0}, {"LVX", 1.0},
    {"LCY", 1.0}, {"LMUY", 1.0}, {"LEY", 1.0}, {"LKY", 1.0}, {"LHY", 1.0}, {"LVY", 1.0}, {"LTR", 1.0},
    {"LRES", 1.0}, {"LGAX", 1.0}, {"LGAY", 1.0}, {"LGAZ", 1.0}, {"LXAL", 1.0}, {"LYKA", 1.0}, {"LVYKA", 1.0},
    {"LS", 1.0}, {"LMX", 1.0}, {"LVMX", 1.0}, {"LMY", 1.0},
    // longitudinal force, pure and combined slip
    {"PCX1", 0.0}, {"PDX1", 0.0}, {"PDX2", 0.0}, {"PDX3", 0.0}, {"PEX1", 0.0}, {"PEX2", 0.0}, {"PEX3", 0.0},
    {"PEX4", 0.0}, {"PKX1", 0.0}, {"PKX2", 0.0}, {"PKX3", 0.0}, {"PHX1", 0.0}, {"PHX2", 0.0}, {"PVX1", 0.0},
    {"PVX2", 0.0}, {"RBX1", 0.0}, {"RBX2", 0.0}, {"RCX1", 0.0}, {"REX1", 0.0}, {"REX2", 0.0}, {"RHX1", 0.0},
    // lateral force, pure and combined slip
    {"PCY1", 0.0}, {"PDY1", 0.0}, {"PDY2", 0.0}, {"PDY3", 0.0}, {"PEY1", 0.0}, {"PEY2", 0.0}, {"PEY3", 0.0},
    {"PEY4", 0.0}, {"PKY1", 0.0}, {"PKY2", 0.0}, {"PKY3", 0.0}, {"PHY1", 0.0}, {"PHY2", 0.0}, {"PHY3", 0.0},
    {"PVY1", 0.0}, {"PVY2", 0.0}, {"PVY3", 0.0}, {"PVY4", 0.0}, {"RBY1", 0.0}, {"RBY2", 0.0}, {"RBY3", 0.0},
    {"RCY1", 0.0}, {"REY1", 0.0}, {"REY2", 0.0}, {"RHY1", 0.0}, {"RHY2", 0.0}, {"RVY1", 0.0}, {"RVY2", 0.0},
    {"RVY3", 0.0}, {"RVY4", 0.0}, {"RVY5", 0.0}, {"RVY6", 0.0},
    // aligning moment, pure and combined slip
    {"QBZ1", 0.0}, {"QBZ2", 0.0}, {"QBZ3", 0.0}, {"QBZ4", 0.0}, {"QBZ5", 0.0}, {"QBZ9", 0.0}, {"QBZ10", 0.0},
    {"QCZ1", 0.0}, {"QDZ1", 0.0}, {"QDZ2", 0.0}, {"QDZ3", 0.0}, {"QDZ4", 0.0}, {"QDZ6", 0.0}, {"QDZ7", 0.0},
    {"QDZ8", 0.0}, {"QDZ9", 0.0}, {"QEZ1", 0.0}, {"QEZ2", 0.0}, {"QEZ3", 0.0}, {"QEZ4", 0.0}, {"QEZ5", 0.0},
    {"QHZ1", 0.0}, {"QHZ2", 0.0}, {"QHZ3", 0.0}, {"QHZ4", 0.0}, {"SSZ1", 0.0}, {"SSZ2", 0.0}, {"SSZ3", 0.0},
    {"SSZ4", 0.0},
    // overturning moment
    {"QSX1", 0.0}, {"QSX2", 0.0}, {"QSX3", 0.0},
};

/// Number of coefficients of a PAC2002 set.
inline constexpr std::size_t kPac2002Count = sizeof(kPac2002Fields) / sizeof(kPac2002Fields[0]);

/// Coefficients of a PAC2002 (MF5.2) set, in the order of kPac2002Fields; names as in .tir files.
template <class T>
struct Pac2002 {
  T unloaded_radius, fnomin;  ///< unloaded radius, m; nominal load, N: both must be given, > 0
  T lfzo, lcx, lmux, lex, lkx, lhx, lvx, lcy, lmuy, ley, lky, lhy, lvy, ltr, lres, lgax,
      lgay, lgaz, lxal, lyka, lvyka, ls, lmx, lvmx, lmy;  ///< scaling factors
  T pcx1, pdx1, pdx2, pdx3, pex1, pex2, pex3, pex4, pkx1, pkx2, pkx3, phx1, phx2, pvx1,
      pvx2, rbx1, rbx2, rcx1, rex1, rex2, rhx1;  ///< longitudinal force, pure and combined slip
  T pcy1, pdy1, pdy2, pdy3, pey1, pey2, pey3, pey4, pky1, pky2, pky3, phy1, phy2, phy3,
      pvy1, pvy2, pvy3, pvy4, rby1, rby2, rby3, rcy1, rey1, rey2, rhy1, rhy2, rvy1, rvy2,
      rvy3, rvy4, rvy5, rvy6;  ///< lateral force, pure and combined slip
  T qbz1, qbz2, qbz3, qbz4, qbz5, qbz9, qbz10, qcz1, qdz1, qdz2, qdz3, qdz4, qdz6, qdz7,
      qdz8, qdz9, qez1, qez2, qez3, qez4, qez5, qhz1, qhz2, qhz3, qhz4, ssz1, ssz2, ssz3,
      ssz4;  ///< aligning moment, pure and combined slip
  T qsx1, qsx2, qsx3;  ///< overturning moment

  /// Takes kPac2002Count coefficients in the order of kPac2002Fields.
  static Pac2002 from_fields(const T* fields) { return gather(fields, std::make_index_sequence<kPac2002Count>{}); }

 private:
  template <std::size_t... I>
  static Pac2002 gather(const T* fields, std::index_sequence<I...>) { return Pac2002{fields[I]...}; }
};

static_assert(sizeof(Pac2002<double>) == kPac2002Count * sizeof(double), "one entry in kPac2002Fields per member");

/// Numbers of coefficients of the formula of 1989: lateral force, longitudinal force, aligning moment.
inline constexpr int kPac89ACount = 14;
inline constexpr int kPac89BCount = 11;
inline constexpr int kPac89CCount = 18;

/// Coefficients of the formula of 1989, in its own units (kN, degrees, per cent).
template <class T>
struct Pac89 {
  T a[kPac89ACount];  ///< lateral force
  T b[kPac89BCount];  ///< longitudinal force
  T c[kPac89CCount];  ///< aligning moment

  /// Takes the coefficients a, then b, then c: 43 values.
  static Pac89 from_fields(const T* fields) {
    Pac89 set{};
    for (int i = 0; i < kPac89ACount; ++i) set.a[i] = fields[i];
    for (int i = 0; i < kPac89BCount; ++i) set.b[i] = fields[kPac89ACount + i];
    for (int i = 0; i < kPac89CCount; ++i) set.c[i] = fields[kPac89ACount + kPac89BCount + i];
    return set;
  }
};

/// Forces on the wheel in its contact frame, N and N m: along its heading, across it, moments about the normal and heading.
template <class T>
struct TyreForces {
  T fx, fy, mz, mx;
};

}  // namespace mbgen
