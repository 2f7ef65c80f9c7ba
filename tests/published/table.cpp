// The table of docs/verification.md, see docs/verification.sh.

#include <cstdio>
#include <exception>

#include "tests/published/published.hpp"

int main() try {
  std::printf(
      "| problem | metric | our error | bound of the test | step | source gives |\n|---|---|---|---|---|---|\n");
  for (const mbgen::published::Problem& problem : mbgen::published::problems()) {
    std::string title = "[" + problem.title + "](../" + problem.model + ")";
    for (const mbgen::published::Figure& f : problem.solve()) {
      std::printf("| %s | %s | %.1e %s | %.0e | %s | %s |\n", title.c_str(), f.metric.c_str(), f.error, f.unit.c_str(),
                  f.bound, f.method.c_str(), f.published.c_str());
      title.clear();
    }
  }
  return 0;
} catch (const std::exception& problem) {
  std::fprintf(stderr, "%s\n", problem.what());
  return 1;
}
