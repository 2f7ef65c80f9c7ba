"""A room's archive needs symbols of the rooms that its line in CMakeLists.txt reaches, and of no other.

usage: archives.py SOURCE_FOLDER BUILD_FOLDER. Prints `room: symbol stands in room ...` for each other one and exits with 1;
exits with 77 where nm is not installed. Linkers that look through archives again hide the order of rooms.
"""
import pathlib
import re
import shutil
import subprocess
import sys


def rooms_of(cmake):
    """Per room the rooms that its line names."""
    lines = re.findall(r"^mbgen_room\(([^)]*)\)", cmake, re.M)
    words = [line.split() for line in lines]
    return {room: [use[6:] for use in uses if use.startswith("mbgen_")] for room, _, *uses in words}


def reached(rooms, room):
    found, open_rooms = {room}, [room]
    while open_rooms:
        for use in rooms.get(open_rooms.pop(), []):
            if use not in found:
                found.add(use)
                open_rooms.append(use)
    return found


def symbols_of(archive):
    """Functions that an archive defines, and symbols that it lacks. Inline ones stand in every archive that needs them."""
    listing = subprocess.run(["nm", "-C", archive], capture_output=True, text=True, check=True).stdout
    defined = set(re.findall(r"^[0-9a-f]{16} T (mbgen::.*)$", listing, re.M))
    lacking = set(re.findall(r"^ +U (mbgen::.*)$", listing, re.M))
    return defined, lacking


def main(source, build):
    if shutil.which("nm") is None:
        print("skipped: nm is not installed")
        return 77
    rooms = rooms_of(pathlib.Path(source, "CMakeLists.txt").read_text())
    archives = {room: path for room in rooms if (path := pathlib.Path(build, f"libmbgen_{room}.a")).exists()}
    symbols = {room: symbols_of(path) for room, path in archives.items()}
    home = {symbol: room for room, (defined, _) in symbols.items() for symbol in defined}
    wrong = [
        f"{room}: {symbol} stands in room {home[symbol]}, which its line does not reach"
        for room, (_, lacking) in symbols.items()
        for symbol in sorted(lacking)
        if symbol in home and home[symbol] not in reached(rooms, room)
    ]
    print("\n".join(wrong) if wrong else f"{len(symbols)} archives need what their lines reach")
    return 1 if wrong or len(symbols) < len(rooms) // 2 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
