"""report.html of a campaign: rates with their intervals, plots, the worst runs, each with the way into the viewer.

`report OUT --serve` shows the page on 127.0.0.1 and opens a run in the log viewer when its link is followed.
"""

import html
import http.server
import pathlib
import re
import secrets
import subprocess
import sys
import threading

from command import NAME, Parser
from errors import CampaignError
from rates import wilson
from run_task import program_words, whole_lines
from store import number_or_text, sort_key

STATUSES = ("passed", "failed", "timeout", "crashed", "refused")
LINES = ("#1f6fb4", "#e08a1e", "#2a9d5c", "#8a4fbf", "#d1495b", "#0f8b8d")  # of scenes
MOST_WORST = 40
MOST_DOTS = 4000
BINS = 8
WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT = 460, 300, 56, 48, 34, 16

HEAD = """<!doctype html><html lang="en"><meta charset="utf-8"><title>{title}</title><style>
body {{font: 15px/1.45 'DejaVu Sans', Helvetica, Arial, sans-serif; margin: 24px auto; padding: 0 24px; max-width: 1280px; color: #222}}
table {{border-collapse: collapse; margin: 12px 0}} td, th {{padding: 3px 10px; border-bottom: 1px solid #ddd; text-align: left}}
th {{background: #f4f4f4}} td.n {{text-align: right}} td.what {{min-width: 240px}} td code {{overflow-wrap: anywhere}} code {{background: #f4f4f4; padding: 1px 4px}} h2 {{margin-top: 32px}}
.plots {{display: flex; flex-wrap: wrap; gap: 16px}} svg {{border: 1px solid #ddd}} a.replay {{background: #1f6fb4; color: white;
padding: 2px 8px; border-radius: 4px; text-decoration: none}} .hint {{color: #555}}</style><h1>{title}</h1>
"""


def counts(results):
    found = dict.fromkeys(STATUSES, 0)
    for result in results:
        found[result["status"]] += 1
    return found


def esc(text):
    return html.escape(str(text))


def svg_text(x, y, words, anchor="middle", size=12, turn=""):
    return f"<text x='{x:.1f}' y='{y:.1f}' font-size='{size}' text-anchor='{anchor}' {turn}>{esc(words)}</text>"


def frame(title, x_name, y_name, x_ticks, y_ticks, px, py):
    out = [f"<svg xmlns='http://www.w3.org/2000/svg' width='{WIDTH}' height='{HEIGHT}' font-family='DejaVu Sans, sans-serif' fill='#222'>",
           svg_text(WIDTH / 2, 20, title, size=13)]
    for value in y_ticks:
        out.append(f"<line x1='{LEFT}' x2='{WIDTH - RIGHT}' y1='{py(value):.1f}' y2='{py(value):.1f}' stroke='#e4e4e4'/>")
        out.append(svg_text(LEFT - 6, py(value) + 4, f"{value:.3g}", "end", 11))
    for value, words in x_ticks:
        out.append(svg_text(px(value), HEIGHT - BOTTOM + 16, words, size=11))
    out.append(f"<rect x='{LEFT}' y='{TOP}' width='{WIDTH - LEFT - RIGHT}' height='{HEIGHT - TOP - BOTTOM}' fill='none' stroke='#444'/>")
    out.append(svg_text(WIDTH / 2, HEIGHT - 10, x_name))
    out.append(svg_text(16, HEIGHT / 2, y_name, turn=f"transform='rotate(-90 16 {HEIGHT / 2})'"))
    return out


def scale(low, high, begin, end):
    span = (high - low) or 1.0
    return lambda value: begin + (value - low) / span * (end - begin)


def apart(ticks, px, width=9.0):
    """Those ticks whose words do not overlap."""
    kept, end = [], -1e9
    for x, words in sorted(ticks, key=lambda tick: px(tick[0])):
        half = 0.5 * 6.5 * len(words)
        if px(x) - half > end + width:
            kept.append((x, words))
            end = px(x) + half
    return kept


def rate_groups(numbers, values):
    """([(x, [whether a run did not pass])], ticks) at the values of a setting, or in bins where there are many."""
    if len(values) > 20:
        low, high = values[0][1], values[-1][1]
        width = (high - low) / BINS
        groups = [(low + width * (i + 0.5), [bad for value, bad in numbers if i == min(BINS - 1, int((value[1] - low) / width))])
                  for i in range(BINS)]
        return groups, [(low + (high - low) * i / 4, f"{low + (high - low) * i / 4:.3g}") for i in range(5)]
    texts = any(kind for kind, _, _ in values)
    groups = [(i if texts else value[1], [bad for other, bad in numbers if other == value]) for i, value in enumerate(values)]
    return groups, [(x, (values[i][2] or f"{values[i][1]:.4g}")[:12]) for i, (x, _) in enumerate(groups)]


def rate_plot(key, pairs):
    """Share that did not pass, against a setting, a line per scene."""
    by_scene = {}
    for task, result in pairs:
        if key in task["varied"]:
            by_scene.setdefault(task["scene"], []).append((number_or_text(task["varied"][key]), result["status"] != "passed"))
    if len(by_scene) > len(LINES):
        by_scene = {"all scenes": [each for numbers in by_scene.values() for each in numbers]}
    values = sorted({value for numbers in by_scene.values() for value, _ in numbers})
    if len(values) < 2 or any(kind for kind, _, _ in values) and len(values) > 20:
        return ""
    lines = {scene: rate_groups(numbers, values) for scene, numbers in sorted(by_scene.items())}
    groups, ticks = next(iter(lines.values()))
    xs = [x for x, _ in groups]
    margin = 0.06 * (xs[-1] - xs[0])
    px, py = scale(xs[0] - margin, xs[-1] + margin, LEFT, WIDTH - RIGHT), scale(0.0, 1.0, HEIGHT - BOTTOM, TOP)
    out = frame(f"did not pass, with 95 % interval, by {key}", key, "rate", apart(ticks, px), (0, 0.25, 0.5, 0.75, 1), px, py)
    for number, (scene, (groups, _)) in enumerate(lines.items()):
        color, way = LINES[number % len(LINES)], []
        shift = 3.0 * (number - 0.5 * (len(lines) - 1))  # intervals side by side
        for x, bads in groups:
            if not bads:
                continue
            at, rate, (least, most) = px(x) + shift, sum(bads) / len(bads), wilson(sum(bads), len(bads))
            way.append(f"{at:.1f},{py(rate):.1f}")
            out.append(f"<line x1='{at:.1f}' x2='{at:.1f}' y1='{py(least):.1f}' y2='{py(most):.1f}' stroke='{color}' stroke-width='2'/>")
            out.append(f"<circle cx='{at:.1f}' cy='{py(rate):.1f}' r='4' fill='{color}'><title>{esc(scene)}: {sum(bads)} of {len(bads)}</title></circle>")
        out.append(f"<polyline points='{' '.join(way)}' fill='none' stroke='{color}' stroke-opacity='0.5'/>")
        if len(lines) > 1:
            out.append(f"<text x='{WIDTH - RIGHT - 8}' y='{TOP + 56 + 14 * number}' font-size='11' text-anchor='end' fill='{color}'>{esc(scene)}</text>")
    return "".join(out + ["</svg>"])


def map_plot(x_key, y_key, pairs):
    """Runs as dots over two settings that are numbers: green where all passed, red where none did."""
    places = {}
    for task, result in pairs:
        try:
            places.setdefault((float(task["varied"][x_key]), float(task["varied"][y_key])), []).append(result["status"] != "passed")
        except (KeyError, ValueError):
            continue
    dots = sorted(places.items())
    if len({d[0][0] for d in dots}) < 2 or len({d[0][1] for d in dots}) < 2:
        return ""
    dots = dots[::max(1, len(dots) // MOST_DOTS)]
    spans = [(min(d[0][i] for d in dots), max(d[0][i] for d in dots)) for i in (0, 1)]
    px, py = scale(*spans[0], LEFT + 8, WIDTH - RIGHT - 8), scale(*spans[1], HEIGHT - BOTTOM - 8, TOP + 8)
    ticks = [[low + (high - low) * i / 4 for i in range(5)] for low, high in spans]
    out = frame("runs: green all passed, red none did", x_key, y_key, [(x, f"{x:.3g}") for x in ticks[0]], ticks[1], px, py)
    for (x, y), bads in dots:
        share = sum(bads) / len(bads)
        color = "#" + "".join(f"{round(g + share * (r - g)):02x}" for g, r in ((0x2a, 0xd1), (0x9d, 0x49), (0x5c, 0x5b)))
        out.append(f"<circle cx='{px(x):.1f}' cy='{py(y):.1f}' r='{3 if len(dots) > 400 else 5}' fill='{color}' fill-opacity='0.85'>"
                   f"<title>{sum(bads)} of {len(bads)} did not pass</title></circle>")
    return "".join(out + ["</svg>"])


def badness(pair):
    """What is looked at first: crashes, limits, falls, then the largest tilt."""
    task, result = pair
    figures = result["figures"]
    order = {"crashed": 0, "timeout": 1, "failed": 2, "refused": 3, "passed": 4}[result["status"]]
    return (order, not figures.get("fell", False), -(figures.get("max_tilt_deg") or 0.0), sort_key(task))


def page(out, pairs, title):
    parts = [HEAD.format(title=esc(title))]
    total = counts(result for _, result in pairs)
    parts.append("<p>" + ", ".join(f"{number} {name}" for name, number in total.items() if number or name == "passed") + "</p>")
    parts.append("<table><tr><th>scene</th><th>robot</th><th>controller</th><th>runs</th><th>passed</th><th>fell</th>"
                 "<th>did not pass</th><th>95 % interval</th></tr>")
    groups = {}
    for task, result in pairs:
        groups.setdefault((task["scene"], task["robot"], task["controller"]), []).append(result)
    for key, results in sorted(groups.items()):
        bad = sum(result["status"] != "passed" for result in results)
        fell = sum(bool(result["figures"].get("fell")) for result in results)
        least, most = wilson(bad, len(results))
        parts.append("<tr>" + "".join(f"<td>{esc(word)}</td>" for word in key) + f"<td class=n>{len(results)}</td><td class=n>"
                     f"{len(results) - bad}</td><td class=n>{fell}</td><td class=n>{100 * bad / len(results):.2f} %</td>"
                     f"<td class=n>{100 * least:.2f} .. {100 * most:.2f} %</td></tr>")
    parts.append("</table>")
    keys = sorted({key for task, _ in pairs for key in task["varied"]})
    plots = [rate_plot(key, pairs) for key in keys]
    plots += [map_plot(a, b, pairs) for i, a in enumerate(keys[:4]) for b in keys[i + 1:4]]
    if any(plots):
        parts.append("<h2>By setting</h2><div class=plots>" + "".join(plots) + "</div>")
    worst = [pair for pair in sorted(pairs, key=badness) if pair[1]["status"] != "passed"]
    parts.append(f"<h2>Worst runs</h2><p class=hint>{min(len(worst), MOST_WORST)} of {len(worst)} that did not pass. The links work in the page that "
                 f"<code>{NAME} report {esc(out)} --serve</code> shows; the command opens the same.</p>")
    if worst:
        parts.append("<table><tr><th></th><th>id</th><th>scene</th><th>settings</th><th>seed</th><th>what</th><th>command</th></tr>")
    for task, result in worst[:MOST_WORST]:
        settings = ", ".join(f"{key}={value}" for key, value in task["varied"].items())
        link, command = f"<a class=replay href='replay/{task['id']}'>replay</a>", f"{NAME} view {out} {task['id']}"
        if "arguments" in task:  # no run of a scene: there is nothing to see
            link, command = "", " ".join(program_words(task))
        parts.append(f"<tr><td>{link}</td><td>{task['id']}</td><td>{esc(task['scene'])}</td>"
                     f"<td>{esc(settings)}</td><td class=n>{task['seed']}</td><td class=what>{esc('; '.join(result['failures']) or result['status'])}</td>"
                     f"<td><code>{esc(command)}</code></td></tr>")
    parts.append("</table>" if worst else "<p>None.</p>")
    return "\n".join(parts) + "</html>\n"


def write(out, pairs, campaign=None):
    from store import replacing
    title = f"Campaign {pathlib.Path(campaign.file).stem if campaign else pathlib.Path(out).name}"
    with replacing(pathlib.Path(out) / "report.html") as file:
        file.write(page(out, pairs, title))


def read(out):
    """[(task, result)] of a folder, and its tasks by id."""
    out = pathlib.Path(out)
    tasks = {task["id"]: task for task in whole_lines(out / "tasks.jsonl")}
    if not tasks:
        raise CampaignError(f"{out}: holds no campaign (no tasks.jsonl); name the --out of one")
    results = {}
    for file in sorted((out / "done").glob("*.jsonl")):
        for result in whole_lines(file):
            if not result.get("again"):
                results.setdefault(result["id"], result)
    return sorted(((task, results[name]) for name, task in tasks.items() if name in results), key=lambda p: sort_key(p[0])), tasks


def log_of(out, tasks, name):
    """The log of a run, recorded now where there is none.  Throws CampaignError."""
    import run_task
    if name not in tasks:
        raise CampaignError(f"{out}: has no run '{name}'; ids are in results.csv")
    if "arguments" in tasks[name]:
        raise CampaignError(f"{name}: is no run of a scene but of {tasks[name]['program']}; its command is in report.html")
    log = pathlib.Path(out) / "logs" / f"{name}.log"
    if not log.exists():
        runner = run_task.Runner()
        try:
            sentence = runner.refusal(tasks[name])
            if sentence:
                raise CampaignError(sentence)
            runner.keep_log(tasks[name], log.parent, sys.maxsize)
        finally:
            runner.close()
    if not log.exists():
        raise CampaignError(f"{name}: the run wrote no log; see its sentence in results.csv")
    return log


def viewer(log, task, *options):
    """The log viewer on that log: (process, its address)."""
    program = pathlib.Path(task["program"]).with_name("twinbus_log_viewer")
    if not program.exists():
        raise CampaignError(f"{program} is not built; run: {NAME} view OUT ID, which builds it")
    process = subprocess.Popen([str(program), str(log), "--robot", task.get("robot_path") or task["robot"], *options],
                               stdout=subprocess.PIPE, text=True)
    for line in process.stdout:
        print(line, end="", flush=True)
        found = re.search(r"https?://\S+", line)
        if found:
            threading.Thread(target=process.stdout.read, daemon=True).start()
            return process, found.group(0)
    raise CampaignError("the log viewer ended without an address")


def view_command(words):
    parser = Parser("view")
    parser.add_argument("out")
    parser.add_argument("id")
    parser.add_argument("--no-open", action="store_true")
    given = parser.parse_args(words)
    _, tasks = read(given.out)
    process, _ = viewer(log_of(given.out, tasks, given.id), tasks[given.id], *(["--no-open"] if given.no_open else []))
    try:
        return process.wait()
    finally:
        process.terminate()


class Pages(http.server.BaseHTTPRequestHandler):
    """The report and, by its links, replays.  Only this machine, only with the token of the address."""

    def do_GET(self):
        server = self.server
        token, _, rest = self.path.lstrip("/").partition("/")
        if not secrets.compare_digest(token.encode(), server.token.encode()):
            return self.answer(403, "the address that the program printed has the token")
        if rest in ("", "report.html"):
            return self.answer(200, page(server.out, *server.shown))
        match = re.fullmatch(r"replay/([0-9a-f]{16})", rest)
        if not match:
            return self.answer(404, "there is no such page")
        try:
            with server.one:
                if match[1] not in server.viewers or server.viewers[match[1]][0].poll() is not None:
                    server.viewers[match[1]] = viewer(log_of(server.out, server.tasks, match[1]), server.tasks[match[1]], "--no-open", "--port", "8051")
        except CampaignError as error:
            return self.answer(500, esc(error))
        self.send_response(302)
        self.send_header("Location", server.viewers[match[1]][1])
        self.end_headers()
        return None

    def answer(self, status, text):
        data = text.encode()
        self.send_response(status)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, *_):
        pass


def report_command(words):
    parser = Parser("report")
    parser.add_argument("out")
    parser.add_argument("--serve", action="store_true")
    parser.add_argument("--port", type=int, default=8060)
    given = parser.parse_args(words)
    pairs, tasks = read(given.out)
    write(given.out, pairs)
    print(pathlib.Path(given.out) / "report.html")
    if not given.serve:
        return 0
    try:
        server = http.server.ThreadingHTTPServer(("127.0.0.1", given.port), Pages)
    except OSError:
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Pages)
    server.out, server.tasks, server.viewers, server.one = given.out, tasks, {}, threading.Lock()
    server.shown, server.token = (pairs, f"Campaign {pathlib.Path(given.out).name}"), secrets.token_hex(8)
    print(f"http://127.0.0.1:{server.server_address[1]}/{server.token}/   (Ctrl-C ends it)", flush=True)
    try:
        server.serve_forever()
    except (KeyboardInterrupt, SystemExit):
        pass
    for process, _ in server.viewers.values():
        process.terminate()
    return 0
