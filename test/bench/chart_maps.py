#!/usr/bin/env python3
"""./twinbus chart maps [MAP...] [--out DIR] [--redraw]: where each engine fails, how, and whether it said so.

The cells of ./twinbus bench maps (its --help says what they are), drawn as one table for each map and engine; the letter of a cell says
how it fails, and its shade whether the engine said so.  Written as SVG, PNG and CSV to DIR (default test/charts/maps); --redraw draws
from the CSV that is there.  About ten minutes.
"""

import sys

import bench_maps
import charts
import plot
from failure_cells import ENGINES, MAPS

CELL_W, CELL_H, GAP = 27, 15, 16
# (fill, letter): light is right, dark is wrong, black is wrong and unsaid; a grey picture keeps the order.
SHADES = {"right": ("#d5ecdb", "#222"), "doubted": ("#f7e8b0", "#222"), "said": ("#d9694f", "#fff"), "unsaid": ("#1c0b12", "#fff"),
          "left out": ("#f2f2f2", "#999")}
WORDS = (("right", "right"), ("doubted", "right, doubted (u)"), ("said", "wrong, and the engine said so"), ("unsaid", "wrong, unsaid or said late"),
         ("left out", "would take minutes, or cannot be loaded"))


def shade(line):
    if line["result"] in ("slow", "cannot"):
        return "left out"
    if not bench_maps.is_wrong(line):
        return line["result"]
    return "unsaid" if line["said"].startswith(("silent", "late")) else "said"


def letter(line):
    return bench_maps.HOW[line["result"]]


def table(lines, map_, engine, left, top):
    """SVG of one map of one engine, its lower edge, its right edge."""
    own = {(line["row"], line["column"]): line for line in lines if (line["map"], line["engine"]) == (map_.name, engine)}
    out = []
    for i, (row, _) in enumerate(map_.rows):
        for j, (column, _) in enumerate(map_.columns):
            x, y = left + CELL_W * j, top + CELL_H * i
            line = own.get((row, column))
            fill, ink = SHADES[shade(line)] if line else ("#fff", "#fff")
            out.append(f"<rect x='{x}' y='{y}' width='{CELL_W}' height='{CELL_H}' fill='{fill}' stroke='#fff' stroke-width='.8'/>")
            if line and letter(line):
                out.append(plot.text(x + CELL_W / 2, y + 11.5, letter(line), 10, "middle", ink, "bold"))
    bottom = top + CELL_H * len(map_.rows)
    for j, (column, _) in enumerate(map_.columns):
        out.append(plot.text(left + CELL_W * (j + 0.5), bottom + 11, column.split()[0], 9, "middle", "#444"))
    return out, bottom + 16


def draw(lines, file):
    engines = [engine for engine in ENGINES if any(line["engine"] == engine for line in lines)]
    side = 176
    wide = CELL_W * max(len(map_.columns) for map_ in MAPS) + GAP
    width = side + wide * len(engines) + 10
    out, y = [], 120
    for k, engine in enumerate(engines):
        out.append(plot.text(side + wide * k, y - 8, ENGINES[engine], 13, weight="bold"))
    y += 14
    for map_ in MAPS:
        if not any(line["map"] == map_.name for line in lines):
            continue
        out.append(plot.text(12, y - 2, map_.about + (f"; across: {map_.column_name}" if map_.column_name else ""), 12, weight="bold"))
        y += 6
        bottom = y
        for i, (row, _) in enumerate(map_.rows):
            out.append(plot.text(side - 6, y + CELL_H * i + 11.5, row, 10, "end", "#333"))
        for k, engine in enumerate(engines):
            more, bottom = table(lines, map_, engine, side + wide * k, y)
            out += more
        y = bottom + 22
    head = plot.frame("Where each engine fails", "more than 5 mm or 5 % of energy off, through or below what should stop it, or diverged; "
                      "throw, plate and edge have no reference for places", width, y)
    x = 12
    for key, meaning in WORDS:
        fill, ink = SHADES[key]
        head.append(f"<rect x='{x}' y='58' width='20' height='14' fill='{fill}' stroke='#444' stroke-width='.5'/>")
        if key in ("said", "unsaid"):
            head.append(plot.text(x + 10, 69, "D", 10, "middle", ink, "bold"))
        head.append(plot.text(x + 25, 69, meaning, 11))
        x += 46 + 6 * len(meaning)
    how = "   ".join(f"{mark} {word}" for word, mark in bench_maps.HOW.items() if mark not in ("", "-", "u"))
    head.append(plot.text(12, 90, how, 11))
    return plot.write(file, "\n".join([*head, *out, "</svg>"]))


def main(words):
    known = {map_.name: map_ for map_ in MAPS}
    what = charts.asked("chart maps", __doc__, words, list(known))
    chosen = [known[name] for name in what.names or known]
    lines = charts.table(what, "maps.csv", lambda: bench_maps.measured("chart maps", chosen, list(ENGINES)), bench_maps.FIELDS)
    bench_maps.summary(lines)
    charts.drawn(what.folder / "maps.svg", draw(lines, what.folder / "maps.svg"))
    return 0


if __name__ == "__main__":
    sys.exit(charts.run(main))
