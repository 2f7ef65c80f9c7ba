// Two FMUs of FMI 2 from their sources in one program, each with the functions of its own model.
#include <cstdio>

extern "C" {
const char* pendulum_fmi2GetVersion();
const char* slider_crank_fmi2GetVersion();
int pendulum_fmi2DoStep(void*, double, double, int);
int slider_crank_fmi2DoStep(void*, double, double, int);
}

int main() {
  // Without a unit each answers fmi2Error.
  const bool refused = pendulum_fmi2DoStep(nullptr, 0, 1, 0) == 3 && slider_crank_fmi2DoStep(nullptr, 0, 1, 0) == 3;
  std::printf("two FMUs of version %s and %s\n", pendulum_fmi2GetVersion(), slider_crank_fmi2GetVersion());
  return refused ? 0 : 1;
}
