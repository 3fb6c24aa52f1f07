# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Changes to texts that must not go unnoticed when there is nothing to change."""


def replaced(text, old, new, count=None):
    """the text (or bytes) with `new` for every `old`, or for the first `count`; an error where there are none, or fewer than `count`"""
    found = text.count(old)
    if found < (count or 1):
        raise ValueError(f"{old!r} stands {found} times, not {count or 'once or more'}, in a text that begins with {text[:500]!r}")
    return text.replace(old, new, -1 if count is None else count)
