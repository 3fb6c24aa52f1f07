"""The thesis's claims: what a scene's claims.py measures, and the table of all."""

import importlib.util
from dataclasses import dataclass

HEADER = ("| | claim | thesis | measured | holds |", "|---|---|---|---|---|")


@dataclass
class Claim:
    """number: in design order, e.g. '2' or '4b'; verdict: 'yes', 'no', or 'partly' with the reason in measured"""

    number: str
    text: str
    thesis: str
    measured: str
    verdict: str


def of_scene(scene, folder_of):
    """the claims that a scene's claims.py finds: claims(folder_of) -> list of Claim, folder_of(variant) -> Path"""
    if not scene.claims:
        return []
    module_spec = importlib.util.spec_from_file_location(f"claims_of_{scene.name.replace('-', '_')}", scene.claims)
    module = importlib.util.module_from_spec(module_spec)
    module_spec.loader.exec_module(module)
    return module.claims(folder_of)


def order(claim):
    digits = "".join(c for c in claim.number if c.isdigit())
    return int(digits or 0), claim.number


def table(claims):
    """Markdown, by number"""
    rows = [f"| {c.number} | {c.text} | {c.thesis} | {c.measured} | {c.verdict} |" for c in sorted(claims, key=order)]
    return "\n".join([*HEADER, *rows])
