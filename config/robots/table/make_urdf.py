#!/usr/bin/env python3
"""Writes this mechanism's URDF, SRDF and robot.yaml."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import mechanisms  # noqa: E402

mechanisms.write(__file__)
