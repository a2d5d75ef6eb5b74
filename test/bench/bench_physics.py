#!/usr/bin/env python3
"""./twinbus bench physics [CASE...] [--csv F] [--rounds N]: our engines beside their peers, row by row asked and reached.

Cases: free flight arm stand push accuracy map convergence brick tumble piles loops robots patch manifold effort determinism (default: all).  Costs are CPU time of one
thread; ours and the peers take turns, and a ratio is the median over rounds (default 5).  An engine's error is measured
against a converged run: one reference where there is no contact, each engine's own finest run where contact laws differ.
"asked" is for machines with AVX2; peers that are not installed are said and left out.  Exit status 1 if a row falls short.
"""

import math
import statistics
import sys

import stability_map
from physics_lab import Lab, Ours, call, cost_at, error, median_of, ratio, slope

short_of = []
rows = []


def row(case, quantity, asked, reached, good, unit="x", peer="", ours=None, theirs=None):
    mark = "" if good else "   SHORT"
    print(f"{case:12s} {quantity:58s} {asked:>14s} {reached:>16s}{mark}", flush=True)
    rows.append((case, quantity, unit, ours if ours is not None else reached, peer, theirs if theirs is not None else "",
                 reached if unit == "x" else ""))
    if not good:
        short_of.append(quantity)


def at_least(case, quantity, asked, value, **more):
    row(case, quantity, f">= {asked:g}", f"{value:.3g}", value >= asked, **more)


def at_most(case, quantity, asked, value, **more):
    row(case, quantity, f"<= {asked:g}", f"{value:.3g}", value <= asked, **more)


def free(lab, rounds):
    h = 1e-4
    contenders = [(lab.articulated, None)]
    if lab.packaged():
        contenders.append((lab.mujoco(lab.packaged(), "euler"), 2.8))
    if lab.current():
        contenders.append((lab.mujoco(lab.current(), "euler"), 2.4))
    if lab.pinocchio:
        contenders.append((lab.pinocchio, 2.9))
    contenders.append((lab.ode, 38))
    contenders += [(peer, None) for peer in lab.stepped_trees()]
    medians, all_rows = median_of(rounds, *[lambda c=c: c.step_us("flight", h, 0.15) for c, _ in contenders])
    print(f"{'free':12s} us a step: " + ", ".join(f"{c.label} {m:.2f}" for (c, _), m in zip(contenders, medians)))
    for k, (peer, asked) in enumerate(contenders):
        if asked:
            at_least("free", f"free step, 29 joints, times faster than {peer.label}", asked, ratio(all_rows, 0, k),
                     peer=peer.label, ours=medians[0], theirs=medians[k])
        elif k:  # a peer that nothing is asked against
            row("free", f"free step, 29 joints, times faster than {peer.label}", "-", f"{ratio(all_rows, 0, k):.3g}", True,
                peer=peer.label, ours=medians[0], theirs=medians[k])


def curve(engine, scene, steps, reference, repeats=2):
    """[(step, error, cost)] from coarse to fine; the error of a step is the largest of it and all finer ones, so that a lucky
    coarse step does not count."""
    points, worst = [], 0.0
    for h in reversed(steps):
        run = engine.run(scene, h, repeats)
        if run:
            worst = max(worst, error(run, reference))
            points.insert(0, (h, worst, run["cost"]))
    return points


def measured_curves(scene, ours, theirs, rounds):
    """ours, theirs: (engine, steps, what its error is against).  For each round the points (error, cost) of ours together and of
    each of theirs: in turn, as costs change with the machine."""
    found = []
    for number in range(rounds):
        mine, others = [], {}
        for engine, steps, reference in [*ours, *theirs]:
            points = curve(engine, scene, steps, reference, 1)
            if number == 0:
                print(f"{scene:12s} {engine.label}: " + ", ".join(f"{1e3 * h:g} ms {e:.1e} m {c:.2f} ms/s" for h, e, c in points))
            if any(engine is own for own, _, _ in ours):
                mine += [(e, c) for _, e, c in points]
            else:
                others[engine] = [(e, c) for _, e, c in points]
        found.append((mine, others))
    return found


def cheaper(scene, wanted, least, peer, found):
    """The row of how much cheaper ours are at an error [m] than a peer."""
    costs = [(cost_at(mine, wanted)[0], *cost_at(others[peer], wanted)) for mine, others in found]
    note = ", its curve extended" if costs[0][2] else ""
    at_least(scene, f"{scene} at {wanted:g} m, times cheaper than {peer.label}{note}", least,
             statistics.median(theirs / ours for ours, theirs, _ in costs), peer=peer.label,
             ours=statistics.median(ours for ours, _, _ in costs), theirs=statistics.median(theirs for _, theirs, _ in costs))


def smooth(lab, scene, targets, rounds):
    reference = lab.flight[2].run(scene, 2.5e-4, 1)
    check = error(lab.flight[2].run(scene, 5e-4, 1), reference)
    print(f"{scene:12s} reference: RKF78 at 0.25 ms, moves by {check:.1e} m from 0.5 ms")
    ours = [(engine, (5e-2, 2.5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3), reference) for engine in lab.flight]
    ours += [(engine, (5e-1, 1e-1), reference) for engine in lab.parted]
    theirs = [(lab.mujoco(version, "rk4"), (1e-2, 5e-3, 2e-3, 1e-3, 5e-4), reference) for version in lab.mujocos]
    found = measured_curves(scene, ours, theirs, rounds)
    for peer, _, _ in theirs:
        for wanted, asked in targets:
            cheaper(scene, wanted, asked, peer, found)


def stand(lab, rounds):
    h = 1e-3
    contenders = [lab.articulated]
    if lab.current():
        contenders.append(lab.mujoco(lab.current(), "implicitfast"))
    medians, all_rows = median_of(rounds, *[lambda c=c: c.step_us("stand", h, 0.2) for c in contenders])
    print(f"{'stand':12s} us a step: " + ", ".join(f"{c.label} {m:.2f}" for c, m in zip(contenders, medians)))
    if len(contenders) > 1:
        at_least("stand", f"standing step with collision, times faster than {contenders[1].label}", 6,
                 ratio(all_rows, 0, 1), peer=contenders[1].label, ours=medians[0], theirs=medians[1])
    at_least("stand", "real-time factor, standing, 1 ms, with collision", 180, 1e3 / medians[0])
    us, share = lab.articulated.step_us_alone("stand", h, 1.0)
    at_least("stand", f"the same, core alone ({100 * share:.0f} % of the steps)", 180, 1e3 / us if us else 0.0)


def push(lab, rounds):
    for scene in ("push", "push_soft"):  # with the robot's own gains; with legs of 5000 N m/rad
        push_of(lab, scene, rounds)


def push_of(lab, scene, rounds):
    finest = lab.articulated3.run(scene, 1e-4, 1)
    for engine in (lab.articulated2, lab.articulated3):
        at_most("push", f"{scene} at 2 ms, {engine.label}, error [mm]", 0.02, 1e3 * error(engine.run(scene, 2e-3, 1), finest), unit="mm")
    peers = [(lab.ode, (2e-2, 1e-2, 5e-3, 2e-3, 1e-3), 2e-4, {1e-3: 110})]
    if lab.packaged():
        peers.append((lab.mujoco(lab.packaged(), "implicit"), (2e-3, 1e-3, 5e-4, 2e-4, 1e-4), 2e-5, {1e-3: 100}))
    if lab.current():
        peers.append((lab.mujoco(lab.current(), "implicitfast"), (2e-3, 1e-3, 5e-4, 2e-4, 1e-4), 2e-5, {1e-3: 28, 1e-4: 42}))
    limits = {peer: peer.run(scene, limit, 1) for peer, _, limit, _ in peers}
    # Too slow for finer steps: extrapolated from two.
    half = lab.ode.run(scene, 0.5 * peers[0][2], 1)
    limits[lab.ode]["at"] = [2 * a - b for a, b in zip(half["at"], limits[lab.ode]["at"])]
    at_most("push", f"{scene}, limits of both engines apart [mm]", 0.05, 1e3 * error(limits[lab.ode], finest), unit="mm")
    ours = [(engine, (2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4), finest)
            for engine in (lab.articulated, lab.articulated2, lab.articulated3)]
    theirs = [(peer, steps, limits[peer]) for peer, steps, _, _ in peers]
    found = measured_curves(scene, ours, theirs, rounds)
    for peer, _, _, asked in peers:
        for wanted, least in asked.items():
            cheaper(scene, wanted, least, peer, found)


# Of MuJoCo: its explicit methods hold 0.1 mm as soon as they are stable, so what lies near that bound is not to be interpolated.
PEER_STEPS = (5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1.5e-4, 1.2e-4, 1e-4, 6e-5, 5e-5, 4.5e-5, 4e-5, 2e-5)  # [s]


def chosen_by_accuracy(lab, orders, scene, wanted):
    """(engine, step) that the ladder of `accuracy` delivers for an error [m], or None.  orders: engines of order 1, 2, 3."""
    said = call(lab.bin / "accuracy_choice", scene, wanted)
    if not said:
        return None
    words = said[0].split()
    if words[0] != "chosen":
        print(f"{scene}: accuracy chooses none for {1e3 * wanted:g} mm: {' '.join(words[1:])}")
    return (orders[int(words[1]) - 1], float(words[2])) if words[0] == "chosen" else None


def accuracy(lab, rounds):
    """A push of which an error is asked: the order and step that the ladder chooses beside MuJoCo with its best integrator and step."""
    if not lab.current():
        return
    for scene in ("push", "push_soft"):
        orders = (lab.articulated, lab.articulated2, lab.articulated3)
        finest, check = lab.articulated3.run(scene, 5e-5, 1), lab.articulated2.run(scene, 2e-5, 1)
        print(f"{'accuracy':12s} {scene}: the references of orders 2 and 3 are {1e3 * error(check, finest):.1e} mm apart")
        known = {}
        peers = [lab.mujoco(lab.current(), name) for name in ("euler", "rk4", "implicit", "implicitfast")]
        limits = {peer: peer.run(scene, 1e-5, 1) for peer in peers}
        print(f"{'accuracy':12s} {scene}: limits of MuJoCo and ours are " + ", ".join(
            f"{1e3 * error(limit, finest):.2g} mm ({peer.method})" for peer, limit in limits.items() if limit) + " apart")
        found = []
        for number in range(rounds):
            curves = {peer: curve(peer, scene, PEER_STEPS, limits[peer], 1) for peer in peers if limits[peer]}
            if number == 0:
                for peer, points in curves.items():
                    print(f"{'accuracy':12s} {peer.label}: " + ", ".join(f"{1e3 * h:g} ms {1e3 * e:.2g} mm {c:.3g} ms/s" for h, e, c in points))
            costs = {}
            for wanted in (1e-3, 1e-4):
                if wanted not in known:
                    known[wanted] = chosen_by_accuracy(lab, orders, scene, wanted)
                if not known[wanted]:
                    continue
                engine, step = known[wanted]
                theirs = [(cost_at([(e, c) for _, e, c in points], wanted), peer) for peer, points in curves.items()]
                (cost, far), peer = min(((c, p) for c, p in theirs if c[0]), key=lambda each: each[0][0])
                costs[wanted] = engine.run(scene, step, 3)["cost"], cost, far, peer
            found.append(costs)
        for wanted, asked in ((1e-3, 55), (1e-4, 550)):
            if not known.get(wanted):
                row("accuracy", f"{scene} at {1e3 * wanted:g} mm", "chosen", "none", False)
                continue
            engine, step = known[wanted]
            true = error(engine.run(scene, step, 1), finest)
            _, _, far, peer = found[0][wanted]
            what = f"{scene} at {1e3 * wanted:g} mm: {engine.method} at {1e3 * step:.3g} ms"
            at_most("accuracy", f"{what}, true error [mm]", 1e3 * wanted, 1e3 * true, unit="mm")
            at_least("accuracy", f"{what}, times cheaper than {peer.label}{', its curve extended' if far else ''}", asked,
                     statistics.median(costs[wanted][1] / costs[wanted][0] for costs in found), peer=peer.label,
                     ours=statistics.median(costs[wanted][0] for costs in found), theirs=statistics.median(costs[wanted][1] for costs in found))


def stability(lab, _rounds):
    for engine in (lab.articulated, lab.articulated2):
        cells = stability_map.cells(engine.method, 1e-4, "bench physics")
        stable = sum(cell["result"] == "stable" for cell in cells)
        row("map", f"stable stands of 128 (gain x ground x step), {engine.label}", "128", str(stable), stable == 128, unit="")
        for cell in cells:
            if cell["result"] != "stable":
                print("            ", cell)


def convergence(lab, _rounds):
    finest = lab.articulated3.run("push", 2e-5, 1)
    runs = [(h, lab.articulated.run("push", h, 1)) for h in (2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5)]
    errors = [(h, error(r, finest)) for h, r in runs]
    print(f"{'convergence':12s} push, order 1: " + ", ".join(f"{1e3 * h:g} ms {1e3 * e:.4f} mm" for h, e in errors))
    # What follows on the landing is over in 3 ms: steps above 0.5 ms do not resolve it, and the order begins below them.
    at_least("convergence", "order of order 1, push, 0.5 to 0.01 ms", 0.95, slope(errors[2:]), unit="")
    print(f"{'convergence':12s} order from 2 to 0.01 ms: {slope(errors):.3f}")
    row("convergence", "unconverged steps in these", "0", str(sum(r["counters"][2] for _, r in runs)),
        not any(r["counters"][2] for _, r in runs), unit="")
    finest = lab.articulated3.run("push_soft", 2e-5, 1)
    soft = [(h, error(lab.articulated.run("push_soft", h, 1), finest)) for h in (2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5)]
    at_least("convergence", "order of order 1, push, legs of 5000 N m/rad, 2 to 0.01 ms", 0.95, slope(soft), unit="")
    exact = lab.flight[2].run("flight", 5e-4, 1)
    points = [(h, error(lab.articulated2.run("flight", h, 1), exact)) for h in (1e-2, 5e-3, 2e-3, 1e-3, 5e-4)]
    at_least("convergence", "order of order 2, flight, 10 to 0.5 ms", 1.9, slope(points), unit="")


def brick(lab, _rounds):
    for k, most in ((1e5, 0.7), (1e6, 0.4), (1e7, 0.3), (1e8, 0.3)):
        ways = [call(lab.program, "brick", "articulated2", 1e-2, k, degrees)[0].split() for degrees in (0, 45)]
        at_most("brick", f"brick stop at 10 ms, order 2, k {k:g} N/m, off by [%]", most, 100 * abs(float(ways[0][-1])), unit="%")
        at_most("brick", f"the same, 0 against 45 degrees, k {k:g}", 1e-6, abs(float(ways[0][6]) - float(ways[1][6])), unit="m")


def tumble(lab, _rounds):
    def thrown(stiffness, steps, friction):
        runs = [call(lab.program, "tumble", "articulated", h, k, friction)[0].split() for k in stiffness for h in steps]
        total = {name: sum(int(words[words.index(name) + 1]) for words in runs) for name in ("touching", "unconverged", "retried")}
        print(f"{'tumble':12s} friction to {friction}: {total['touching']} steps touch, {total['retried']} solves taken again in parts")
        return total, max(float(words[words.index("excess") + 1]) for words in runs)

    total, excess = thrown((1e5, 1e6, 1e7), (1e-2, 5e-3, 1e-3), 0.8)
    row("tumble", "unconverged steps, friction 0.3 to 0.8, k to 1e7, to 10 ms", "0", str(total["unconverged"]), total["unconverged"] == 0, unit="")
    at_most("tumble", "forces beyond the friction cone, relative", 1e-10, excess, unit="")
    total, excess = thrown((1e5, 1e6, 1e7, 1e8), (2e-2, 1e-2, 5e-3, 1e-3), 1.5)
    at_most("tumble", "unconverged steps, friction 0.3 to 1.5, k to 1e8 [%]", 0.01, 100 * total["unconverged"] / total["touching"], unit="%")
    at_most("tumble", "forces beyond the friction cone there, relative", 1e-10, excess, unit="")


def piles(lab, rounds):
    def cost(engine, shape, count):
        lines = call(lab.program, "boxes", shape, engine.method, 1e-3, count, 0.3)
        return float(lines[0].split()[6]) if lines else math.nan

    # Asked on AVX2: 1.4 times what AVX-512 is asked for.
    limits = {("apart", 1000): 2100, ("stack", 20): 280, ("stack", 100): 1400}
    for shape, counts in (("apart", (1, 10, 100, 1000)), ("stack", (2, 5, 10, 20, 50, 100))):
        for count in counts:
            (ours, theirs), every = median_of(1 if count > 20 else rounds, lambda: cost(lab.articulated, shape, count),
                                              lambda: cost(lab.ode, shape, count))
            name = f"{count} boxes {'apart' if shape == 'apart' else 'in a stack'}"
            if (shape, count) in limits:
                at_most("piles", f"{name}, 1 ms, us a step", limits[shape, count], ours, unit="us")
            print(f"{'piles':12s} {name}, us a step: {lab.articulated.label} {ours:.1f}, {lab.ode.label} {theirs:.1f}")
            at_least("piles", f"{name}, times faster than {lab.ode.label}", 1, ratio(every, 0, 1),
                     peer=lab.ode.label, ours=ours, theirs=theirs)


# Of the seven bodies at 0.03 s (Hairer and Wanner 1996, VII.7; test set for initial value problem solvers): beta, Theta,
# gamma, delta, Phi, epsilon, Omega.
ANDREWS = (15.81077119629904, -15.75637105984298, 0.04082224013073101, 0.5244099658805304, -0.5347301163226948,
           1.048080741042263, 0.5347301163226948)


def loops(lab, _rounds):
    def mechanism(name, method, h, *more):
        lines = call(lab.program.parent / "physics_loops", name, method, h, *more)
        words = lines[0].split() if lines else []
        if "drift" not in words:
            return {"drift": math.inf, "gap": math.inf, "speed": math.inf, "cost": math.inf, "unconverged": math.inf,
                    "at": [math.inf] * 3, "q": [math.inf] * 7}
        found = {name: float(words[words.index(name) + 1]) for name in ("drift", "gap", "speed", "cost", "unconverged")}
        found["at"] = [float(w) for w in words[words.index("at") + 1:words.index("q")]]
        found["q"] = [float(w) for w in words[words.index("q") + 1:words.index("speed")]]
        return found

    def apart(a, b):
        return max(abs(x - y) for x, y in zip(a, b))

    unconverged = 0
    for name in ("four_bar", "n_four_bar40", "bricard"):
        run = mechanism(name, 3, 1e-3, 10)
        unconverged += run["unconverged"]
        print(f"{'loops':12s} {name}, 10 s, order 3, 1 ms: ends apart {run['gap']:.1e} m, {run['cost']:.0f} ms/s")
        at_most("loops", f"{name}, energy drift in 10 s, order 3, 1 ms [J]", 0.1, run["drift"], unit="J")
    for name in ("four_bar", "bricard"):
        fine = mechanism(name, 3, 2.5e-4, 1)["at"]
        at_most("loops", f"{name}, point after 1 s at 1 ms against 0.25 ms [mm]", 1, 1e3 * apart(mechanism(name, 3, 1e-3, 1)["at"], fine), unit="mm")
        # Of order 1 and slow: its limit is that of three steps.
        runs = zip(*(mechanism(name, "ode", h, 1)["at"] for h in (2e-4, 1e-4, 5e-5)))
        limit = [(a - 6 * b + 8 * c) / 3 for a, b, c in runs]
        at_most("loops", f"{name}, the same, limit of ODE against ours [mm]", 1, 1e3 * apart(limit, fine), unit="mm")
    seven = mechanism("andrews", 3, 2e-5)
    unconverged += seven["unconverged"]
    at_most("loops", "Andrews, angles at the end against the reference [rad]", 1e-3, apart(seven["q"], ANDREWS), unit="rad")
    tied = [(h, k, mechanism("tied", order, h, 1, k)) for h in (1e-4, 1e-3, 1e-2) for k in (1e6, 1e8) for order in (1, 2)]
    stable = sum(run["speed"] < 0.2 and run["gap"] < 1e-3 for _, _, run in tied)
    unconverged += sum(run["unconverged"] for _, _, run in tied)
    row("loops", "tied hands stable, 0.1 to 10 ms, k 1e6 and 1e8, order 1 and 2", str(len(tied)), str(stable), stable == len(tied), unit="")
    row("loops", "unconverged steps in these", "0", f"{unconverged:g}", unconverged == 0, unit="")


def patch(lab, rounds):
    """What the area under the soles costs beside points at their corners, on the plane and on tiles of 0.3 m."""
    for ground, asked in (("", 1.5), ("+tiles", 2.5)):
        for order in ("", "2"):
            area, corners = (Ours(lab.program, f"articulated{order}{law}{ground}", "") for law in ("+patch", ""))
            for scene, h in (("stand", 2e-3), ("push", 1e-3)):
                _, all_rows = median_of(rounds, *[lambda e=e: e.run(scene, h, 3)["cost"] for e in (area, corners)])
                at_most("patch", f"{scene}, order {order or 1}, {'tiles' if ground else 'plane'}: cost over that of corners there", asked,
                        ratio(all_rows, 1, 0))


def manifold(lab, rounds):
    runs = [call(lab.program.parent / "manifold_bench", 0.2) for _ in range(rounds)]
    if not all(runs):
        return at_most("manifold", "manifold_bench fails", 0, 1, unit="")
    for name in ("cube_12", "cube_768", "cube_768_turned", "sphere_3072"):
        ours, peer = ([dict(zip(words[2::2], map(float, words[3::2]))) for run in runs for words in map(str.split, run)
                       if words[:2] == [name, library]] for library in ("twinbus", "fcl"))
        first, fcl = ours[0], peer[0]
        print(f"{'manifold':12s} {name}, FCL: {fcl['points']:.0f} points at {fcl['different']:.0f} places, normals within "
              f"{fcl['normal_deg']:.2g} degrees, depth off by {fcl['depth_error_percent']:.1f} %")
        at_most("manifold", f"{name}, points", 8, first["points"], unit="")
        at_most("manifold", f"{name}, points found twice", 0, first["points"] - first["different"], unit="")
        at_most("manifold", f"{name}, normals [degrees]", 2 if "sphere" in name else 1, first["normal_deg"], unit="degrees")
        at_most("manifold", f"{name}, depth [%]", 2, first["depth_error_percent"], unit="%")
        times = statistics.median([b["us"] / a["us"] for a, b in zip(ours, peer)])
        at_least("manifold", f"{name}, {statistics.median(a['us'] for a in ours):.3g} us against FCL", 3, times, peer="FCL")


def robots(lab, _rounds):
    unconverged = 0
    for scene, what in (("hands", "two robots tied hand to hand"), ("bump", "a robot walked into another's back"),
                        ("fold", "a robot's hand pressed against its own body")):
        stable, runs = 0, [(order, h, k) for order in (1, 2) for h in (1e-4, 1e-3, 1e-2) for k in (1e6, 1e8)]
        for order, h, k in runs:
            lines = call(lab.program.parent / "physics_robots", scene, order, h, k)
            words = lines[0].split() if lines else []
            found = {name: float(words[words.index(name) + 1]) for name in ("fastest", "tilt", "gap", "touched", "unconverged") if name in words}
            # A bump that nobody feels would be stable too.
            met = found and (scene == "hands" or found["touched"] > 0)
            if met and found["fastest"] < 0.2 and found["tilt"] < 10 and found["gap"] < 1e-3:
                stable += 1
            else:
                print(f"{'robots':12s} {scene}, order {order}, {1e3 * h:g} ms, k {k:g}: {' '.join(words) or 'failed'}")
            unconverged += found.get("unconverged", math.inf)
        row("robots", f"{what}: stable, 0.1 to 10 ms, k 1e6 and 1e8", str(len(runs)), str(stable), stable == len(runs), unit="")
    row("robots", "unconverged steps in these", "0", f"{unconverged:g}", unconverged == 0, unit="")


def effort(lab, _rounds):
    for h in (1e-4, 1e-3, 1e-2):
        words = call(lab.program, "effort", "articulated", h)[0].split()
        at_most("effort", f"effort limits exceeded at {1e3 * h:g} ms, relative", 1e-9, float(words[4]), unit="")
        at_most("effort", f"stops passed at {1e3 * h:g} ms [rad]", 1e-9, float(words[6]), unit="rad")


def determinism(lab, _rounds):
    for method in ("articulated", "articulated2"):
        hashes = {call(lab.program, "hash", "throw", method, 2e-3)[0].split()[-1] for _ in range(10)}
        row("determinism", f"different hashes of 10 throws, {method}", "1", str(len(hashes)), len(hashes) == 1, unit="")
        # In the middle another world goes on.
        for scene, h, where, share in (("throw", 2e-3, "in the air", 0.1), ("stand", 1e-3, "in contact", 0.5)):
            hashes = {call(lab.program, "hash", scene, method, h, at)[0].split()[-1] for at in (1, share)}
            row("determinism", f"different hashes, resumed {where} or not, {method}", "1", str(len(hashes)), len(hashes) == 1, unit="")


CASES = {"free": free, "flight": lambda lab, rounds: smooth(lab, "flight", ((1e-8, 42),), rounds),
         "arm": lambda lab, rounds: smooth(lab, "arm", ((1e-3, 3.5), (1e-8, 14)), rounds), "stand": stand, "push": push, "accuracy": accuracy, "map": stability,
         "convergence": convergence, "brick": brick, "tumble": tumble,
         "piles": piles, "loops": loops, "robots": robots, "patch": patch, "manifold": manifold, "effort": effort, "determinism": determinism}


def main(words):
    if "--help" in words or "-h" in words:
        print(__doc__.strip())
        return 0
    csv, rounds, names = None, 5, []
    while words:
        word = words.pop(0)
        if word == "--csv" and words:
            csv = words.pop(0)
        elif word == "--rounds" and words and words[0].isdigit() and int(words[0]) > 0:
            rounds = int(words.pop(0))
        elif word in CASES:
            names.append(word)
        else:
            print(f"bench physics: no case or option '{word}'; there are {' '.join(CASES)} --csv --rounds", file=sys.stderr)
            return 2
    lab = Lab("bench physics")
    print(f"{'case':12s} {'quantity':58s} {'asked':>14s} {'reached':>16s}")
    for name in names or CASES:
        CASES[name](lab, rounds)
    if csv:
        with open(csv, "a") as file:
            for case, quantity, unit, ours, peer, theirs, times in rows:
                file.write(f'physics,{case},"{quantity}",{unit},{ours},,,,{peer},{theirs},{times}\n')
    print(f"{len(rows)} rows, {len(short_of)} short")
    return 1 if short_of else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
