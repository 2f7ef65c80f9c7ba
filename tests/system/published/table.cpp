// The table of docs/evidence/verification.md, see docs/evidence/verification.sh: verification_table [--long]

#include <cstdio>
#include <exception>
#include <string_view>

#include "tests/system/published/published.hpp"

int main(int count, char** arguments) try {
  using namespace mbgen::published;
  const bool is_long = count > 1 && std::string_view(arguments[1]) == "--long";
  std::printf(
      "| problem | metric | our error | bound of the test | step | source gives |\n|---|---|---|---|---|---|\n");
  for (const Problem& problem : is_long ? long_problems() : problems()) {
    std::string title = "[" + problem.title + "](../../" + problem.model + ")";
    for (const Figure& f : problem.solve()) {
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
