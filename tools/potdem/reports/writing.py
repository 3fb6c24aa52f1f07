# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the reports write: Markdown tables, CSV, the machine they ran on."""

import csv
import datetime
import os
import re
import subprocess
from pathlib import Path

from potdem import running
from potdem.paths import BUILD, DOCS, LMP, ROOT


def folder(short):
    """docs/report of the full report; short ones must not overwrite it"""
    path = BUILD / "report" if short else DOCS / "report"
    path.mkdir(parents=True, exist_ok=True)
    return path


def number(value, digits=3):
    """text of a number with so many significant digits; other things as they are, None as nothing"""
    if value is None:
        return ""
    if not isinstance(value, float):
        return str(value)
    return f"{value:.{digits}g}" if abs(value) < 1e4 else f"{value:.{digits - 1}e}"


def table(header, rows):
    """Markdown; cells: text or numbers"""
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(number(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def with_blocks(text, found):
    """a page with the blocks of these names replaced; they stand between <!-- block NAME --> and <!-- end of NAME -->"""
    for name, block in found.items():
        begin, end = f"<!-- block {name} -->\n", f"<!-- end of {name} -->"
        before, _, rest = text.partition(begin)
        _, _, after = rest.partition(end)
        if not after:
            raise ValueError(f"the page has no block {name}")
        text = f"{before}{begin}\n{block}\n\n{end}{after}"
    return text


def write_csv(path, header, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([f"{cell:.10g}" if isinstance(cell, float) else cell for cell in row] for row in rows)


def read_csv(path):
    """rows as dicts of text"""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _first_line(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    return done.stdout.splitlines()[0] if done.stdout else "?"


def _setting(pattern, text):
    match = re.search(pattern, text, re.MULTILINE)
    return match.group(1).strip() if match else "?"


def machine():
    """(what, value) rows: what the times of a report belong to"""
    processor = Path("/proc/cpuinfo").read_text(encoding="utf-8") if Path("/proc/cpuinfo").exists() else ""
    about = subprocess.run([LMP, "-h"], capture_output=True, text=True, check=False, env=running.environment()).stdout
    return [
        ("processor", f"{_setting(r'^model name.*: (.*)', processor)}, {os.cpu_count()} cores"),
        ("compiler", _setting(r"^Compiler: (.*?)(?: with .*)?$", about)),
        ("LAMMPS", _setting(r"Massively Parallel Simulator - (.*)", about)),
        ("POTDEM", "commit " + _first_line("git", "describe", "--always", "--dirty")),
        ("date", datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")),
        ("load at the start", "%.1f processes" % os.getloadavg()[0]),
    ]
