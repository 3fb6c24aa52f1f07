/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Every number that `area body` has been given rather than finds: one line each, above it what it is and where it comes
   from. *Derived* and *rounding* need no measurement. *Chosen* ones were set on the beams of docs/area.md; what half and
   twice the value do is measured by tools/area_constants.py, which reads this file and prints the table of that page. */

#ifndef POTDEM_AREAS_CONSTANTS_H
#define POTDEM_AREAS_CONSTANTS_H

namespace POTDEM::areas {

// ---- the solid

// derived: Poisson's ratio of the only isotropic solid of central forces (Cauchy's relation)
static constexpr double POISSON = 0.25;
// derived: trace of the solid's stiffness over E, 3 C11 + 3 * 2 C44 with C11 = 6/5, C44 = 2/5
static constexpr double SOLID_TRACE = 6.0;
// derived: edge^2 over the variance of a cube along an edge; stands for all cells
static constexpr double SQUARE_OVER_VARIANCE = 12.0;

// ---- change of volume

// rounding: weight of the exact dilatation in admissible strains against that of small weights of the bonds: ten times less or more
// changes stiffnesses by less than 0.001
static constexpr double EXACT_WEIGHT = 1e5;
// chosen: largest share of the energy of a particle's bonds that a volume term with kappa < 0 may take back: less than 1, so that every
// strain meets resistance; 0.6 inside a solid of nu = 0
static constexpr double LARGEST_SHARE = 0.8;
// rounding: added to K, so that it has a root
static constexpr double NO_STATE = 1e-9;

// ---- cells

// rounding: least distance of a side of a cell from its centre, over the bond's length
static constexpr double AT_CENTRE = 1e-9;
// chosen: bond (counted from 0, by length) that tells the spacing: even a corner has three close neighbours
static constexpr int SHORTEST = 2;
// derived: pi (3 - sqrt 5), the turn from one direction of the spiral to the next
static constexpr double GOLDEN_ANGLE = 2.39996322972865332;
// chosen: rays of all inner cells together: a bound on the time, a few seconds
static constexpr double RAYS = 2e7;
// chosen: least rays of one cell: volumes of lattices within 1 %
static constexpr double LEAST_RAYS = 400.0;
// chosen: most rays of one cell: volumes of lattices within 0.2 %
static constexpr double MOST_RAYS = 2000.0;

// ---- particles with the same surroundings, which are solved once

// rounding: difference of lengths, over the mean length of a bond, within which they are the same
static constexpr double ALIKE = 1e-9;
// derived: bonds as far as which a particle's surfaces, volume and admissible states depend on others: one for its cell,
// one more for the faces that end it and the surface around it, and NEARBY_BONDS
static constexpr int SEEN_BONDS = 4;
// chosen: bonds as far as which its areas do: the influence of what is farther away fades to a fifth with every bond
static constexpr int ALIKE_BONDS = 16;

// ---- free surfaces

// chosen: directions in which a particle looks for neighbours
static constexpr int SURFACE_RAYS = 400;
// chosen: diameters beyond which a ray that is still in its cell is open
static constexpr double OPEN_FROM = 1.0;
// chosen: fewer open rays are a pore of the packing
static constexpr int PORE = 2;
// chosen: share of the open rays' second moment from which a direction is blocked: a face has below 0.12, edge and corner 0.29
static constexpr double BLOCKED_SHARE = 0.2;
// chosen: share of the surface around a particle, by its directions, from which a second one makes an edge, a third one a corner: 0.16
// or more there, 0.12 or less at the steps of spheres of four spacings and more
static constexpr double EDGE_SPREAD = 0.145;
// chosen: share of the open rays' length that is left along a face's normal: a cone has (1 + cos)/2, a slit 0
static constexpr double ONE_SIDE = 0.5;

// ---- volumes at surfaces: lambda is how far a face is outside its particles' centres, in radii

// chosen: least lambda that is looked for (0.71 for fcc)
static constexpr double LEAST_LAMBDA = 0.5;
// chosen: largest lambda that is looked for (1 for simple cubic, 1.04 for a random packing between walls)
static constexpr double MOST_LAMBDA = 1.2;
// chosen: a cell's volume as a function of lambda is the parabola through this,
static constexpr double LOW_SAMPLE = 0.6;
// chosen: this and the middle
static constexpr double HIGH_SAMPLE = 1.0;
// rounding: width at which bisection ends
static constexpr double LAMBDA_ROUNDING = 1e-15;

// ---- admissible states

// chosen: bonds through which a surface is felt: the states there fade over two
static constexpr int NEARBY_BONDS = 2;
// chosen: second moment (1 inside the body) that a surface nearby takes off
static constexpr double NEARBY = 5.0;
// chosen: second moment along a direction, over the largest, up to which the normal stress there is not trusted
static constexpr double CUT_OFF = 0.7;
// chosen: the same, from which it is trusted
static constexpr double COMPLETE = 0.9;
// chosen: square root of the least trust in the normal stress along a direction; K has the fourth power, a hundredth
static constexpr double FLOOR = 0.3;
// derived: twice NEARBY, so that blocked directions come first
static constexpr double BEHIND = 10.0;

// ---- least squares

// chosen: least area over the uniform one; positive, so that each bond stiffens
static constexpr double LEAST = 0.1;
// chosen: largest area over the uniform one
static constexpr double MOST = 4.0;
// chosen: weight of area over uniform - 1, against 1 of energy and balance
static constexpr double PULL = 0.02;
// chosen: steps of the power iteration for the largest eigenvalue of one particle's misfit, the bound of the step
static constexpr int POWER_ITERATIONS = 12;
// rounding: curvature over the largest of a particle's, below which it does not see the bond
static constexpr double UNSEEN = 1e-9;

// ---- course of the solution

// chosen: gradient steps before the targets are corrected
static constexpr int FIRST_ITERATIONS = 20;
// chosen: gradient steps after each time the energy is asked for
static constexpr int ITERATIONS = 20;
// chosen: times the energy is asked for, first in full, then what it lacks
static constexpr int ENERGY_ROUNDS = 3;

// ---- targets

// chosen: least stiffness over E of a network that is no mechanism
static constexpr double SOFT = 0.02;
// chosen: added to the stencil's matrix, over its mean eigenvalue: keeps the weights small
static constexpr double RIDGE = 0.3;
// rounding: added to the gradient's matrix, over its trace: bonds may lie in one plane
static constexpr double FLAT = 1e-9;
// chosen: applications of the stencil; between them what has no depth is handed inwards by one neighbour
static constexpr int HANDING_ROUNDS = 4;
// chosen: how much less of a neighbour's directions is open if it is deeper inside
static constexpr double DEEPER = 0.02;
// chosen: largest change of a particle's target as seen through K (Frobenius norm; C has sqrt 6)
static constexpr double LARGEST_CHANGE = 1.5;
// rounding: layer times variance of a cell, below which there is no surface nearby
static constexpr double NO_LAYER = 1e-6;

}    // namespace POTDEM::areas

#endif
