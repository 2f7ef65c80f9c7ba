#pragma once
// The coefficients of the magic formula MF 6.1, and of 6.2 as far as its equations are public.

#include "mbgen/tyres/magic_formula.hpp"

namespace mbgen {

/// The coefficients of MF 6.1, in the order of the members of MagicFormula61.
inline constexpr TyreField kMf61Fields[] = {
    // unloaded radius, m; nominal load, N; nominal pressure, Pa: must be given, > 0; reference speed, m/s, > 0
    {"UNLOADED_RADIUS", 0.0},
    {"FNOMIN", 0.0},
    {"NOMPRES", 0.0},
    {"LONGVL", 16.7},
    // scaling factors
    {"LFZO", 1.0},
    {"LCX", 1.0},
    {"LMUX", 1.0},
    {"LEX", 1.0},
    {"LKX", 1.0},
    {"LHX", 1.0},
    {"LVX", 1.0},
    {"LCY", 1.0},
    {"LMUY", 1.0},
    {"LEY", 1.0},
    {"LKY", 1.0},
    {"LHY", 1.0},
    {"LVY", 1.0},
    {"LKYC", 1.0},
    {"LKZC", 1.0},
    {"LTR", 1.0},
    {"LRES", 1.0},
    {"LXAL", 1.0},
    {"LYKA", 1.0},
    {"LVYKA", 1.0},
    {"LS", 1.0},
    {"LMX", 1.0},
    {"LVMX", 1.0},
    {"LMY", 1.0},
    // longitudinal force, pure and combined slip
    {"PCX1", 0.0},
    {"PDX1", 0.0},
    {"PDX2", 0.0},
    {"PDX3", 0.0},
    {"PEX1", 0.0},
    {"PEX2", 0.0},
    {"PEX3", 0.0},
    {"PEX4", 0.0},
    {"PKX1", 0.0},
    {"PKX2", 0.0},
    {"PKX3", 0.0},
    {"PHX1", 0.0},
    {"PHX2", 0.0},
    {"PVX1", 0.0},
    {"PVX2", 0.0},
    {"PPX1", 0.0},
    {"PPX2", 0.0},
    {"PPX3", 0.0},
    {"PPX4", 0.0},
    {"RBX1", 0.0},
    {"RBX2", 0.0},
    {"RBX3", 0.0},
    {"RCX1", 0.0},
    {"REX1", 0.0},
    {"REX2", 0.0},
    {"RHX1", 0.0},
    // lateral force, pure and combined slip
    {"PCY1", 0.0},
    {"PDY1", 0.0},
    {"PDY2", 0.0},
    {"PDY3", 0.0},
    {"PEY1", 0.0},
    {"PEY2", 0.0},
    {"PEY3", 0.0},
    {"PEY4", 0.0},
    {"PEY5", 0.0},
    {"PKY1", 0.0},
    {"PKY2", 0.0},
    {"PKY3", 0.0},
    {"PKY4", 2.0},
    {"PKY5", 0.0},
    {"PKY6", 0.0},
    {"PKY7", 0.0},
    {"PHY1", 0.0},
    {"PHY2", 0.0},
    {"PVY1", 0.0},
    {"PVY2", 0.0},
    {"PVY3", 0.0},
    {"PVY4", 0.0},
    {"PPY1", 0.0},
    {"PPY2", 0.0},
    {"PPY3", 0.0},
    {"PPY4", 0.0},
    {"PPY5", 0.0},
    {"RBY1", 0.0},
    {"RBY2", 0.0},
    {"RBY3", 0.0},
    {"RBY4", 0.0},
    {"RCY1", 0.0},
    {"REY1", 0.0},
    {"REY2", 0.0},
    {"RHY1", 0.0},
    {"RHY2", 0.0},
    {"RVY1", 0.0},
    {"RVY2", 0.0},
    {"RVY3", 0.0},
    {"RVY4", 0.0},
    {"RVY5", 0.0},
    {"RVY6", 0.0},
    // aligning moment, pure and combined slip
    {"QBZ1", 0.0},
    {"QBZ2", 0.0},
    {"QBZ3", 0.0},
    {"QBZ4", 0.0},
    {"QBZ5", 0.0},
    {"QBZ9", 0.0},
    {"QBZ10", 0.0},
    {"QCZ1", 0.0},
    {"QDZ1", 0.0},
    {"QDZ2", 0.0},
    {"QDZ3", 0.0},
    {"QDZ4", 0.0},
    {"QDZ6", 0.0},
    {"QDZ7", 0.0},
    {"QDZ8", 0.0},
    {"QDZ9", 0.0},
    {"QDZ10", 0.0},
    {"QDZ11", 0.0},
    {"QEZ1", 0.0},
    {"QEZ2", 0.0},
    {"QEZ3", 0.0},
    {"QEZ4", 0.0},
    {"QEZ5", 0.0},
    {"QHZ1", 0.0},
    {"QHZ2", 0.0},
    {"QHZ3", 0.0},
    {"QHZ4", 0.0},
    {"PPZ1", 0.0},
    {"PPZ2", 0.0},
    {"SSZ1", 0.0},
    {"SSZ2", 0.0},
    {"SSZ3", 0.0},
    {"SSZ4", 0.0},
    // overturning moment; the last three of 6.2
    {"QSX1", 0.0},
    {"QSX2", 0.0},
    {"QSX3", 0.0},
    {"QSX4", 0.0},
    {"QSX5", 0.0},
    {"QSX6", 0.0},
    {"QSX7", 0.0},
    {"QSX8", 0.0},
    {"QSX9", 0.0},
    {"QSX10", 0.0},
    {"QSX11", 0.0},
    {"PPMX1", 0.0},
    {"QSX12", 0.0},
    {"QSX13", 0.0},
    {"QSX14", 0.0},
    // rolling resistance
    {"QSY1", 0.0},
    {"QSY2", 0.0},
    {"QSY3", 0.0},
    {"QSY4", 0.0},
    {"QSY5", 0.0},
    {"QSY6", 0.0},
    {"QSY7", 0.0},
    {"QSY8", 0.0},
    // radius and vertical stiffness over spin, load, camber (6.2) and pressure; effective rolling radius
    {"Q_RE0", 1.0},
    {"Q_V1", 0.0},
    {"Q_V2", 0.0},
    {"Q_FZ2", 0.0},
    {"Q_FZ3", 0.0},
    {"PFZ1", 0.0},
    {"BREFF", 0.0},
    {"DREFF", 0.0},
    {"FREFF", 1.0 / 3.0},
    // stiffness of the carcass, N/m, over load and pressure: relaxation lengths
    {"LONGITUDINAL_STIFFNESS", 0.0},
    {"PCFX1", 0.0},
    {"PCFX2", 0.0},
    {"PCFX3", 0.0},
    {"LATERAL_STIFFNESS", 0.0},
    {"PCFY1", 0.0},
    {"PCFY2", 0.0},
    {"PCFY3", 0.0},
    // turn slip
    {"LMP", 1.0},
    {"PECP1", 0.0},
    {"PECP2", 0.0},
    {"PDXP1", 0.0},
    {"PDXP2", 0.0},
    {"PDXP3", 0.0},
    {"PKYP1", 0.0},
    {"PDYP1", 0.0},
    {"PDYP2", 0.0},
    {"PDYP3", 0.0},
    {"PDYP4", 0.0},
    {"PHYP1", 0.0},
    {"PHYP2", 0.0},
    {"PHYP3", 0.0},
    {"PHYP4", 0.0},
    {"QDTP1", 0.0},
    {"QCRP1", 0.0},
    {"QCRP2", 0.0},
    {"QBRP1", 0.0},
    {"QDRP1", 0.0},
    {"QDRP2", 0.0},
};

/// Number of coefficients of an MF 6.1 set.
inline constexpr std::size_t kMf61Count = sizeof(kMf61Fields) / sizeof(kMf61Fields[0]);

/// Coefficients of an MF 6.1 set, in the order of kMf61Fields; names as in .tir files.
template <class T>
struct MagicFormula61 {
  T unloaded_radius, fnomin, nompres, longvl;  ///< unloaded radius, m; nominal load, N; nominal pressure, Pa: must be
                                               ///< given, > 0; reference speed, m/s, > 0
  T lfzo, lcx, lmux, lex, lkx, lhx, lvx, lcy, lmuy, ley, lky, lhy, lvy, lkyc, lkzc, ltr, lres, lxal, lyka, lvyka, ls,
      lmx, lvmx, lmy;  ///< scaling factors
  T pcx1, pdx1, pdx2, pdx3, pex1, pex2, pex3, pex4, pkx1, pkx2, pkx3, phx1, phx2, pvx1, pvx2, ppx1, ppx2, ppx3, ppx4,
      rbx1, rbx2, rbx3, rcx1, rex1, rex2, rhx1;  ///< longitudinal force, pure and combined slip
  T pcy1, pdy1, pdy2, pdy3, pey1, pey2, pey3, pey4, pey5, pky1, pky2, pky3, pky4, pky5, pky6, pky7, phy1, phy2, pvy1,
      pvy2, pvy3, pvy4, ppy1, ppy2, ppy3, ppy4, ppy5, rby1, rby2, rby3, rby4, rcy1, rey1, rey2, rhy1, rhy2, rvy1, rvy2,
      rvy3, rvy4, rvy5, rvy6;  ///< lateral force, pure and combined slip
  T qbz1, qbz2, qbz3, qbz4, qbz5, qbz9, qbz10, qcz1, qdz1, qdz2, qdz3, qdz4, qdz6, qdz7, qdz8, qdz9, qdz10, qdz11, qez1,
      qez2, qez3, qez4, qez5, qhz1, qhz2, qhz3, qhz4, ppz1, ppz2, ssz1, ssz2, ssz3,
      ssz4;  ///< aligning moment, pure and combined slip
  T qsx1, qsx2, qsx3, qsx4, qsx5, qsx6, qsx7, qsx8, qsx9, qsx10, qsx11, ppmx1, qsx12, qsx13,
      qsx14;                                         ///< overturning moment; the last three of 6.2
  T qsy1, qsy2, qsy3, qsy4, qsy5, qsy6, qsy7, qsy8;  ///< rolling resistance
  T q_re0, q_v1, q_v2, q_fz2, q_fz3, pfz1, breff, dreff,
      freff;  ///< radius and vertical stiffness over spin, load, camber (6.2) and pressure; effective rolling radius

  T longitudinal_stiffness, pcfx1, pcfx2, pcfx3, lateral_stiffness, pcfy1, pcfy2,
      pcfy3;  ///< stiffness of the carcass, N/m, over load and pressure: relaxation lengths
  T lmp, pecp1, pecp2, pdxp1, pdxp2, pdxp3, pkyp1, pdyp1, pdyp2, pdyp3, pdyp4, phyp1, phyp2, phyp3, phyp4, qdtp1, qcrp1,
      qcrp2, qbrp1, qdrp1, qdrp2;  ///< turn slip

  /// Takes kMf61Count coefficients in the order of kMf61Fields.
  static MagicFormula61 from_fields(const T* fields) {
    return magic::gathered<MagicFormula61>(fields, std::make_index_sequence<kMf61Count>{});
  }
};

static_assert(sizeof(MagicFormula61<double>) == kMf61Count * sizeof(double), "one entry in kMf61Fields per member");

}  // namespace mbgen
