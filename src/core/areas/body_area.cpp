/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "body_area.h"

#include "admissible.h"
#include "constants.h"
#include "dilatation.h"
#include "kinds.h"
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
    total[0] += body.alike[i] * misfits[i].square(admissible[i]);
    total[1] += body.alike[i];
  }
  body.halo.sum(total, 2);
  return std::sqrt(total[0] / total[1]);
}

// what a particle knows of itself from its surroundings
struct Setting {
  Surfaces surfaces;
  UniformAreas uniform;
  std::vector<Matrix6> admissible;
};

BodyAreaReport solve(BondedBody &body, const Setting &setting)
{
  const auto &[surfaces, uniform, admissible] = setting;
  BodyAreaReport report{};
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
  if (body.elasticity.has_volume_term()) {
    const Dilatation dilatation(body, squares.areas(), admissible);
    for (std::size_t b = 0; b < body.bonds.size(); b++)
      for (int end = 0; end < 2; end++) body.bonds[b].dilatation[end] = dilatation.weight(b, end);
  }
  return report;
}

}    // namespace

// the areas of more particles differ than their settings do
BodyAreaReport POTDEM::find_body_areas(BondedBody &body)
{
  BodyAreaReport refused{};
  refused.outcome = BodyAreaReport::NO_INSIDE;
  body.list_neighbours();
  Surroundings surroundings(body);
  surroundings.look(areas::SEEN_BONDS);
  Kinds near(body, surroundings);
  const Cells cells(near.body);
  const Surfaces surfaces(near.body, cells);
  if (!find_volumes(near.body, cells, surfaces)) return refused;
  const UniformAreas uniform(near.body, surfaces);
  if (uniform.factor == 0.0) return refused;
  near.give_volumes(body);

  surroundings.look(areas::ALIKE_BONDS);
  Kinds alike(body, surroundings);
  const auto given = [&](const auto &values) {
    return alike.take(near, values);
  };
  const Setting setting = {Surfaces(surfaces, given), UniformAreas(alike.body, uniform),
                           given(admissible_strains(near.body, surfaces, uniform))};
  const auto report = solve(alike.body, setting);
  if (report.outcome == BodyAreaReport::DONE) alike.give_areas(body);
  return report;
}
