# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Work-precision diagrams: points of error against seconds, their Pareto front, what to recommend, a picture."""

from dataclasses import dataclass, field

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib import ticker  # noqa: E402


@dataclass
class Point:
    """one setting. series: what is drawn as one line; knob: what varies along it; errors: name -> relative error, infinite
    where the run failed; bars: name -> standard error of that, where it is a mean over seeds; values: what was measured"""

    series: str
    knob: str
    seconds: list
    errors: dict
    peer: bool = False
    bars: dict = field(default_factory=dict)
    values: dict = field(default_factory=dict)

    @property
    def median(self):
        return float(np.median(self.seconds))

    def error(self, name):
        """what is known of it: an error smaller than its standard error counts as that"""
        return max(self.errors[name], self.bars.get(name, 0.0))

    @property
    def worst(self):
        return max(self.error(name) for name in self.errors)

    @property
    def label(self):
        return f"{self.series}, {self.knob}" if self.knob else self.series


def front(points, error):
    """the points that no other beats in both seconds and error, cheapest first; error: function of a point. Less than 1 % is no
    difference in the error"""
    best, chosen = np.inf, []
    for point in sorted(points, key=lambda p: (p.median, error(p))):
        if error(point) < 0.99 * best:
            best = error(point)
            chosen.append(point)
    return chosen


def cheapest(points, limit):
    """the cheapest point whose errors are all below the limit, or None"""
    good = [point for point in points if point.worst < limit]
    return min(good, key=lambda point: point.median) if good else None


def against_peers(points):
    """sentences: what a peer's error, within 5 %, costs with this package"""
    ours, lines = [p for p in points if not p.peer], []
    for series in dict.fromkeys(p.series for p in points if p.peer):
        theirs = [p for p in points if p.series == series and np.isfinite(p.worst)]
        equal = [cheapest(ours, 1.05 * p.worst) for p in theirs]
        ratios = [own.median / p.median for own, p in zip(equal, theirs) if own]
        reached = f"the same error or less in {np.median(ratios):.2g} of its seconds (median)" if ratios else "no setting reaches its error"
        lines.append(f"Beside {series}: for {len(ratios)} of its {len(theirs)} settings POTDEM has {reached}." if ratios else
                     f"Beside {series}: {reached}.")
    return lines


def order(steps, errors):
    """exponent p of error = C step^p by least squares in the logarithms"""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


def percent(value):
    return f"{100 * value:.2g} %" if value < 0.995 else f"{100 * value:.0f} %"


LIMITS = (0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 1e-4, 1e-5)


def recommendations(points):
    """a line for each limit that asks for another setting than the looser one; at last what cannot be had"""
    lines, last = [], None
    for limit in LIMITS:
        best = cheapest(points, limit)
        if best is None:
            lines.append(f"error below {percent(limit)}: no setting that was tried reaches it")
            break
        if last is None or best is not last[0]:
            lines.append(None)
        last = (best, limit)
        lines[-1] = f"error below {percent(limit)}: **{best.label}** ({best.median:.2g} s, error {percent(best.worst)})"
    return lines


def indistinct(points):
    """sentence: the cheapest whose errors with an uncertainty are all within twice that, or none"""
    vague = [p for p in points if p.bars and all(p.errors[name] <= 2 * bar for name, bar in p.bars.items())]
    if not vague:
        return []
    best = min(vague, key=lambda p: p.median)
    return [f"within twice the uncertainty of the reference in all that has a ±: **{best.label}** ({best.median:.2g} s)"]


COLOURS = plt.get_cmap("tab10").colors + plt.get_cmap("Dark2").colors
MARKS = "osD^v<>Ph*Xd"


def _line(axes, points, name, number):
    shown = [p for p in points if np.isfinite(p.errors[name]) and p.error(name) > 0]
    if not shown:
        return
    seconds = np.array([[np.median(p.seconds), min(p.seconds), max(p.seconds)] for p in shown])
    errors = 100 * np.array([p.error(name) for p in shown])
    bars = 100 * np.array([p.bars.get(name, 0.0) for p in shown])
    middle, least, most = seconds.T
    # a bar that reaches zero has no end on a logarithmic axis
    down = np.minimum(bars, 0.9 * errors)
    axes.errorbar(middle, errors, xerr=[middle - least, most - middle], yerr=[down, bars] if bars.any() else None,
                  color=COLOURS[number % len(COLOURS)], marker=MARKS[number % len(MARKS)], markersize=5, linewidth=1,
                  linestyle="--" if shown[0].peer else "-", elinewidth=0.8, label=shown[0].series,
                  markerfacecolor="white" if shown[0].peer else None)


def _plain_ticks(axis):
    """1, 2, 5, 10 on a short logarithmic axis, powers of ten on a long one"""
    low, high = axis.get_view_interval()
    axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5) if high < 200 * low else (1,)))
    axis.set_major_formatter(ticker.FormatStrFormatter("%g"))
    axis.set_minor_formatter(ticker.NullFormatter())


def _panel(axes, points, name, floor, with_front):
    for number, series in enumerate(dict.fromkeys(p.series for p in points)):
        _line(axes, [p for p in points if p.series == series], name, number)
    best = [p for p in front(points, lambda p: p.error(name)) if p.error(name) > 0]
    if not best:
        axes.text(0.5, 0.5, "no error in any setting", ha="center", transform=axes.transAxes)
        return
    places = np.array([[p.median, 100 * p.error(name)] for p in best])
    if with_front:
        axes.plot(*places.T, color="0.75", linewidth=6, zorder=0.8, solid_capstyle="round", label="Pareto front")
    if floor:
        axes.axhline(100 * floor, color="0.4", linestyle=":", linewidth=1, label="uncertainty of the reference")
    axes.set(xscale="log", yscale="log", xlabel="processor seconds")
    for axis in (axes.xaxis, axes.yaxis):
        _plain_ticks(axis)
    axes.grid(True, which="both", color="0.92", linewidth=0.6)
    axes.set_axisbelow(True)


def picture(path, points, labels, floors, with_front=True):
    """a panel for each error; labels: name -> what it is, floors: name -> what the reference itself is worth"""
    rows, columns = 1 + (len(labels) > 3), len(labels) if len(labels) < 4 else 2
    figure = plt.figure(figsize=(4.8 * columns + 3.2, 4.4 * rows), constrained_layout=True)
    grid = figure.add_gridspec(rows, columns + 1, width_ratios=[4.8] * columns + [3.2])
    panels = [figure.add_subplot(grid[divmod(number, columns)]) for number in range(len(labels))]
    key = figure.add_subplot(grid[:, -1])
    for axes, (name, label) in zip(panels, labels.items()):
        _panel(axes, points, name, floors.get(name), with_front)
        axes.set(ylabel=f"error of {label}, %")
    handles = {}
    for axes in panels:
        handles.update({label: handle for handle, label in zip(*axes.get_legend_handles_labels())})
    key.axis("off")
    key.legend(handles.values(), handles.keys(), loc="center left", fontsize=8, frameon=False, borderaxespad=0)
    figure.savefig(path, dpi=110)
    plt.close(figure)
