#pragma once
// Problems with published or independently computed answers, solved by mbgen: the test checks every figure against its
// bound, and docs/evidence/verification.sh prints the same figures as a table.

#include <functional>
#include <string>
#include <vector>

namespace mbgen::published {

/// One comparison with a published answer.
struct Figure {
  std::string metric;     ///< what is compared, where
  double error = 0;       ///< ours, in `unit`
  double bound = 0;       ///< largest error at which the test passes
  std::string unit;       ///< "" for relative errors
  std::string method;     ///< step, or "-" where nothing is integrated
  std::string published;  ///< what the source gives, and how good that is
};

struct Problem {
  std::string name;   ///< letters, digits and underscores
  std::string title;  ///< with the source's name
  std::string model;  ///< relative to the source folder
  std::function<std::vector<Figure>()> solve;
};

/// All problems in the order of the table.
std::vector<Problem> problems();
/// Problems that take minutes: not tests.
std::vector<Problem> long_problems();

std::vector<Figure> simple_pendulum();
std::vector<Figure> n_four_bar();
/// A02 for any N over whole seconds.
Figure n_four_bar_of(int n, int seconds);
std::vector<Figure> andrews();
std::vector<Figure> bricard();
std::vector<Figure> flyball_governor();
std::vector<Figure> babyboot();
std::vector<Figure> free_body();
std::vector<Figure> heavy_top();
std::vector<Figure> kuka();
std::vector<Figure> iltis();

}  // namespace mbgen::published
