# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Scenes: their runs, comparison with the reference logs, pictures, the thesis's claims."""
