# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# beam.ipynb is made from this file: tools/python -m potdem.notebook examples/recipes/beam.py

# %% [markdown]
# # A beam that breaks, from Python
#
# A block falls on a cantilever. We set the scene up, look at the strain while the beam bends, let it break, and ask where the energy went.

# %%
import matplotlib.pyplot as plt
import numpy as np
from potdem.simulation import Simulation

SCENE = """
units           si
atom_style      bpm/sphere
boundary        f f f
lattice         sc 0.005
region          box block -20 44 -20 25 -15 30
create_box      1 box bond/types 1
region          beam block 0 20 0 4 0 4
region          block block 16 20 0 4 7 11
create_atoms    1 region beam
create_atoms    1 region block
set             group all diameter 0.005 mass $(2400*0.005^3)
set             region block vz -2
potdem_bonds    all 1 2.0 diameters
bond_style      potdem/truss
bond_coeff      1 3e6 area lattice
pair_style      potdem/truss
pair_coeff      1 1 3e6 0.4
region          free block 1 INF INF INF INF INF
group           free region free
region          floor plane 0 0 -12 0 0 1
fix             move free nve
fix             weight free gravity 9.81 vector 0 0 -1
fix             floor free potdem/wall/region floor 3e10 0.2 particle 3e6 0.2
fix             cracks all potdem/failure 1 tension 2e5
timestep        5e-6
"""

scene = Simulation()
scene.commands(SCENE)

# %% [markdown]
# The strain is asked for once before anything moves: that is its reference.

# %%
scene.strain()
scene.ledger()
scene.run(2800)
x = scene.particles("x")
strain = scene.strain()[:, 0]

side = x[:, 1] < 0.001
plt.figure(figsize=(8, 3))
plt.scatter(1e3 * x[side, 0], 1e3 * x[side, 2], c=strain[side], s=60, cmap="coolwarm")
plt.colorbar(label="strain along the beam")
plt.xlabel("x, mm")
plt.ylabel("z, mm")
plt.axis("equal")
plt.title(f"{1e3 * scene.time:.1f} ms, {len(scene.cracks('cracks')['step'])} bonds broken")
plt.tight_layout()
plt.show()

# %% [markdown]
# On to the end, with the ledger on the way. The sum of all terms stays what it was.

# %%
rows = []
for _ in range(60):
    scene.run(200)
    rows.append({"time": scene.time, **scene.ledger()})

plt.figure(figsize=(8, 3))
for term in ("kinetic", "gravity", "bonds", "fracture", "total"):
    plt.plot([1e3 * row["time"] for row in rows], [1e3 * row[term] for row in rows], label=term)
plt.xlabel("time, ms")
plt.ylabel("energy, mJ")
plt.legend(loc="center left", bbox_to_anchor=(1, 0.5))
plt.tight_layout()
plt.show()

# %% [markdown]
# Where did it break? The place of each bond when it was removed, and the pieces that are left.

# %%
cracks = scene.cracks("cracks")
pieces, sizes = np.unique(scene.pieces(), return_counts=True)
print(f"{len(cracks['step'])} bonds failed, half of them within {1e3 * np.median(cracks['x']):.0f} mm of the clamp")
print(f"{len(pieces)} pieces; the largest have {np.sort(sizes)[::-1][:3]} particles")

# %%
scene.close()
