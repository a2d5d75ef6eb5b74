#!/usr/bin/env python3
"""Where a release of MuJoCo keeps armatures and contacts: the row of kLayouts in sim/mujoco/mujoco_library.cpp.

    mujoco_layout.py FOLDER      the include folder of a wheel or of MuJoCo's archive, which holds mujoco/mujoco.h
"""

import pathlib
import subprocess
import sys
import tempfile

PROGRAM = """
#include <mujoco/mujoco.h>
#include <stddef.h>
#include <stdio.h>
int main(void) {
  printf("    {%d, %zu, %zu, %zu, %zu, %zu, %zu, %s},\\n", mjVERSION_HEADER, offsetof(mjModel, dof_armature), offsetof(mjModel, dof_M0),
         offsetof(mjData, ncon), offsetof(mjData, contact), sizeof(mjContact),
         offsetof(mjContact, geom), mjSTATE_CTRL == 1 << 6 ? "true" : "false");
  int known = offsetof(mjContact, dist) == 0 && offsetof(mjContact, pos) == 8 && offsetof(mjContact, frame) == 32 && sizeof(mjVFS) <= 64;
  if (!known) puts("distance, position and frame lie elsewhere, or mjVFS is larger: mujoco_library.cpp has to learn it");
  return !known;
}
"""


def main():
    if len(sys.argv) != 2 or not (pathlib.Path(sys.argv[1]) / "mujoco/mujoco.h").is_file():
        print(__doc__.strip(), file=sys.stderr)
        sys.exit(2)
    with tempfile.TemporaryDirectory() as work:
        source = pathlib.Path(work) / "layout.c"
        source.write_text(PROGRAM)
        subprocess.run(["cc", "-I", sys.argv[1], str(source), "-o", str(source.with_suffix(""))], check=True)
        sys.exit(subprocess.run([str(source.with_suffix(""))], check=False).returncode)


if __name__ == "__main__":
    main()
