#!/usr/bin/env python3
"""Follows documents word for word: writes the files that they show, runs their commands, compares what they print.

    tests/system/documents/follow.py [--path DIRECTORY]... [--sources TREE] [--in DIRECTORY] [--update] DOCUMENT...

Each document is followed by one shell in an empty directory of its own, or in that of --in, with --path first in PATH.
These blocks count:

    ```json car.json          a block with the name of a file after its language: written as it stands
    ```console                commands after "$ ", lines that end with a backslash go on; then what they print.
    ```console exit=1         the same where the last command ends so

Nothing under a command: what it prints is not compared. "..." on a line of its own stands for any lines, within a
line for any text. The line <!-- in the source tree --> in a document gives it links to what --sources holds.
--update writes what was printed into the document in place of what differs, but not where there is "...".
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

IN_SOURCES = "<!-- in the source tree -->"
ANY_LINES, ANY_TEXT = "...", re.escape("...")


class Session:
    """A block of commands: (line number, command, lines expected) each, and the exit code of the last."""

    def __init__(self, exit_code):
        self.exit_code = exit_code
        self.commands = []


def read_session(lines, start, exit_code):
    session = Session(exit_code)
    for number, line in enumerate(lines, start):
        if line.startswith("$ "):
            session.commands.append([number, line[2:], []])
        elif session.commands and not session.commands[-1][2] and session.commands[-1][1].endswith("\\"):
            session.commands[-1][1] += "\n" + line
        elif session.commands:
            session.commands[-1][2].append(line)
        else:
            raise SystemExit(f"line {number}: a console block begins with a command after '$ '")
    return session


def blocks_of(text):
    """Files as (name, content) and sessions, in their order."""
    lines = text.split("\n")
    begin = None
    for index, line in enumerate(lines):
        if not line.startswith("```"):
            continue
        if begin is None:
            begin = index
            continue
        words, content = lines[begin][3:].split(), lines[begin + 1 : index]
        first = begin + 2
        begin = None
        if words and words[0] == "console":
            exit_code = int(words[1].removeprefix("exit=")) if len(words) > 1 else 0
            yield read_session(content, first, exit_code)
        elif len(words) == 2:
            yield words[1], "\n".join(content) + "\n"


def matches(expected, printed):
    """Whether the printed lines are the expected ones."""
    if not expected:
        return not printed
    if expected[0] == ANY_LINES:
        return any(matches(expected[1:], printed[skipped:]) for skipped in range(len(printed) + 1))
    if not printed:
        return False
    pattern = re.escape(expected[0]).replace(ANY_TEXT, ".*")
    return re.fullmatch(pattern, printed[0]) is not None and matches(expected[1:], printed[1:])


class Shell:
    """A shell that keeps its directory and its variables from command to command."""

    def __init__(self, directory, environment):
        self.process = subprocess.Popen(
            ["sh"],
            cwd=directory,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
        )
        self.mark = f"end-of-command-{os.getpid()}"

    def run(self, command):
        """Exit code, and lines printed."""
        self.process.stdin.write(f"{{ {command}\n}} </dev/null\nprintf '\\n%s %d\\n' {self.mark} $?\n")
        self.process.stdin.flush()
        lines = []
        for line in self.process.stdout:
            if line.startswith(self.mark):
                if lines and not lines[-1]:
                    lines.pop()  # of the mark
                return int(line.split()[1]), lines
            lines.append(line.rstrip())
        return self.process.wait(), lines  # the command ended the shell

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def follow_session(session, document, shell, replacements):
    problems = 0
    for index, (number, command, expected) in enumerate(session.commands):
        code, printed = shell.run(command)
        wanted = session.exit_code if index + 1 == len(session.commands) else 0
        if code != wanted:
            print(f"{document}:{number}: exit code {code}, not {wanted}: {command}")
            print("\n".join("    " + line for line in printed[-40:]))
            problems += 1
        elif expected and not matches(expected, printed):
            print(f"{document}:{number}: prints something else: {command}")
            print("\n".join("    " + line for line in printed[:60]))
            replacements.append((number + command.count("\n"), len(expected), printed))
            problems += 1
    return problems


def update(document, text, replacements):
    lines = text.split("\n")
    for last_line_of_command, count, printed in reversed(replacements):
        if not any("..." in line for line in lines[last_line_of_command : last_line_of_command + count]):
            lines[last_line_of_command : last_line_of_command + count] = printed
    document.write_text("\n".join(lines))


def follow(document, options):
    """Number of problems."""
    text = document.read_text()
    # Lines of progress depend on the time.
    environment = dict(os.environ, LC_ALL="C.UTF-8", NO_COLOR="1", MBGEN_PROGRESS="0")
    environment["PATH"] = os.pathsep.join([str(path.resolve()) for path in options.path] + [environment["PATH"]])
    problems, commands, replacements = 0, 0, []
    with tempfile.TemporaryDirectory(prefix="follow.") as empty:
        directory = options.directory or empty
        if IN_SOURCES in text and not options.directory:
            for entry in sorted(options.sources.resolve().iterdir()):
                if not entry.name.startswith(".") and entry.name != "build":
                    os.symlink(entry, os.path.join(directory, entry.name))
        shell = Shell(directory, environment)
        for block in blocks_of(text):
            if isinstance(block, Session):
                commands += len(block.commands)
                problems += follow_session(block, document, shell, replacements)
            else:
                name, content = block
                pathlib.Path(directory, name).write_text(content)
        shell.close()
    if options.update:
        update(document, text, replacements)
    if commands == 0:
        print(f"{document}: has no commands")
        problems += 1
    print(f"{document}: {commands} commands, {problems} problems")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--path", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--sources", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[3])
    parser.add_argument("--in", dest="directory", type=pathlib.Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("documents", type=pathlib.Path, nargs="+", metavar="DOCUMENT")
    options = parser.parse_args()
    sys.exit(1 if sum(follow(document, options) for document in options.documents) else 0)


if __name__ == "__main__":
    main()
