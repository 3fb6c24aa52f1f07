/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "body_area.h"

#include "admissible.h"
#include "constants.h"
#include "targets.h"
#include "volumes.h"

using namespace POTDEM;

namespace {

double misfit_inside(const BondedBody &body, const Surfaces &surfaces, LeastSquares &squares,
                     const std::vector<Matrix6> &admissible, const std::vector<Matrix6> &target)
{
  const auto misfits = squares.misfits(&target);
  double total[2] = {0.0, 0.0};
  for (int i = 0; i < body.nowned; i++) {
    if (!surfaces.inside(body, i)) continue;
    total[0] += misfits[i].square(admissible[i]);
    total[1] += 1.0;
  }
  body.halo.sum(total, 2);
  return std::sqrt(total[0] / total[1]);
}

}    // namespace

BodyAreaReport POTDEM::find_body_areas(BondedBody &body)
{
  BodyAreaReport report{};
  body.list_neighbours();
  const Cells cells(body);
  const Surfaces surfaces(body, cells);
  report.outcome = BodyAreaReport::NO_INSIDE;
  if (!find_volumes(body, cells, surfaces)) return report;
  const UniformAreas uniform(body, surfaces);
  if (uniform.factor == 0.0) return report;
  const auto admissible = admissible_strains(body, surfaces, uniform);
  LeastSquares squares(body, uniform.area, admissible);
  Targets targets(body, surfaces);
  squares.iterate(areas::FIRST_ITERATIONS, targets.asked());
  report.outcome = BodyAreaReport::MECHANISM;
  if (!targets.correct(squares, admissible)) return report;
  for (int round = 0; round < areas::ENERGY_ROUNDS; round++) {
    if (round > 0) targets.ask_for_missing(squares);
    squares.iterate(areas::ITERATIONS, targets.asked());
  }

  report.outcome = BodyAreaReport::DONE;
  report.iterations = squares.iterations();
  report.volume = uniform.volume;
  report.factor = uniform.factor;
  report.misfit = misfit_inside(body, surfaces, squares, admissible, targets.wanted());
  report.least = areas::MOST;
  report.most = areas::LEAST;
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    report.least = std::min(report.least, squares.solution()[b]);
    report.most = std::max(report.most, squares.solution()[b]);
    body.bonds[b].area = squares.area(b);
  }
  return report;
}
