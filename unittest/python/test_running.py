# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""How LAMMPS is run."""

from potdem import running


def test_single_ranks_share_no_folder_of_open_mpi(lmp, tmp_path):
    """such a folder is removed by the first that ends, and the next one does not start: there is to be none, so none is missed"""
    nowhere = {"OMPI_MCA_orte_tmpdir_base": str(tmp_path / "in" / "a file")}
    (tmp_path / "in").write_text("no folder can be made below a file\n", encoding="utf-8")
    assert running.run("units si\n", {}, tmp_path / "alone", lmp=lmp, more=nowhere).ended_well
    assert not running.run("units si\n", {}, tmp_path / "two", nprocs=2, lmp=lmp, more=nowhere).ended_well    # the variable is heeded
