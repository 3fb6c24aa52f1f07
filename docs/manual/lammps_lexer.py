# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Colours of LAMMPS scripts: the command is the first word of a line that does not continue another."""

from pygments.lexer import RegexLexer
from pygments.token import Comment, Keyword, Name, Number, String, Text

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w./])"


class LammpsLexer(RegexLexer):
    name = "LAMMPS"
    aliases = ["LAMMPS", "lammps"]
    filenames = ["in.*", "*.lmp"]

    tokens = {
        "root": [
            (r"\s+", Text),
            (r"#.*", Comment),
            (r"[A-Za-z_]\w*", Keyword, "arguments"),
            (r".", Text, "arguments"),
        ],
        "arguments": [
            (r"&[ \t]*\n", Text),
            (r"\n", Text, "#pop"),
            (r"#.*", Comment),
            (r'"""(?:.|\n)*?"""', String),
            (r'"[^"\n]*"|\'[^\'\n]*\'', String),
            (r"\$\{\w+\}|\$\([^)\n]*\)|\$\w", Name.Variable),
            (r"\bpotdem/[\w/]+|\bpotdem_\w+", Name.Class),
            (r"\b[cfv]_\w+", Name.Variable),
            (r"(?<![\w./])" + NUMBER, Number),
            (r"[ \t]+", Text),
            (r"[\w./:-]+", Text),
            (r".", Text),
        ],
    }
