#!/usr/bin/env python3
"""The walk of docs/authoring.md, as it stands on the page, compiles and is drawn.

    walk_test.py ROOT LINKDIG
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

BLOCK = re.compile(r"```toml\n# (\w+\.toml)[^\n]*\n(.*?)```", re.DOTALL)


def commands(linkdig, folder, names):
    """What the page tells to do with its files: the first is a database, the last a scenario."""
    compiled = str(Path(folder) / "walk.igdb")
    return [
        [linkdig, "compile", names[0], "-o", compiled],
        [linkdig, "inspect", compiled],
        [linkdig, "render", names[-1], "--frames", "0:1", "--size", "320x240", "--out", "pictures"],
    ]


def main():
    root, linkdig = Path(sys.argv[1]), sys.argv[2]
    page = (root / "docs/authoring.md").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        names = []
        for name, text in BLOCK.findall(page):
            with open(Path(folder) / name, "a", encoding="utf-8") as file:
                file.write(text)
            if name not in names:
                names.append(name)
        if not names:
            print("docs/authoring.md has no TOML blocks that begin with a file's name")
            return 1
        for command in commands(linkdig, folder, names):
            result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
            print(result.stdout + result.stderr, end="")
            if result.returncode != 0:
                print(f"{' '.join(command)}: exit code {result.returncode}")
                return 1
        if len(list((Path(folder) / "pictures").rglob("*.png"))) != 2:
            print("no two pictures were drawn")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
