"""What a policy, its specification or its robot cannot do, in one sentence with the remedy."""
from __future__ import annotations


class PolicyError(ValueError):
    """Names file, line or field, and the remedy.  The command line prints it and exits with 1."""


class Refused(PolicyError):
    """The specification is understood, and asks for what this stack does not have: a motion to follow, a picture, heights."""
