"""What a restart must bring back of a pair style's settings."""

import pytest
import scripts

MATERIAL = "1000 0.3 viscous 1.0 friction 0.3 1.0"


def pair(kinds):
    return scripts.box(20, types=2) + "bond_style none\n" + scripts.particles(
        [(0, 0, 0, 1.0, kinds[0]), (0.9, 0, 0, 1.0, kinds[1])])


def before_and_after(run_lammps, script, velocity, again=""):
    show = "compute t all property/atom tqz\nrun 0\n" + scripts.result("fx[1]", "fy[1]", "C_t[1]")
    script += f"group two id 2\nvelocity all set 0 0 0\nvelocity two set {velocity}\n" + show
    script += "write_restart now.restart\nclear\nread_restart now.restart\n" + again + show
    before, after = scripts.results(run_lammps(script).stdout)
    return before, after


@pytest.mark.parametrize("kinds", [(1, 2), (2, 1)])
def test_friction_of_an_explicit_pair(run_lammps, kinds):
    script = pair(kinds) + "pair_style potdem/hertz\npair_coeff 1 1 1000 0.3\npair_coeff 2 2 1000 0.3\n"
    before, after = before_and_after(run_lammps, script + "pair_coeff 1 2 1000 0.3 friction 0.3 1.0\n", "0 1 0")
    assert before[1] == pytest.approx(1.0)
    assert after == pytest.approx(before)


@pytest.mark.parametrize("style", ["", "hybrid ", "hybrid/overlay "])
@pytest.mark.parametrize("kinds", [(1, 1), (1, 2)])
def test_rotation_and_attract(run_lammps, style, kinds):
    """hybrid styles want their pair_coeff again, not their settings"""
    name = "potdem/hertz" if style else ""
    coeff = f"pair_coeff 1 1 {name} {MATERIAL}\npair_coeff 2 2 {name} {MATERIAL}\n"
    if style:
        coeff += f"pair_coeff 1 2 {name} {MATERIAL}\n"
    script = pair(kinds) + f"pair_style {style}potdem/hertz rotation yes attract yes\n" + coeff
    for velocity in ("1 0 0", "-1 1 0"):
        before, after = before_and_after(run_lammps, script, velocity, coeff if style else "")
        assert before[0] > 0 if velocity == "1 0 0" else before[2] != 0.0
        assert after == pytest.approx(before)
