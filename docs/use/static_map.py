#!/usr/bin/env python3
"""Torques of the parallel ankle by three ways, over the frequency of a pitch of 0.25 rad and a roll of 0.15 rad.

  docs/use/static_map.py [MBGEN]

Prints the table of docs/use/actuators.md: the largest error of a motor's torque over its largest value in a period, of
the static map of the foot's torques, and of the same with the cranks and half of each rod's mass at either end.
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MBGEN = sys.argv[1] if len(sys.argv) > 1 else "mbgen"
ORDER = ["motor_a", "motor_b", "ankle_ry", "ankle_rx"]
POINTS = 64


def light(model, lumped):
    """The model without the mass of rods and cranks, or with cranks and half of each rod at either end."""
    if not lumped:
        for crank in ("crank_a", "crank_b"):
            model["bodies"][crank].update(mass=0, inertia=[0, 0, 0])
    masses = {name: rod.pop("mass") for name, rod in model["rods"].items()}
    if lumped:
        for name, mass in masses.items():
            for body, point in (rod_end(model, name, "from"), rod_end(model, name, "to")):
                add_point(model, f"{name}_{body}", body, point, mass / 2)
    return model


def rod_end(model, name, end):
    body, point = model["rods"][name][end].split(".")
    return body, point


def add_point(model, name, body, point, mass):
    place = model["bodies"][body]["points"][point]
    model["bodies"][name] = {"mass": mass, "com": place, "inertia": [0, 0, 0], "points": {"at": place}}
    model["joints"][name] = {"type": "fixed", "from": f"{body}.{point}", "to": f"{name}.at"}


def torques(model, states):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "model.json").write_text(json.dumps(model))
        (folder / "states.json").write_text(json.dumps({"joint_order": ORDER, "states": states}))
        answer = json.loads(subprocess.run(
            [MBGEN, "evaluate", folder / "model.json", "--inverse", "--project", "--states", folder / "states.json"],
            check=True, capture_output=True, text=True).stdout)
    assert all(state["status"] == "ok" for state in answer["states"])
    return [state["actuators"]["ankle_a"] for state in answer["states"]]


def period(frequency):
    states = []
    for i in range(POINTS):
        phase, w = 2 * math.pi * i / POINTS, 2 * math.pi * frequency
        pitch, roll = (0.25, phase), (0.15, phase + math.pi / 2)
        value = [a * math.sin(p) for a, p in (pitch, roll)]
        rate = [w * a * math.cos(p) for a, p in (pitch, roll)]
        states.append({"z": [value[0]] * 2 + value, "zd": [0, 0] + rate,
                       "zdd": {"ankle_ry": -w * w * value[0], "ankle_rx": -w * w * value[1]}})
    return states


def main():
    text = (ROOT / "models/robots/parallel_ankle.json").read_text()
    read = lambda: json.loads(re.sub(r"//.*", "", text))
    models = [read(), light(read(), False), light(read(), True)]
    print("| frequency | largest torque | static map | with lumped rods |")
    print("|---|---|---|---|")
    for frequency in (0.5, 1, 2, 5, 10):
        exact, static, lumped = (torques(model, period(frequency)) for model in models)
        largest = max(map(abs, exact))
        error = lambda other: 100 * max(abs(a - b) for a, b in zip(exact, other)) / largest
        print(f"| {frequency:g} Hz | {largest:.3g} N m | {error(static):.2g} % | {error(lumped):.2g} % |")


if __name__ == "__main__":
    main()
