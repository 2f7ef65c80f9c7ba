#pragma once
// Tables 1 and 2 of García de Jalón, Callejo, Hidalgo 2012: seconds for 20 000 evaluations of each step.

#include <array>
#include <string_view>

#include "mbgen/solver/step_clock.hpp"

namespace mbgen {

constexpr long long kPaperEvaluations = 20000;

/// The steps as the paper names them.
constexpr std::array<const char*, kSteps> kStepTitles = {"1 b, A, J, M; accumulated inertias MR",
                                                         "2 Phi_z; its LU",
                                                         "3 Rz",
                                                         "4 dependent velocities; Z, d",
                                                         "5 forces Q, accumulated",
                                                         "6 c; dRz/dt zd",
                                                         "7 accelerations; QR",
                                                         "8 Rz' Rd' MR Rd Rz; b",
                                                         "9 zdd; driving forces"};

/// One column.
struct PaperColumn {
  const char* implementation;
  std::array<double, kSteps> seconds;
  double total;  ///< as printed
};

/// One table.
struct PaperTable {
  std::string_view model;  ///< whose vehicle it is
  std::array<PaperColumn, 3> columns;
};

constexpr std::array<PaperTable, 2> kPaperTables = {
    {{"coach",
      {{{"C/C++", {0.258, 0.134, 0.305, 0.088, 0.165, 0.133, 0.073, 0.574, 0.066}, 1.796},
        {"BLAS", {0.264, 0.252, 0.158, 0.107, 0.170, 0.119, 0.076, 0.565, 0.069}, 1.779},
        {"SPARSE", {0.274, 0.323, 0.225, 0.078, 0.181, 0.138, 0.083, 0.582, 0.069}, 1.952}}}},
     {"truck",
      {{{"C/C++", {0.675, 0.425, 4.032, 0.289, 0.273, 0.258, 0.193, 3.037, 0.247}, 9.428},
        {"BLAS", {0.665, 0.927, 0.655, 0.361, 0.275, 0.198, 0.194, 2.054, 0.258}, 5.588},
        {"SPARSE", {0.658, 0.721, 0.616, 0.195, 0.275, 0.180, 0.193, 2.044, 0.255}, 5.137}}}}}};

}  // namespace mbgen
