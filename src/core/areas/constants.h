/* Every number that `area body` has been given rather than found: what it is, and where it comes from. Those that
   nothing derives were chosen on the beams of docs/area.md; what half and twice the value do to a random packing is
   measured by tools/area_constants.py (table "Constants" of docs/area.md). Names stand once, here. */

#ifndef POTDEM_AREAS_CONSTANTS_H
#define POTDEM_AREAS_CONSTANTS_H

namespace POTDEM {
namespace areas {

  // the solid
  static constexpr double POISSON =
      0.25;    // the only isotropic solid of central forces (Cauchy's relation)
  static constexpr double SOLID_TRACE =
      6.0;    // trace of its stiffness over E: 3 C11 + 3 * 2 C44, C11 = 6/5, C44 = 2/5
  static constexpr double SQUARE_OVER_VARIANCE = 12.0;    // of a cube along an edge

  // cells (cells.cpp)
  static constexpr int SHORTEST =
      2;    // bond that tells the spacing, from 0: a corner has three close neighbours
  static constexpr double GOLDEN_ANGLE = 2.39996322972865332;    // pi (3 - sqrt 5)
  static constexpr double RAYS = 2e7;    // all inner cells together: a few seconds at most
  static constexpr double LEAST_RAYS = 400.0, MOST_RAYS = 2000.0;    // of one cell

  // free surfaces (surfaces.cpp)
  static constexpr int SURFACE_RAYS = 400;    // of one particle
  static constexpr double OPEN_FROM =
      1.0;                          // diameters: a ray that leaves the cell beyond it is open
  static constexpr int PORE = 2;    // fewer open rays are a pore of the packing
  static constexpr double BLOCKED_SHARE =
      0.2;    // of the trace: a face has below 0.12 along it, edge and corner above 0.29
  static constexpr double ONE_SIDE =
      0.5;    // of the open rays' length is left of their sum along a face's normal

  // volumes at surfaces (volumes.cpp): lambda is the distance of a face from its particles, in radii
  static constexpr double LEAST_LAMBDA = 0.5,
                          MOST_LAMBDA =
                              1.2;    // 0.71 fcc, 1 simple cubic, 1.04 random between walls
  static constexpr double LOW_SAMPLE = 0.6,
                          HIGH_SAMPLE =
                              1.0;    // a cell's volume is a parabola through these and the middle
  static constexpr double LAMBDA_ROUNDING = 1e-15;

  // admissible states (admissible.cpp)
  static constexpr int NEARBY_BONDS = 2;    // surfaces are felt as far as two bonds reach
  static constexpr double NEARBY =
      5.0;    // second moment (1 inside) that a surface there takes off
  static constexpr double CUT_OFF = 0.7,
                          COMPLETE =
                              0.9;    // second moment over its largest: state not trusted, trusted
  static constexpr double FLOOR =
      0.3;    // least trust per direction: squared twice, a hundredth of the energy for two
  static constexpr double BEHIND =
      10.0;    // beyond any second moment: puts the blocked directions first

  // least squares (least_squares.cpp)
  static constexpr double
      LEAST = 0.1,
      MOST = 4.0;    // of an area over the uniform one: positive, so that each bond stiffens
  static constexpr double PULL =
      0.02;    // weight of area/uniform - 1 against 1 of the two conditions
  static constexpr int POWER_ITERATIONS =
      12;                                   // for the largest eigenvalue of one particle's misfit
  static constexpr double UNSEEN = 1e-9;    // of the largest curvature: rounding

  // course of the solution (body_area.cpp)
  static constexpr int FIRST_ITERATIONS = 20;    // before the targets are corrected
  static constexpr int ITERATIONS = 20;          // after each time the energy is asked for
  static constexpr int ENERGY_ROUNDS =
      3;    // the energy is asked for once, and what it lacks twice more

  // targets (surface_layer.cpp, targets.cpp)
  static constexpr double SOFT =
      0.02;    // least stiffness over E of a network that is no mechanism
  static constexpr double RIDGE =
      0.3;    // of the mean eigenvalue: keeps the stencil's weights small
  static constexpr double FLAT = 1e-9;    // of the trace: bonds in one plane have a gradient in it
  static constexpr int HANDING_ROUNDS =
      4;    // what has no depth is handed inwards so many particles less one
  static constexpr double DEEPER =
      0.02;    // less of the directions open: not rounding, not roughness
  static constexpr double LARGEST_CHANGE =
      1.5;    // of a particle's target, root of the sum of squares of its six states
  static constexpr double NO_LAYER = 1e-6;    // below: rounding, no surface nearby

}    // namespace areas
}    // namespace POTDEM

#endif
