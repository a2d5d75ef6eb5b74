"""What campaign is called where it runs: ./twinbus campaign in a source tree, twinbus campaign where it is installed."""

import argparse
import os
import sys

NAME = os.environ.get("TWINBUS_COMMAND", "./twinbus campaign")
PROGRAM = NAME.split(" ", maxsplit=1)[0]


class Parser(argparse.ArgumentParser):
    """Of `campaign WORD`.  What is wrong with the arguments is one line with the remedy."""

    def __init__(self, word="", **more):
        super().__init__(prog=f"{NAME} {word}".strip(), **more)

    def error(self, message):
        print(f"{self.prog.partition(' ')[2]}: {message} ({self.prog} --help says more)", file=sys.stderr)
        sys.exit(2)
