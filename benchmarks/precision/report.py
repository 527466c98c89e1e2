#!/usr/bin/env python3
"""report.py POINTS PAGE FIGURES TEXT [NOTE...]: tables and figures of what a run of benchmarks/precision/run measured.

POINTS has a line for each point: problem, contender, setting, seconds, error, separated by tabs. TEXT is the page with
places for the tables; notes stand behind the machine. Only the standard library and gnuplot are used."""

import collections
import math
import subprocess
import sys

ERRORS = [1e-3, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13]
JUDGED = [1e-4, 1e-8, 1e-12]
SERIES_FROM = 1.0001e-9  # `auto` takes series from this tolerance on
BY_HAND = ("expert, dop853", "expert, rkf78", "Boost.Odeint, rkf78")


def read(path):
    """{problem: {contender: [(setting, seconds, error)]}}, in order of appearance."""
    points = collections.OrderedDict()
    for line in open(path):
        problem, contender, *numbers = line.rstrip("\n").split("\t")
        setting, seconds, error = map(float, numbers)
        if math.isfinite(error) and error > 0:
            of_problem = points.setdefault(problem, collections.OrderedDict())
            of_problem.setdefault(contender, []).append((setting, seconds, error))
    for of_problem in points.values():
        if "mbcc, taylor" in of_problem and "mbcc, dop853" in of_problem:
            auto = [p for p in of_problem["mbcc, dop853"] if p[0] > SERIES_FROM]
            of_problem["mbcc, auto"] = auto + [p for p in of_problem["mbcc, taylor"] if p[0] <= SERIES_FROM]
            of_problem.move_to_end("mbcc, auto", last=False)
    return points


def front(points):
    """(error, seconds) by falling error, without points that cost more and are not better."""
    best = []
    for error, seconds in sorted((p[2], p[1]) for p in points):
        if not best or seconds < best[-1][1]:
            best.append((error, seconds))
    return best[::-1]


def time_at(curve, error):
    """Seconds at an error, on a line in logarithms between measured points; None where it is not reached. Where even
    the coarsest point is better, that point's."""
    for i, (reached, seconds) in enumerate(curve):
        if reached > error:
            continue
        if i == 0:
            return seconds
        above, before = curve[i - 1]
        part = math.log(above / error) / math.log(above / reached)
        return before * (seconds / before) ** part
    return None


def milliseconds(seconds):
    return "–" if seconds is None else f"{1e3 * seconds:.3g}"


def fastest(curves, error, belongs):
    """The name and the time of the fastest contender of a group at an error."""
    times = [(time_at(curve, error), name) for name, curve in curves.items() if belongs(name)]
    return min(((t, name) for t, name in times if t is not None), default=(None, None))


def ratio(a, b):
    if a is None or b is None:
        return "–"
    return f"{a / b:.2f}" if a < 10 * b else f"{a / b:.0f}"


def is_mbcc(name):
    return name.startswith("mbcc") and name != "mbcc, auto"


def is_expert(name):
    return name.startswith("expert")


def is_rival(name):
    return not name.startswith("mbcc") and not is_expert(name) and not name.startswith("Boost")


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def verdicts(curves_of):
    """For the problems that somebody has written by hand."""
    rows = []
    for problem, curves in curves_of.items():
        if not any(is_expert(name) for name in curves):
            continue
        for error in JUDGED:
            own, name = fastest(curves, error, is_mbcc)
            hand, by = fastest(curves, error, is_expert)
            rival, whose = fastest(curves, error, is_rival)
            rows.append([problem, f"{error:.0e}",
                         milliseconds(own) + (f" ({name})".replace("mbcc, ", "") if name else ""),
                         ratio(own, hand) + (f" ({by})".replace("expert, ", "") if by else ""),
                         ratio(rival, own) + (f" ({whose})" if whose else "")])
    return table(["problem", "error", "mbcc's best, ms", "that, over the best expert's", "the nearest other, over mbcc"], rows)


def ratios_to_runge_kutta(curves_of):
    rows = []
    for problem, curves in curves_of.items():
        if not all(name in curves for name in BY_HAND):
            continue
        for method in ("mbcc, taylor", "mbcc, dop853", "mbcc, auto"):
            cells = []
            for error in ERRORS:
                hand, _ = fastest(curves, error, lambda name: name in BY_HAND)
                cells.append(ratio(hand, time_at(curves[method], error)))
            rows.append([problem, method.replace("mbcc, ", "")] + cells)
    return table(["problem", "method"] + [f"{e:.0e}" for e in ERRORS], rows)


def all_times(curves_of):
    parts = []
    for problem, curves in curves_of.items():
        rows = []
        for name, curve in curves.items():
            if curve:
                end = f"{curve[-1][0]:.1e} ({milliseconds(curve[-1][1])})"
                rows.append([name] + [milliseconds(time_at(curve, e)) for e in ERRORS] + [end])
        parts.append(f"### {problem}\n\n![time against error of {problem}](precision/{problem}.svg)\n\n"
                     + table(["ms at an error of"] + [f"{e:.0e}" for e in ERRORS] + ["least error (ms)"], rows))
    return "\n\n".join(parts)


def draw(problem, curves, directory):
    names = [name for name, curve in curves.items() if curve and name != "mbcc, auto"]
    script = ["set terminal svg size 720,460 font 'sans,11' background 'white'",
              f"set output '{directory}/{problem}.svg'", "set logscale xy", "set format '10^{%T}'", "set grid",
              "set xrange [1e-15:1]", "set xlabel 'error at the end'", "set ylabel 'seconds'",
              "set key outside right", f"set title '{problem}' noenhanced"]
    plots, data = [], []
    for i, name in enumerate(names):
        width = 2.5 if name.startswith("mbcc") else 1
        plots.append(f"'-' with linespoints lw {width} pt {i % 15 + 1} ps 0.4 lc {i + 1} title '{name}' noenhanced")
        data += [f"{error:.3g} {seconds:.4g}" for error, seconds in curves[name]] + ["e"]
    subprocess.run(["gnuplot"], input="\n".join(script + ["plot " + ", ".join(plots)] + data) + "\n", text=True, check=True)


def main():
    points_path, page, figures, text_path, *notes = sys.argv[1:]
    points = read(points_path)
    curves_of = {problem: {name: front(of) for name, of in contenders.items()} for problem, contenders in points.items()}
    for problem, curves in curves_of.items():
        draw(problem, curves, figures)
    text = open(text_path).read()
    for place, value in (("@machine@", "\n".join("* " + note for note in notes)), ("@verdicts@", verdicts(curves_of)),
                         ("@ratios@", ratios_to_runge_kutta(curves_of)), ("@times@", all_times(curves_of))):
        text = text.replace(place, value)
    with open(page, "w") as file:
        file.write(text)


main()
