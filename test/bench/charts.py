"""What all commands `./twinbus chart ...` share: the command line, tables kept as CSV, and the word on what was drawn.

    what = charts.asked("chart walk", __doc__, words, names)          # an Asked
    rows = charts.table(what, "speed.csv", measure)                   # measured and written, or read with --redraw
    charts.drawn(what.folder / "speed.svg", missing)
"""

import csv
import dataclasses
import pathlib
import sys

CHARTS = pathlib.Path(__file__).resolve().parents[1] / "charts"


@dataclasses.dataclass
class Asked:
    command: str  # as typed: "chart walk"
    folder: pathlib.Path
    names: list
    redraw: bool
    options: dict


class NoTable(Exception):
    """There is no table to draw from."""


def asked(command, about, words, names=(), options=()):
    """--help and a wrong word end the program.  names: what may be asked for; options: further ones with a value."""
    if "--help" in words or "-h" in words:
        print(about.strip())
        sys.exit(0)
    known, words = ["--out", *options], list(words)
    found = Asked(command, CHARTS / command.split()[-1], [], False, {})
    while words:
        word = words.pop(0)
        if word == "--redraw":
            found.redraw = True
        elif word in names:
            found.names.append(word)
        elif word in known and words:
            found.options[word] = words.pop(0)
        else:
            print(f"{command}: no chart or option '{word}'; there are {' '.join([*names, *known])} --redraw", file=sys.stderr)
            sys.exit(2)
    found.folder = pathlib.Path(found.options.pop("--out", found.folder))
    found.folder.mkdir(parents=True, exist_ok=True)
    return found


def write(file, rows, fields=None):
    """rows: one dictionary each."""
    rows = list(rows)
    with open(file, "w", newline="") as out:
        writer = csv.DictWriter(out, fields or rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


def read(file):
    with open(file, newline="") as source:
        return list(csv.DictReader(source))


def table(what, name, measure, fields=None):
    """The rows of a table, all values as text.  measure() gives them, unless they are there and only drawn anew."""
    file = what.folder / name
    if not what.redraw:
        write(file, measure(), fields)
    if not file.exists():
        raise NoTable(f"{what.command}: {file} is not there; run without --redraw")
    return read(file)


def drawn(picture, missing):
    """missing: what plot.write() says of a picture that could not be made."""
    print(picture if not missing else f"{picture} ({missing})", flush=True)


def run(main):
    """The exit status of main(words)."""
    try:
        return main(sys.argv[1:])
    except NoTable as error:
        print(error, file=sys.stderr)
        return 1


def one(command, about, name, measure, draw):
    """The same of a program with one table and what draw(rows, folder) makes of it."""
    def main(words):
        what = asked(command, about, words)
        draw(table(what, name, measure), what.folder)
        return 0
    return run(main)
