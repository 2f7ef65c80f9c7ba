#!/usr/bin/env python3
"""The slowest step of a motion over its usual one, in counted operations and in time: a table of docs/evidence/growth.md.

  bench/slowest_steps.py [MBGEN] [DIRECTORY]

MBGEN: the binary, default build/release/mbgen, else build/mbgen. DIRECTORY: for all that is made, default
build/slowest_steps. MODELS chooses the rows, by the beginnings of their names. CXX: the compiler, default g++.
Operations are those of the programs that a step evaluates, as the manifest counts them; the elimination of loop blocks
(products, sums and comparisons) is counted by lines that are put into copies of mbgen/solver/loop.hpp and fine.hpp. Of times the least
of five motions counts, step by step. Steps are Runge-Kutta's, from the model's start, with default inputs.
"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = {"accelerations": "accelerations", "closure": "closure", "closure_terms": "closure_terms",
            "chosen_accelerations": "accelerations_chosen"}

COUNTERS = """
namespace counting {
inline long calls[4];
template <int K, auto F>
struct Counted;
template <int K, class... A, void (*F)(A...) noexcept>
struct Counted<K, F> {
  static void call(A... a) noexcept { ++calls[K], F(a...); }
};
}  // namespace counting
"""

DRIVER = """
#include <chrono>
#include <cstdio>
#include <vector>
int main() {
  using namespace @NAME@;
  using Clock = std::chrono::steady_clock;
  constexpr long kCost[] = {@COSTS@};
  const Inputs inputs{};
  const Parameters parameters{};
  const Tuned tuned(parameters);
  std::vector<double> least;
  for (int run = 0; run < 5; ++run) {
    State state = initial_state();
    for (int k = 0; k < @STEPS@; ++k) {
      for (long& count : counting::calls) count = 0;
      counting::elimination = 0;
      state.t = k * @STEP@;
      const auto start = Clock::now();
      const mbgen::Status status = step_rk4(tuned, inputs, state, @STEP@);
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      if (!status.ok()) return std::printf("step %d ends with code %d\\n", k, static_cast<int>(status.code)), 1;
      if (run == 0) least.push_back(seconds);
      if (seconds < least[k]) least[k] = seconds;
      if (run < 4) continue;
      long operations = 0;
      for (int p = 0; p < 4; ++p) operations += kCost[p] * counting::calls[p];
      std::printf("%d %ld %ld %.9g\\n", static_cast<int>(status.code), operations, counting::elimination, least[k]);
    }
  }
}
"""


def four_bar(name, ground, crank, coupler, rocker, start, speed):
    """A planar four-bar of uniform bars, 1 kg per m; the crank's angle, rad."""
    b = (crank * math.cos(start), crank * math.sin(start))
    d = math.dist(b, (ground, 0))
    angle = math.atan2(b[1], b[0] - ground) - math.acos((rocker**2 + d**2 - coupler**2) / (2 * rocker * d))
    c = (ground + rocker * math.cos(angle), rocker * math.sin(angle))

    def bar(length, p, q):
        return {"mass": length, "com": [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, 0], "inertia": [length**3 / 12] * 3,
                "points": {"P": [*p, 0], "Q": [*q, 0]}}

    def pin(start_at, end_at, **more):
        return {"type": "revolute", "from": start_at, "to": end_at, "axis": "z", **more}

    return {"mbgen": 1, "name": name, "gravity": [0, -9.81, 0],
            "bodies": {"ground": {"points": {"A": [0, 0, 0], "D": [ground, 0, 0]}}, "crank": bar(crank, (0, 0), b),
                       "coupler": bar(coupler, b, c), "rocker": bar(rocker, (ground, 0), c)},
            "joints": {"crank": pin("ground.A", "crank.P"), "elbow": pin("crank.Q", "coupler.P"),
                       "rocker": pin("ground.D", "rocker.P"), "tip": pin("coupler.Q", "rocker.Q", cut=True)},
            "initial": {"velocities": {"crank": speed}}}


def body_on_rod(length):
    """A disc that two slides carry and a rod holds: it swings full circles."""
    return {"mbgen": 1, "name": "on_rod", "gravity": [0, -9.81, 0],
            "bodies": {"ground": {"points": {"O": [0, 0, 0], "S": [0, -length, 0]}},
                       "carriage": {"mass": 0.2, "inertia": [0.01, 0.01, 0.01], "com": [0, -length, 0],
                                    "points": {"C": [0, -length, 0]}},
                       "body": {"mass": 1, "inertia": [0.02, 0.02, 0.02], "com": [0, -length, 0],
                                "points": {"C": [0, -length, 0]}}},
            "joints": {"x": {"type": "prismatic", "from": "ground.S", "to": "carriage.C", "axis": "x"},
                       "y": {"type": "prismatic", "from": "carriage.C", "to": "body.C", "axis": "y"}},
            "rods": {"rod": {"from": "ground.O", "to": "body.C"}},
            "initial": {"velocities": {"x": 8}}}


def models(out):
    """Name, file, step in s, steps."""
    def written(name, model):
        path = out / f"{name}.json"
        path.write_text(model if isinstance(model, str) else json.dumps(model))
        return path

    grown = ROOT / "bench" / "growth_model.sh"
    for legs in (2, 4, 8, 12, 24):
        text = subprocess.run([grown, "walker", str(legs)], check=True, capture_output=True, text=True).stdout
        yield f"walking machine, {legs} legs", written(f"walker_{legs}", text), 1e-3, 3000
    yield "double crank", written("double_crank", four_bar("double_crank", 0.6, 1, 1.2, 1.1, 0.7, 6)), 1e-3, 3000
    yield "slider-crank", ROOT / "models" / "slider_crank.json", 1e-3, 3000
    yield "parallelogram through its flat positions", written(
        "parallelogram", four_bar("parallelogram", 2, 1, 2, 1, 1.5, 9)), 1e-3, 4000
    yield "kite through its folded positions", written("kite", four_bar("kite", 2, 1, 1, 2, 1.5, -6)), 1e-3, 4000
    for bars in (2, 10):
        text = subprocess.run([grown, "four-bar", str(bars)], check=True, capture_output=True, text=True).stdout
        yield f"row of {bars} four-bars", written(f"row_{bars}", text), 1e-3, 4000
    yield "body on a rod, full circles", written("on_rod", body_on_rod(0.5)), 1e-3, 4000
    for vehicle in ("coach", "truck"):
        yield f"{vehicle}, slalom", ROOT / "models" / f"{vehicle}.json", 1e-3, 4000
        kerb = {"mbgen": 1, "name": f"{vehicle}_kerb",
                "include": [os.path.relpath(ROOT / "models" / f"{vehicle}.json", out)],
                "roads": {"street": {"features": {
                    "kerb": {"type": "plank", "from": 10, "length": 15, "height": 0.05, "ramp": 0.1}}}}}
        yield f"{vehicle}, over a kerb", written(f"{vehicle}_kerb", kerb), 1e-3, 4000
        yield f"{vehicle}, hump", ROOT / "models" / "rides" / f"{vehicle}_hump.json", 1e-3, 4000


LOOP_LINES = (("const Real factor = row[k] / pivot_row[k];\n", "2 * (few < 0 ? loop.coordinates - k : few)"),
              ("int at = -1;\n", "loop.coordinates - first"), ("loop.places[count] = j;\n", "1"),
              ("const int j = loop.places[n];\n", "2"))
FINE_LINES = (("const Real entry = entries[column];\n", "2 * stride"),
              ("if (r == i || factor == 0) continue;\n", "2 * e.width"),
              ("const Real* const row = e.row(r);\n", "size + others"),
              ("const Real share = e.shares()[i];\n", "2 * solution.stride()"))


def count_in(header, lines, counter):
    """Adds to a header that the operations of some of its lines are counted."""
    text = header.read_text()
    for line, count in lines:
        assert line in text, line
        text = text.replace(line, f"{line}  counting::elimination += {count};\n")
    header.write_text(text.replace("namespace mbgen {", counter + "namespace mbgen {", 1))


def counted(mbgen, model, step, steps, out):
    """Per step: code, operations of programs, of the elimination, seconds."""
    subprocess.run([mbgen, "generate", str(model), "--out", str(out)], check=True, stdout=subprocess.DEVNULL)
    [manifest] = [p for p in out.glob("*.json")]
    made, name = json.loads(manifest.read_text())["programs"], manifest.stem
    solvers = out / "mbgen" / "solver"
    if (solvers / "loop.hpp").exists():
        count_in(solvers / "loop.hpp", LOOP_LINES, "namespace counting {\ninline long elimination;\n}\n")
        count_in(solvers / "fine.hpp", FINE_LINES, "")
    solver = (out / f"{name}.cpp").read_text()
    for place, program in enumerate(PROGRAMS):
        solver = re.sub(rf"auto {program} = &(\w+);", rf"auto {program} = &counting::Counted<{place}, &\1>::call;", solver)
    costs = [made[p]["operations"]["total"] if p in made else 0 for p in PROGRAMS.values()]
    driver = DRIVER.replace("@NAME@", name).replace("@COSTS@", ", ".join(map(str, costs)))
    driver = driver.replace("@STEPS@", str(steps)).replace("@STEP@", repr(step))
    source = out / "counted.cpp"
    source.write_text(f'#include "mbgen/solver/loop.hpp"\n{COUNTERS}{solver}{driver}')
    flags = ["-std=c++17", "-O2", "-march=native", "-ffp-contract=off", "-fno-math-errno", "-Wno-psabi", "-w"]
    subprocess.run([os.environ.get("CXX", "g++"), *flags, "-I", str(out), str(source), "-o", str(out / "counted")], check=True)
    lines = subprocess.run([str(out / "counted")], capture_output=True, text=True)
    if lines.returncode != 0:
        sys.exit(f"{model}: {lines.stdout.splitlines()[-1:]}")
    return [tuple(map(float, line.split())) for line in lines.stdout.splitlines()]


def median(values):
    return sorted(values)[len(values) // 2]


def main():
    mbgen = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "release" / "mbgen")
    if not os.access(mbgen, os.X_OK):
        mbgen = str(ROOT / "build" / "mbgen")
    out = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "build" / "slowest_steps")
    out.mkdir(parents=True, exist_ok=True)
    chosen = os.environ.get("MODELS", "").split(";")
    print("| motion | steps | chosen again, near, passed | median step, operations | slowest over median "
          "| with elimination | median step, us | slowest over median, time |")
    print("|---|---|---|---|---|---|---|---|")
    for name, model, step, steps in models(out):
        if not any(name.startswith(beginning) for beginning in chosen):
            continue
        rows = counted(mbgen, model, step, steps, out / pathlib.Path(model).stem)
        code = lambda wanted: sum(row[0] == wanted for row in rows)
        programs, whole, seconds = [r[1] for r in rows], [r[1] + r[2] for r in rows], [r[3] for r in rows]
        print(f"| {name} | {len(rows)} | {code(14)}, {code(15)}, {code(16)} | {median(programs):.0f} "
              f"| {max(programs) / median(programs):.2f} | {max(whole) / median(whole):.2f} | {median(seconds) * 1e6:.2f} "
              f"| {max(seconds) / median(seconds):.1f} |", flush=True)


main()
