"""Scenes: their runs, comparison with the reference logs, pictures, the thesis's claims."""
