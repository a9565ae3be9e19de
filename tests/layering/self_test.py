#!/usr/bin/env python3
"""Plants one violation of each kind in a small tree and expects the layering check to name it, and nothing else."""

import contextlib
import io
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_layering  # noqa: E402

TABLE = f"""# Overview
{check_layering.BEGIN}
| folder | holds | may include |
| --- | --- | --- |
| `database/model` | vocabulary | |
| `database/format` | files | `database/model` |
| `host/packet` | packet | `database/model` |
| `ig/active` | stage | `database/model`, `host/packet` |
| `ig/geometry` | stage | `database/model`, `ig/active/face_block.h` |
| `tools` | the binary | `database`, `host`, `ig` |
| `tests` | tests | `database`, `host`, `ig`, `tools` |
{check_layering.END}
"""

CLEAN = {
    "docs/overview.md": TABLE,
    "database/model/vectors.h": "#pragma once\n#include <cmath>\n",
    "database/format/file.fbs": "table File {}\n",
    "database/format/file.h": '#pragma once\n#include "database/format/file_generated.h"\n',
    "host/packet/packet.h": '#pragma once\n#include "database/model/vectors.h"\n',
    "ig/active/face_block.h": '#pragma once\n#include "host/packet/packet.h"\n// the sea ends here\n',
    "ig/active/activate.h": "#pragma once\n",
    "ig/geometry/project.h": '#pragma once\n#include "ig/active/face_block.h"\n// sine(angle), in the waterline frame\n',
    "tools/main.cpp": '#include "ig/active/activate.h"\n',
    "tests/ig/project_test.cpp": '#include "ig/geometry/project.h"\n#include <gtest/gtest.h>\n',
}

# File, text, and the words that the message must hold.
PLANTED = [
    ("database/model/bad.h", '#pragma once\n#include "host/packet/packet.h"\n', "database/model may not include"),
    ("host/packet/bad.cpp", '#include "ig/active/face_block.h"\n', "host/packet may not include"),
    ("host/packet/bad.cpp", "#include <ig/active/face_block.h>\n", "host/packet may not include"),
    ("host/packet/bad.cpp", '  #  include "database/format/file_generated.h"\n', "host/packet may not include"),
    ("ig/geometry/bad.cpp", '#include "ig/active/activate.h"\n', "ig/geometry may not include"),
    ("ig/active/bad.cpp", '#include "tools/main.cpp"\n', "ig/active may not include"),
    ("tools/bad.cpp", '#include "tests/ig/project_test.cpp"\n', "tools may not include"),
    ("ig/active/bad.cpp", '#include "face_block.h"\n', "not written from the root"),
    ("ig/active/bad.cpp", '#include "host/packet/gone.h"\n', "does not exist"),
    ("ig/water/bad.cpp", '#include "ig/active/activate.h"\n', "has no row"),
    ("ig/active/bad.h", "int x;\n", "without #pragma once"),
    ("ig/geometry/bad.cpp", "// the ocean's faces\n", "does not know it draws water"),
    ("host/packet/bad.cpp", "double y = std::sin(x);\n", "gives other bits on another CPU"),
    ("host/packet/bad.cpp", "double y = 2.0*atan2(x, z);\n", "gives other bits on another CPU"),
    ("docs/bad.md", "see /home/me/notes\n", "a path of one machine"),
]


def plant(root, tree):
    for name, text in tree.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def problems_with(extra):
    with tempfile.TemporaryDirectory() as folder:
        plant(Path(folder), {**CLEAN, **extra})
        return check_layering.check(folder)


def main():
    failures = []
    if problems_with({}):
        failures.append(f"the clean tree is not clean: {problems_with({})}")
    for name, text, expected in PLANTED:
        problems = problems_with({name: text})
        if len(problems) != 1 or expected not in problems[0] or not problems[0].startswith(name + ":"):
            failures.append(f"{name}: {text!r}: expected one problem with {expected!r}, got {problems}")
    with contextlib.redirect_stderr(io.StringIO()):
        try:
            problems_with({"docs/overview.md": "# no table\n"})
            failures.append("an overview without a table passes")
        except SystemExit:
            pass
    for failure in failures:
        print(failure)
    print(f"layering self-test: {len(PLANTED) + 2} cases, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
