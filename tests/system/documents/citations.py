#!/usr/bin/env python3
"""Checks that citations of documents, links between them and paths in them lead somewhere.

    tests/system/documents/citations.py [TREE]

In sources and documents:  every page of docs/ that is named exists, where its folder is named there; "PAGE.md section N",
                           "PAGE.md sections N to M" and 'PAGE.md, "Heading"' name headings of the page ("## N Heading").
In README.md and docs:     relative links and their anchors exist; paths in `code` that start with a folder of the tree
                           exist.
In docs/README.md:         every page has its line.
In tests/tools/mutations.txt:    every fault finds the text that it replaces.

Prints file:line: fault, one a line. Exit code: 0 without faults, 1 with faults.
"""

import glob
import pathlib
import re
import subprocess
import sys

FOLDERS = "bench cmake compiler docs examples models runtime templates tests".split()
TEXTS = {".cpp", ".hpp", ".h", ".in", ".md", ".py", ".sh", ".cmake", ".txt", ".html", ".js", ".mjs", ".c"}
ITSELF = "tests/system/documents/citations.py"
BROKEN = "tests/system/documents/broken"  # a tree with faults, for the test of this test
GAP = r"(?:[ \t]|\n[ \t]*(?:///?<?|#|\*)?)+"  # blanks, or a new line of the comment
PAGE = r"(?<![\w./$-])((?:docs/(?:[a-z_]+/)?)?[a-z_]+\.md)"
NUMBERS = rf"(\d+(?:(?:,{GAP}|{GAP}and{GAP}|{GAP}to{GAP})\d+)*)"
SECTIONS = re.compile(rf"{PAGE}(?:,?{GAP}sections?)?,?{GAP}{NUMBERS}")
QUOTED = re.compile(rf'{PAGE},{GAP}"([^"\n]+)"')
LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
PATH = re.compile(rf"(?<![\w./*$-])((?:{'|'.join(FOLDERS)})/[\w./*-]*)")


def texts_of(tree):
    files = [tree / "README.md", tree / "CMakeLists.txt"]
    for folder in FOLDERS:
        files += sorted(f for f in (tree / folder).rglob("*") if f.suffix in TEXTS)
    for file in files:
        name = file.relative_to(tree).as_posix()
        if file.is_file() and "node_modules" not in name and not name.startswith(BROKEN) and name != ITSELF:
            yield name, file.read_text(encoding="utf-8", errors="replace")


def without_code_blocks(text):
    """Blanks in place of ``` blocks, so that offsets stay."""
    return re.sub(r"^```.*?^```", lambda block: re.sub(r"[^\n]", " ", block[0]), text, flags=re.M | re.S)


def headings(text):
    return re.findall(r"^#+ +(.+?) *$", without_code_blocks(text), flags=re.M)


def anchor(heading):
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def numbers(text):
    """1, 2, 3 of "1 to 3"; 1, 4 of "1 and 4"."""
    found, last = [], None
    for word in re.findall(r"\d+|to", text):
        if word == "to":
            last = found[-1]
        else:
            found += range(last + 1, int(word) + 1) if last is not None else [int(word)]
            last = None
    return found


def page_of(tree, cited):
    """The page that is cited by its path or by its name alone; a path that does not exist where there is none."""
    if "/" in cited:
        return tree / cited
    return next(iter(sorted((tree / "docs").glob(f"*/{cited}"))), tree / "docs" / cited)


def citation_faults(tree, text):
    """(offset, fault) of every page and section that the text names."""
    for match in re.finditer(PAGE, text):
        if not page_of(tree, match[1]).is_file():
            yield match.start(), f"no page {match[1]} in docs/"
    for match in SECTIONS.finditer(text):
        page = page_of(tree, match[1])
        if not re.search(r"sections?", match[0]):
            yield match.start(), f'"{match[1]} {match[2]}" is to be written "{match[1]} section {match[2]}"'
        elif page.is_file():
            there = {h.split()[0] for h in headings(page.read_text(encoding="utf-8"))}
            for number in numbers(match[2]):
                if str(number) not in there:
                    yield match.start(), f"{match[1]} has no section {number}"
    for match in QUOTED.finditer(text):
        page = page_of(tree, match[1])
        if page.is_file() and match[2].rstrip(".,") not in headings(page.read_text(encoding="utf-8")):
            yield match.start(), f'{match[1]} has no heading "{match[2]}"'


def link_faults(tree, name, text):
    """(offset, fault) of every relative link and every path of a document."""
    text = without_code_blocks(text)
    for match in LINK.finditer(text):
        target, _, part = match[1].partition("#")
        if "://" in target:
            continue
        file = (tree / name).parent / target if target else tree / name
        if not file.exists():
            yield match.start(), f"the link {match[1]} leads to no file"
        elif part and part not in map(anchor, headings(file.read_text(encoding="utf-8"))):
            yield match.start(), f"the link {match[1]} leads to no heading"
    for code in CODE.finditer(text):
        for match in PATH.finditer(code[1]):
            path = match[1].rstrip(".")
            if not glob.glob(str(tree / path)) and not glob.glob(str(tree / path) + ".cpp"):
                yield code.start(), f"no file {path}"


def index_faults(tree, text):
    """(offset, fault) of every page that the index does not link."""
    links = {target.partition("#")[0] for target in LINK.findall(text)}
    for page in sorted((tree / "docs").glob("*/*.md")):
        name = page.relative_to(tree / "docs").as_posix()
        if name not in links:
            yield 0, f"the index does not link {name}"


def mutation_faults(tree, text):
    """(offset, fault) of every fault put in on purpose that would change nothing."""
    offset = 0
    for line in text.splitlines(keepends=True):
        if line.strip() and not line.startswith("#"):
            file, expression = (part.strip() for part in line.split("|", 3)[1:3])
            sound = (tree / file).read_text(encoding="utf-8") if (tree / file).is_file() else None
            if sound is None:
                yield offset, f"no file {file}"
            elif subprocess.run(["sed", expression, str(tree / file)], capture_output=True, text=True).stdout == sound:
                yield offset, f"{file} holds nothing that the expression replaces"
        offset += len(line)


def faults(tree):
    for name, text in texts_of(tree):
        found = list(citation_faults(tree, text))
        if name == "README.md" or re.fullmatch(r"docs/[\w/]+\.md", name):
            found += link_faults(tree, name, text)
        if name == "docs/README.md":
            found += index_faults(tree, text)
        if name == "tests/tools/mutations.txt":
            found += mutation_faults(tree, text)
        for offset, fault in sorted(set(found)):
            line = text.count("\n", 0, offset) + 1
            yield f"{name}:{line}: {fault}"


if __name__ == "__main__":
    tree = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if tree.is_file():
        tree = tree.parents[3]
    found = list(faults(tree))
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
