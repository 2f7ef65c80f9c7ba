// Evaluates a generated solver at states from a file, for callgrind to count: counted STATES REPETITIONS.
// STATES holds the number of states, then each state (z, zd, x, t) and its joint forces.

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "mbgen/driver.hpp"

int main(int, char** argv) {
  const mbgen::SolverTable& table = *mbgen_solver_table();
  std::FILE* file = std::fopen(argv[1], "r");
  int count = 0;
  if (file == nullptr || std::fscanf(file, "%d", &count) != 1) return 1;
  std::vector<double> states, taus;
  const auto read = [&](std::vector<double>& values, int size) {
    for (int i = 0; i < size; ++i) {
      double value = 0;
      if (std::fscanf(file, "%lf", &value) != 1) std::exit(1);
      values.push_back(value);
    }
  };
  for (int k = 0; k < count; ++k) {
    read(states, table.state_size);
    read(taus, table.coordinates);
  }
  std::fclose(file);
  return table.time_accelerations(table.default_parameters, table.default_inputs, states.data(), taus.data(), count,
                                  std::atoi(argv[2])) == 0
             ? 0
             : 1;
}
