"""Charts without a library: log-log curves and maps as SVG, and PNG by rsvg-convert or chromium where one is installed."""

import html
import math
import pathlib
import shutil
import subprocess

COLORS = ("#1f6fb4", "#d1495b", "#2a9d5c", "#8a4fbf", "#e08a1e", "#0f8b8d", "#7a5c3e", "#666666", "#c2410c", "#3f3cbb")
DASHES = ("", "9 3", "3 3", "9 3 2 3", "1.5 4")
FONT = "font-family='DejaVu Sans, Helvetica, Arial, sans-serif'"
WIDTH, HEIGHT = 900, 560
LEFT, RIGHT, TOP, BOTTOM = 82, 250, 62, 62


def mark(x, y, k, color, size=3.6, hollow=False):
    """The k-th shape, so that curves are told apart without colours too."""
    look = f"fill='{'white' if hollow else color}' stroke='{color}' stroke-width='{2.0 if hollow else 0.8}'"
    corners = {1: ((-1, -1), (1, -1), (1, 1), (-1, 1)), 2: ((0, -1.3), (1.15, 0.9), (-1.15, 0.9)), 3: ((0, -1.45), (1.45, 0), (0, 1.45), (-1.45, 0)),
               4: ((-1.15, -0.9), (1.15, -0.9), (0, 1.3)), 5: ((-0.5, -1.4), (0.5, -1.4), (0.5, 1.4), (-0.5, 1.4)),
               6: ((-1.4, -0.5), (1.4, -0.5), (1.4, 0.5), (-1.4, 0.5))}.get(k % 7)
    if corners is None:
        return f"<circle cx='{x:.1f}' cy='{y:.1f}' r='{size}' {look}/>"
    return f"<polygon points='{' '.join(f'{x + size * i:.1f},{y + size * j:.1f}' for i, j in corners)}' {look}/>"


def text(x, y, words, size=13, anchor="start", color="#222", weight="normal", turn=None):
    rotate = f" transform='rotate({turn} {x:.1f} {y:.1f})'" if turn else ""
    return (f"<text x='{x:.1f}' y='{y:.1f}' font-size='{size}' text-anchor='{anchor}' fill='{color}' font-weight='{weight}' "
            f"{FONT}{rotate}>{html.escape(words)}</text>")


def _power(value):
    exponent = round(math.log10(value))
    return f"{value:g}" if -3 <= exponent <= 4 else f"1e{exponent}"


def frame(title, subtitle, width=WIDTH, height=HEIGHT):
    return [f"<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}' viewBox='0 0 {width} {height}'>",
            f"<rect width='{width}' height='{height}' fill='white'/>", text(LEFT, 26, title, 17, weight="bold"),
            text(LEFT, 46, subtitle, 12, color="#555")]


def loglog(title, subtitle, x_name, y_name, curves, marks=(), choices=()):
    """curves: [(label, [(x, y)], dashed)]; marks: [(y, words)], horizontal lines; choices: [(label, [(x, y)])], large hollow marks.  Points that
    are not positive are left out."""
    curves = [(label, [(x, y) for x, y in points if x > 0.0 and y > 0.0], dashed) for label, points, dashed in curves]
    curves = [curve for curve in curves if curve[1]]
    every = [point for _, points, _ in curves for point in points] + [point for _, points in choices for point in points]
    x0, x1 = (f(math.log10(x) for x, _ in every) for f in (min, max))
    y0, y1 = (f(math.log10(y) for _, y in every) for f in (min, max))
    x0, x1, y0, y1 = math.floor(x0 * 2) / 2, math.ceil(x1 * 2) / 2, math.floor(y0), math.ceil(y1)
    x1, y1 = max(x1, x0 + 1), max(y1, y0 + 1)

    def px(x):
        return LEFT + (math.log10(x) - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT)

    def py(y):
        return HEIGHT - BOTTOM - (math.log10(y) - y0) / (y1 - y0) * (HEIGHT - TOP - BOTTOM)
    out = frame(title, subtitle)
    bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT
    for e in range(math.ceil(x0), math.floor(x1) + 1):
        x = px(10.0 ** e)
        out.append(f"<line x1='{x:.1f}' y1='{TOP}' x2='{x:.1f}' y2='{bottom}' stroke='#ddd'/>")
        out.append(text(x, bottom + 18, _power(10.0 ** e), 12, "middle"))
    step = 1 if y1 - y0 <= 10 else 2
    for e in range(y0, y1 + 1, step):
        y = py(10.0 ** e)
        out.append(f"<line x1='{LEFT}' y1='{y:.1f}' x2='{right}' y2='{y:.1f}' stroke='#ddd'/>")
        out.append(text(LEFT - 8, y + 4, _power(10.0 ** e), 12, "end"))
    for value, words in marks:
        if y0 <= math.log10(value) <= y1:
            out.append(f"<line x1='{LEFT}' y1='{py(value):.1f}' x2='{right}' y2='{py(value):.1f}' stroke='#999' "
                       "stroke-dasharray='2 4'/>")
            out.append(text(right - 4, py(value) - 4, words, 11, "end", "#777"))
    out.append(f"<rect x='{LEFT}' y='{TOP}' width='{right - LEFT}' height='{bottom - TOP}' fill='none' stroke='#444'/>")
    out.append(text((LEFT + right) / 2, HEIGHT - 20, x_name, 13, "middle"))
    out.append(text(24, (TOP + bottom) / 2, y_name, 13, "middle", turn=-90))
    for k, (label, points, dashed) in enumerate(curves):
        color, dash = COLORS[k % len(COLORS)], " stroke-dasharray='6 4'" if dashed else ""
        way = " ".join(f"{px(x):.1f},{py(y):.1f}" for x, y in points)
        out.append(f"<polyline points='{way}' fill='none' stroke='{color}' stroke-width='2.2'{dash}/>")
        out += [mark(px(x), py(y), k, color) for x, y in points]
        y = TOP + 12 + 21 * k
        out.append(f"<line x1='{right + 14}' y1='{y}' x2='{right + 40}' y2='{y}' stroke='{color}' stroke-width='2.2'{dash}/>")
        out += [mark(right + 27, y, k, color), text(right + 46, y + 4, label, 12)]
    for k, (label, points) in enumerate(choices):
        out += [mark(px(x), py(y), k, "#000", 8.0 - 2.5 * k, True) for x, y in points]
        y = TOP + 12 + 21 * (len(curves) + k)
        out += [mark(right + 27, y, k, "#000", 8.0 - 2.5 * k, True), text(right + 46, y + 4, label, 12)]
    out.append("</svg>")
    return "\n".join(out)


def scatter(title, subtitle, x_name, y_name, clouds, size=3.0):
    """clouds: [(label, [(x, y)])]; x in powers of ten, y from zero."""
    clouds = [(label, [(x, y) for x, y in points if x > 0.0]) for label, points in clouds]
    every = [point for _, points in clouds for point in points]
    x0, x1 = math.floor(min(math.log10(x) for x, _ in every)), math.ceil(max(math.log10(x) for x, _ in every))
    top = max(1e-9, max(y for _, y in every))
    step = min((m * 10.0 ** e for e in range(-6, 7) for m in (1, 2, 5)), key=lambda s: abs(top / s - 6))
    y1 = math.ceil(top / step) * step
    bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT

    def px(x):
        return LEFT + (math.log10(x) - x0) / (x1 - x0) * (right - LEFT)

    def py(y):
        return bottom - y / y1 * (bottom - TOP)
    out = frame(title, subtitle)
    for e in range(x0, x1 + 1):
        x = px(10.0 ** e)
        out.append(f"<line x1='{x:.1f}' y1='{TOP}' x2='{x:.1f}' y2='{bottom}' stroke='#ddd'/>")
        out.append(text(x, bottom + 18, _power(10.0 ** e), 12, "middle"))
    for i in range(round(y1 / step) + 1):
        y = py(i * step)
        out.append(f"<line x1='{LEFT}' y1='{y:.1f}' x2='{right}' y2='{y:.1f}' stroke='#ddd'/>")
        out.append(text(LEFT - 8, y + 4, f"{i * step:g}", 12, "end"))
    out.append(f"<rect x='{LEFT}' y='{TOP}' width='{right - LEFT}' height='{bottom - TOP}' fill='none' stroke='#444'/>")
    out.append(text((LEFT + right) / 2, HEIGHT - 20, x_name, 13, "middle"))
    out.append(text(24, (TOP + bottom) / 2, y_name, 13, "middle", turn=-90))
    for k, (label, points) in enumerate(clouds):
        color, y = COLORS[k % len(COLORS)], TOP + 12 + 21 * k
        out += [f"<circle cx='{px(x):.1f}' cy='{py(v):.1f}' r='{size}' fill='{color}' fill-opacity='0.6'/>" for x, v in points]
        out.append(f"<circle cx='{right + 24}' cy='{y}' r='5' fill='{color}'/>")
        out.append(text(right + 36, y + 4, label, 12))
    out.append("</svg>")
    return "\n".join(out)


def table_map(title, subtitle, panels, rows, columns, row_name, column_name, colors, legend):
    """panels: [(name, {(row, column): word})]; one coloured cell for each word, drawn side by side."""
    cell_w, cell_h, gap, per_line = 34, 24, 30, 3
    most = max(len([r for r in rows if any((r, c) in cells for c in columns)]) for _, cells in panels)
    panel_w, panel_h = 90 + cell_w * len(columns), 60 + cell_h * most
    lines = math.ceil(len(panels) / per_line)
    width = max(LEFT + per_line * (panel_w + gap), 700)
    height = TOP + 30 + lines * (panel_h + gap)
    out = frame(title, subtitle, width, height)
    x = LEFT
    for word, meaning in legend:
        out.append(f"<rect x='{x}' y='56' width='14' height='14' fill='{colors[word]}' stroke='#444' stroke-width='.5'/>")
        out.append(text(x + 19, 68, meaning, 12))
        x += 32 + 7 * len(meaning)
    for k, (name, cells) in enumerate(panels):
        left, top = 20 + (k % per_line) * (panel_w + gap) + 82, TOP + 44 + (k // per_line) * (panel_h + gap)
        own = [r for r in rows if any((r, c) in cells for c in columns)]
        out.append(text(left, top - 8, name, 13, weight="bold"))
        for i, r in enumerate(own):
            out.append(text(left - 6, top + cell_h * i + 16, str(r), 11, "end"))
            for j, c in enumerate(columns):
                color = colors.get(cells.get((r, c)), "#f2f2f2")
                out.append(f"<rect x='{left + cell_w * j}' y='{top + cell_h * i}' width='{cell_w}' height='{cell_h}' "
                           f"fill='{color}' stroke='white'/>")
        bottom = top + cell_h * len(own)
        for j, c in enumerate(columns):
            out.append(text(left + cell_w * (j + 0.5), bottom + 14, str(c), 11, "middle"))
        out.append(text(left + cell_w * len(columns) / 2, bottom + 30, column_name, 11, "middle", "#555"))
        out.append(text(left - 72, top + cell_h * len(own) / 2, row_name if len(own) > 6 else "", 11, "middle", "#555", turn=-90))
    out.append("</svg>")
    return "\n".join(out)


def write(path, svg):
    """SVG, and PNG beside it; returns a sentence if there is nothing that makes PNGs."""
    path = pathlib.Path(path)
    path.write_text(svg + "\n")
    png = path.with_suffix(".png")
    head = svg[:200]
    width, height = (int(head.split(f"{name}='")[1].split("'")[0]) for name in ("width", "height"))
    if shutil.which("rsvg-convert"):
        subprocess.run(["rsvg-convert", "-o", png, path], check=True)
        return None
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if not browser:
        return "no PNG: install librsvg2-bin (rsvg-convert) or chromium"
    done = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                           f"--window-size={width},{height}", f"--screenshot={png}", path.resolve().as_uri()],
                          capture_output=True, timeout=120)
    return None if done.returncode == 0 and png.exists() else "no PNG: chromium failed; install librsvg2-bin (rsvg-convert)"


def lines(title, subtitle, x_name, y_name, curves, outlines=(), alike=False):
    """Linear axes.  curves: [(label, [(x, y)])]; outlines: closed polygons [[(x, y)]]; alike: one scale for both axes."""
    every = [point for _, points in curves for point in points] + [point for outline in outlines for point in outline]
    x0, x1 = (f(x for x, _ in every) for f in (min, max))
    y0, y1 = (f(y for _, y in every) for f in (min, max))
    margin = 0.05 * (y1 - y0) or 1.0
    y0, y1 = y0 - margin, y1 + margin
    wide, high = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
    if alike:  # the same metres a pixel
        scale = max((x1 - x0) / wide, (y1 - y0) / high)
        middle = 0.5 * (y0 + y1)
        y0, y1, x1 = middle - 0.5 * scale * high, middle + 0.5 * scale * high, x0 + scale * wide
    bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT

    def at(point):
        return LEFT + (point[0] - x0) / (x1 - x0) * wide, bottom - (point[1] - y0) / (y1 - y0) * high

    out = frame(title, subtitle)
    for value in _ticks(x0, x1):
        x, _ = at((value, y0))
        out.append(f"<line x1='{x:.1f}' y1='{TOP}' x2='{x:.1f}' y2='{bottom}' stroke='#ddd'/>" + text(x, bottom + 18, f"{value:.5g}", 12, "middle"))
    for value in _ticks(y0, y1):
        _, y = at((x0, value))
        out.append(f"<line x1='{LEFT}' y1='{y:.1f}' x2='{right}' y2='{y:.1f}' stroke='#ddd'/>" + text(LEFT - 8, y + 4, f"{value:.5g}", 12, "end"))
    for outline in outlines:
        corners = " ".join("{:.1f},{:.1f}".format(*at(point)) for point in outline)
        out.append(f"<polygon points='{corners}' fill='#eef2f6' stroke='#888'/>")
    out.append(f"<rect x='{LEFT}' y='{TOP}' width='{right - LEFT}' height='{bottom - TOP}' fill='none' stroke='#444'/>")
    out.append(text((LEFT + right) / 2, HEIGHT - 20, x_name, 13, "middle"))
    out.append(text(24, (TOP + bottom) / 2, y_name, 13, "middle", turn=-90))
    for k, (label, points) in enumerate(curves):
        color, y = COLORS[k % len(COLORS)], TOP + 12 + 21 * k
        dash = f" stroke-dasharray='{DASHES[k % len(DASHES)]}'" if DASHES[k % len(DASHES)] else ""  # told apart without colours too
        way = " ".join("{:.1f},{:.1f}".format(*at(point)) for point in points)
        out.append(f"<polyline points='{way}' fill='none' stroke='{color}' stroke-width='1.6'{dash}/>")
        out.append(f"<line x1='{right + 14}' y1='{y}' x2='{right + 40}' y2='{y}' stroke='{color}' stroke-width='2.2'{dash}/>" + text(right + 46, y + 4, label, 12))
    out.append("</svg>")
    return "\n".join(out)


def _ticks(low, high, most=8):
    step = 10.0 ** math.floor(math.log10((high - low) / most))
    step *= next(k for k in (1, 2, 5, 10) if (high - low) / (k * step) <= most)
    return [step * k for k in range(math.ceil(low / step), math.floor(high / step) + 1)]


def panels(title, subtitle, x_name, labels, rows, high=104):
    """Curves above one another on one axis.  labels: of the curves, the same in every panel; rows: [(y name, words at its right,
    [[(x, y)]])]."""
    gap, right_edge = 30, WIDTH - 30
    height = TOP + 22 + len(rows) * (high + gap) + BOTTOM - gap
    out = frame(title, subtitle, WIDTH, height)
    every = [x for _, _, curves in rows for points in curves for x, _ in points]
    x0, x1 = min(every), max(every)
    at = LEFT
    for k, label in enumerate(labels):
        out.append(f"<line x1='{at}' y1='{TOP}' x2='{at + 26}' y2='{TOP}' stroke='{COLORS[k]}' stroke-width='2.2'/>")
        out.append(text(at + 32, TOP + 4, label, 12))
        at += 60 + 7 * len(label)
    for i, (name, words, curves) in enumerate(rows):
        top = TOP + 36 + i * (high + gap)
        bottom = top + high
        values = [y for points in curves for _, y in points]
        margin = 0.06 * (max(values) - min(values)) or 1.0
        y0, y1 = min(values) - margin, max(values) + margin

        def place(point, y0=y0, y1=y1, bottom=bottom):
            return LEFT + (point[0] - x0) / (x1 - x0) * (right_edge - LEFT), bottom - (point[1] - y0) / (y1 - y0) * high
        for value in _ticks(x0, x1):
            x, _ = place((value, y0))
            out.append(f"<line x1='{x:.1f}' y1='{top}' x2='{x:.1f}' y2='{bottom}' stroke='#ddd'/>")
            if i == len(rows) - 1:
                out.append(text(x, bottom + 18, f"{value:.5g}", 12, "middle"))
        for value in _ticks(y0, y1, 4):
            _, y = place((x0, value))
            out.append(f"<line x1='{LEFT}' y1='{y:.1f}' x2='{right_edge}' y2='{y:.1f}' stroke='#ddd'/>" + text(LEFT - 8, y + 4, f"{value:.5g}", 11, "end"))
        out.append(f"<rect x='{LEFT}' y='{top}' width='{right_edge - LEFT}' height='{high}' fill='none' stroke='#444'/>")
        out.append(text(LEFT, top - 5, name, 12, weight="bold") + text(right_edge, top - 5, words, 12, "end", "#555"))
        for k, points in enumerate(curves):
            way = " ".join("{:.1f},{:.1f}".format(*place(point)) for point in points)
            out.append(f"<polyline points='{way}' fill='none' stroke='{COLORS[k]}' stroke-width='1.4'/>")
    out.append(text((LEFT + right_edge) / 2, height - 16, x_name, 13, "middle"))
    out.append("</svg>")
    return "\n".join(out)


def film(title, subtitle, strips, cell):
    """Rows of pictures.  strips: [(name, [(words below, draw(left, ground) -> SVG elements)])]; cell: width and height of a picture."""
    wide, high = cell
    side = LEFT
    count = max(len(pictures) for _, pictures in strips)
    width, height = side + wide * count + 24, TOP + len(strips) * (high + 54) + 10
    out = frame(title, subtitle, width, height)
    for i, (name, pictures) in enumerate(strips):
        top = TOP + 26 + i * (high + 54)
        out.append(text(side, top - 8, name, 13, weight="bold"))
        for k, (words, draw) in enumerate(pictures):
            left = side + wide * k
            out.append(f"<svg x='{left}' y='{top}' width='{wide}' height='{high}'><rect width='{wide}' height='{high}' fill='#f6f8fa'/>")
            out += draw(0.0, high - 30.0)
            out.append(f"</svg><rect x='{left}' y='{top}' width='{wide}' height='{high}' fill='none' stroke='#ccd'/>")
            out.append(text(left + wide / 2, top + high + 16, words, 11, "middle", "#555"))
    out.append("</svg>")
    return "\n".join(out)
