#!/usr/bin/env python3
"""docs/frame-in-detail.md names the stages in the machine's order, every header of ig/, and no header that is not there.

    frame_in_detail_test.py ROOT
"""

import re
import sys
from pathlib import Path

STAGE = re.compile(r"^\| \[(\w+)\]\(#\w+\) \|", re.MULTILINE)
HEADING = re.compile(r"^## (\w+)$", re.MULTILINE)
HEADER = re.compile(r"`(ig/[\w/]+\.h)`")


def mistakes(root):
    page = (root / "docs/frame-in-detail.md").read_text(encoding="utf-8")
    stages = STAGE.findall(page)
    if not stages:
        yield "the page has no table of stages"
    if HEADING.findall(page)[: len(stages)] != stages:
        yield f"the first headings are not the stages, {', '.join(stages)}, in this order"
    for stage in stages:
        if not (root / "ig" / stage).is_dir():
            yield f"ig/{stage} is no folder, but the page has a stage of that name"
    there = {path.relative_to(root).as_posix() for path in (root / "ig").rglob("*.h")}
    named = set(HEADER.findall(page))
    for header in sorted(there - named):
        yield f"{header} is not named"
    for header in sorted(named - there):
        yield f"{header} is named, but is not there"


def main():
    found = list(mistakes(Path(sys.argv[1])))
    for mistake in found:
        print(f"docs/frame-in-detail.md: {mistake}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
