"""The reports of tools/report."""
