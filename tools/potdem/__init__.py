# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the programs of this project share: formulas, LAMMPS and its files, networks, scenes, comparison, pictures, reports.

Found by PYTHONPATH: tools/python and the project's scripts set it, pytest.ini does for the tests."""
