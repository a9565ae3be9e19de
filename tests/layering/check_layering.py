#!/usr/bin/env python3
"""Checks that data flows one way: which folder includes which, and a few words that have no place in some folders.

The rules are the table of docs/overview.md between the two `layering` marks; there is no second copy of them. A row
names a folder and, in its last column, the folders and single headers that it may include besides its own.

    check_layering.py [ROOT]      exit code 0: in order, 1: violations (one a line, file:line: error: what)
"""

import re
import sys
from pathlib import Path

SOURCE_SUFFIXES = {".h", ".cpp"}
TEXT_SUFFIXES = SOURCE_SUFFIXES | {".md", ".toml", ".txt", ".cmake", ".py", ".sh", ".fbs", ".json", ".yml"}
TOP_FOLDERS = ("database", "host", "ig", "tools", "tests")
BEGIN, END = "<!-- layering: begin -->", "<!-- layering: end -->"

INCLUDE = re.compile(r'^\s*#\s*include\s*(?P<open>["<])(?P<name>[^">]+)[">]')
NAME = re.compile(r"`([^`]+)`")

# Folder prefixes, pattern, and what to say. Comments count: a stage should not even be thought of in these words.
FORBIDDEN_WORDS = [
    (("ig/priority", "ig/geometry", "ig/edges", "ig/scanline", "ig/video", "ig/sink"),
     re.compile(r"\b(sea|ocean|water|waves?|wakes?)\b", re.IGNORECASE),
     'the machine does not know it draws water: "{0}" in a stage behind the active data base'),
    (("database", "host", "ig"),
     re.compile(r"(?<![\w.:])(?:std::)?(?:a?(?:sin|cos|tan)h?|atan2|exp2?|expm1|log(?:2|10|1p)?|pow|cbrt|hypot|[lt]gamma|erfc?)f?\s*\("),
     'the C library\'s "{0}" gives other bits on another CPU; use database/model/mathematics.h'),
    (("",),
     re.compile(r"(?<![\w.$}~*-])/(?:work|home|root|Users|tmp)/"),
     'a path of one machine: "{0}"'),
]
# Where those words are what the file is about.
EXEMPT = {"tests/layering/check_layering.py", "tests/layering/self_test.py"}


def read_rules(root):
    """The table as {folder: [folder or header that it may include]}."""
    text = (root / "docs/overview.md").read_text(encoding="utf-8")
    if BEGIN not in text or END not in text:
        raise SystemExit("docs/overview.md: error: no layering table between its two marks")
    rules = {}
    for line in text.split(BEGIN)[1].split(END)[0].splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        names = NAME.findall(cells[0])
        if len(cells) < 3 or len(names) != 1:
            continue  # heading and rule of the table
        rules[names[0].rstrip("/")] = [name.rstrip("/") for name in NAME.findall(cells[-1])]
    if not rules:
        raise SystemExit("docs/overview.md: error: the layering table has no rows")
    return rules


def within(name, folder):
    return name == folder or name.startswith(folder + "/")


def folder_of(name, rules):
    """The longest folder of the table that holds the file, or None."""
    holding = [folder for folder in rules if within(name, folder)]
    return max(holding, key=len, default=None)


def exists(root, name):
    """Is this a header of the tree, or one that flatc makes of a schema of the tree?"""
    schema = re.sub(r"_generated\.h$", ".fbs", name)
    return (root / name).is_file() or (schema != name and (root / schema).is_file())


def check_include(root, rules, name, included, quoted):
    """What is wrong with this #include of file `name`, or None."""
    if not included.startswith(tuple(top + "/" for top in TOP_FOLDERS)):
        if quoted:
            return f'"{included}" is not written from the root of the tree'
        return None
    if not exists(root, included):
        return f'"{included}" does not exist'
    folder = folder_of(name, rules)
    if folder is None:
        return f"{Path(name).parent} has no row in the table of docs/overview.md"
    if within(included, folder) and folder_of(included, rules) == folder:
        return None
    if any(within(included, allowed) for allowed in rules[folder]):
        return None
    return f'{folder} may not include "{included}" (table of docs/overview.md)'


def without_comments(line):
    return line.split("//")[0]


def check_words(name, number, line, problems):
    for folders, pattern, message in FORBIDDEN_WORDS:
        if not any(folder == "" or within(name, folder) for folder in folders) or name in EXEMPT:
            continue
        if "C library" in message:
            if Path(name).suffix not in SOURCE_SUFFIXES:
                continue
            line_looked_at = without_comments(line)
        else:
            line_looked_at = line
        found = pattern.search(line_looked_at)
        if found:
            problems.append(f"{name}:{number}: error: {message.format(found.group(0).strip())}")


def files(root):
    for top in sorted(root.iterdir()):
        if top.name in ("build", "out", ".git") or top.name.startswith("build"):
            continue
        for path in [top] if top.is_file() else sorted(top.rglob("*")):
            if path.is_file() and (path.suffix in TEXT_SUFFIXES or path.parent.name == ".ci"):
                yield path


def check(root):
    """All violations of the tree under `root`, as texts."""
    root = Path(root)
    rules = read_rules(root)
    problems = []
    for path in files(root):
        name = path.relative_to(root).as_posix()
        code = path.suffix in SOURCE_SUFFIXES and name.startswith(tuple(top + "/" for top in TOP_FOLDERS))
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
        if code and path.suffix == ".h" and "#pragma once" not in lines:
            problems.append(f"{name}:1: error: a header without #pragma once")
        for number, line in enumerate(lines, start=1):
            check_words(name, number, line, problems)
            include = INCLUDE.match(line) if code else None
            if include:
                problem = check_include(root, rules, name, include["name"], include["open"] == '"')
                if problem:
                    problems.append(f"{name}:{number}: error: {problem}")
    return problems


def main():
    problems = check(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
    for problem in problems:
        print(problem)
    print(f"layering: {len(problems)} violations" if problems else "layering: in order")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
