# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""deflection.py FOLDER PICTURE.png: deflection of the middle section of the beam against time for the three positions of the block at
5 m/s, unbroken and with failure, as in the thesis's Fig. 6.81; FOLDER holds the runs (build/examples/beam-impact)."""

import sys
from pathlib import Path

from potdem import logs, picture
from potdem.scenes.scene import beside

plot = beside(__file__, "plot")

PANELS = {"-unbroken": "bonds never break", "": "with failure"}


def main(folder, path):
    figure, (axes,) = picture.curves(1, len(PANELS), 3.6, sharey=True)
    for axis, (suffix, title) in zip(axes, PANELS.items()):
        for (position, where), colour in zip(plot.POSITIONS.items(), picture.CURVES):
            table = logs.read_thermo(next((Path(folder) / f"{position}-5{suffix}.np1").glob("log.*")))
            axis.plot(table["Time"], -1e3 * table["v_middle"], color=colour, label=where)
        axis.axhline(0, color="black", linewidth=0.6)
        axis.set(title=title, xlabel="time, s", xlim=(0, None))
    axes[0].set_ylabel("deflection of the middle section, mm")
    axes[0].invert_yaxis()
    axes[0].legend(loc="lower right")
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
