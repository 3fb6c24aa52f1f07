/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "volumes.h"

#include "constants.h"

using namespace POTDEM;

namespace {

// of a face, seen from a particle near it
struct Plane {
  Vector3 normal;
  double height, radius;    // of the particle that it touches
};

std::vector<Plane> planes_nearby(const BondedBody &body, const Cells &cells,
                                 const Surfaces &surfaces, int i)
{
  std::vector<Plane> planes;
  auto add = [&](int j, const Vector3 &dx) {
    const Vector3 &n = surfaces.normal[j];
    if (dot(n, n) > 0.0) planes.push_back({n, dot(n, dx), 0.5 * cells.diameter(j)});
  };
  add(i, {});
  for (const auto &to : body.neighbours(i)) add(to.particle, body.separation(to));
  return planes;
}

// coefficients of the parabola through three values at evenly spaced places around `middle`
Vector3 parabola(const Vector3 &value, double middle, double h)
{
  const double curved = (value[0] - 2.0 * value[1] + value[2]) / (2.0 * h * h);
  const double slope = (value[2] - value[0]) / (2.0 * h) - 2.0 * curved * middle;
  return {value[1] - middle * (slope + curved * middle), slope, curved};
}

double at(const Vector3 &coefficients, double lambda)
{
  return coefficients[0] + lambda * (coefficients[1] + lambda * coefficients[2]);
}

// sums: volume and d^3 of the inner cells; coefficients of the others' volume; d^3 and volume given, of all
enum { CLOSED, CLOSED_CUBES, SURFACE, CUBES = SURFACE + 3, GIVEN, SUMS };

// the lambda with which the cells have the volume given; 0: none has
double find_lambda(const double *total)
{
  auto missing = [total](double lambda) {
    return total[GIVEN] - total[CLOSED] - total[SURFACE] -
        lambda * (total[SURFACE + 1] + lambda * total[SURFACE + 2]);
  };
  double low = areas::LEAST_LAMBDA, high = areas::MOST_LAMBDA;
  if (missing(low) < 0.0 || missing(high) > 0.0) return 0.0;
  while (high - low > areas::LAMBDA_ROUNDING)
    (missing(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  return low;
}

double count_inside(const BondedBody &body, const Surfaces &surfaces)
{
  double count = 0.0;
  for (int i = 0; i < body.nowned; i++) count += body.alike[i] * surfaces.inside(body, i);
  body.halo.sum(&count, 1);
  return count;
}

}    // namespace

// a ray ends at the latest where it counts as open
Vector3 POTDEM::volume_at_surface(const BondedBody &body, const Cells &cells,
                                  const Surfaces &surfaces, int i, const std::vector<Vector3> &rays)
{
  const double middle = 0.5 * (areas::LOW_SAMPLE + areas::HIGH_SAMPLE);
  const double samples[3] = {areas::LOW_SAMPLE, middle, areas::HIGH_SAMPLE};
  const auto planes = planes_nearby(body, cells, surfaces, i);
  const double radius = 0.5 * cells.diameter(i), open = 2.0 * areas::OPEN_FROM * radius;
  const Cell cell = cells.of(i);
  Vector3 cubes{};
  for (const auto &ray : rays) {
    const double end = std::min(cell.reach(ray), open);
    for (int l = 0; l < 3; l++) {
      double r = end;
      for (const auto &plane : planes) {
        const double along = dot(ray, plane.normal);
        // no plane cuts into the particle itself
        const double height =
            std::max(plane.height + samples[l] * plane.radius, samples[l] * radius);
        if (along * r > height) r = height / along;
      }
      cubes[l] += r * r * r;
    }
  }
  for (auto &v : cubes) v *= 4.0 * M_PI / 3.0 / rays.size();
  return parabola(cubes, middle, middle - areas::LOW_SAMPLE);
}

bool POTDEM::find_volumes(BondedBody &body, const Cells &cells, const Surfaces &surfaces)
{
  const double count = count_inside(body, surfaces);
  if (count == 0.0) return false;
  // few cells need many rays
  const auto rays = spiral_directions(
      static_cast<int>(std::clamp(areas::RAYS / count, areas::LEAST_RAYS, areas::MOST_RAYS)));
  std::vector<Vector3> volumes(body.nowned, Vector3{});    // of each cell, as a function of lambda
  double total[SUMS] = {};
  for (int i = 0; i < body.nowned; i++) {
    if (!body.bonded(i)) continue;
    const double n = body.alike[i], d = body.diameter[i], cube = n * d * d * d;
    if (surfaces.inside(body, i)) {
      volumes[i][0] = cells.volume(i, rays);
      total[CLOSED] += n * volumes[i][0];
      total[CLOSED_CUBES] += cube;
    } else {
      volumes[i] = volume_at_surface(body, cells, surfaces, i, rays);
      for (int k = 0; k < 3; k++) total[SURFACE + k] += n * volumes[i][k];
    }
    total[CUBES] += cube;
    if (!body.volume.empty()) total[GIVEN] += n * body.volume[i];
  }
  body.halo.sum(total, SUMS);
  const double per_cube = total[CLOSED] / total[CLOSED_CUBES];
  if (body.volume.empty()) {
    for (const double d : body.diameter) body.volume.push_back(per_cube * d * d * d);
    total[GIVEN] = per_cube * total[CUBES];
  }
  const double lambda = find_lambda(total);
  if (lambda == 0.0) return true;
  for (int i = 0; i < body.nowned; i++)
    if (body.bonded(i)) body.volume[i] = at(volumes[i], lambda);
  body.forward(body.volume);
  return true;
}
