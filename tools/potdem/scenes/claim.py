# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The thesis's claims: what a scene's claims.py measures, and the table of all."""

from dataclasses import dataclass, replace

from potdem.scenes.scene import load

HEADER = ("| | claim | thesis | readings tried | measured | holds |", "|---|---|---|---|---|---|")


@dataclass
class Claim:
    """number: in design order, e.g. '2' or '4b'; verdict: 'yes', 'no', or 'partly' with the reason in measured"""

    number: str
    text: str
    thesis: str
    measured: str
    verdict: str
    scene: str = ""       # by of_scene
    readings: str = ""    # of what the thesis does not state: from the scene.yaml, by of_scene


def of_scene(scene, folder_of):
    """the claims that a scene's claims.py finds: claims(folder_of) -> list of Claim, folder_of(variant, draw=1) -> Path"""
    if not scene.claims:
        return []
    return [replace(found, scene=scene.name, readings=scene.readings.get(found.number, ""))
            for found in load(scene.claims).claims(folder_of)]


def of_draws(verdicts):
    """one verdict from those of several draws: each true, or false"""
    verdicts = list(verdicts)
    if all(verdicts):
        return "yes"
    return f"partly: {sum(verdicts)} of {len(verdicts)} draws" if any(verdicts) else "no"


def order(claim):
    digits = "".join(c for c in claim.number if c.isdigit())
    return int(digits or 0), claim.number


def table(claims, linked=False):
    """Markdown, by number; linked: for a page in docs, the numbers lead to the pages of the scenes"""
    def number(c):
        return f"[{c.number}](../examples/{c.scene}/README.md)" if linked else c.number

    rows = [f"| {number(c)} | {c.text} | {c.thesis} | {c.readings} | {c.measured} | {c.verdict} |" for c in sorted(claims, key=order)]
    return "\n".join([*HEADER, *rows])
