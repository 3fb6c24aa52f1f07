/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/potdem_stiffness.h"

#include "core/stability/critical_step.h"

#include "math_eigen.h"

#include <algorithm>
#include <utility>

using namespace LAMMPS_NS;

void PotdemStiffness::reset(std::vector<double> inverse_root_masses)
{
  inverse_root = std::move(inverse_root_masses);
  stiffness.assign(inverse_root.size(), {});
  viscosity.clear();
  stiffest.assign(inverse_root.size(), 0.0);
}

void PotdemStiffness::Tensor::add(const Tensor &more)
{
  xx += more.xx;
  yy += more.yy;
  zz += more.zz;
  xy += more.xy;
  xz += more.xz;
  yz += more.yz;
}

double PotdemStiffness::Tensor::largest_eigenvalue() const
{
  const double matrix[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  double values[3], vectors[3][3];
  MathEigen::jacobi3(matrix, values, vectors);
  return values[0];
}

// not below the largest eigenvalue (Gershgorin)
double PotdemStiffness::Tensor::largest_row() const
{
  const double ab = std::fabs(xy), ac = std::fabs(xz), bc = std::fabs(yz);
  return std::max({xx + ab + ac, yy + ab + bc, zz + ac + bc});
}

/* ---------------------------------------------------------------------- */

PotdemSteps PotdemStiffness::steps_of(int i, double (Tensor::*largest)() const) const
{
  const double scale = inverse_root[i];
  const double k = scale * (stiffness[i].*largest)();
  const double c = viscosity.empty() ? 0.0 : scale * (viscosity[i].*largest)();
  return {POTDEM::critical_step(k, c), POTDEM::critical_step(k, 0.0),
          1.0 / (scale * std::sqrt(stiffest[i]))};
}

PotdemSteps PotdemStiffness::steps(int i) const
{
  return steps_of(i, &Tensor::largest_eigenvalue);
}

PotdemSteps PotdemStiffness::short_of_steps(int i) const
{
  return steps_of(i, &Tensor::largest_row);
}

/* ---------------------------------------------------------------------- */

// of a ghost, for its owner
void PotdemStiffness::pack(int i, double *buf) const
{
  const Tensor none{}, tensors[2] = {stiffness[i], viscosity.empty() ? none : viscosity[i]};
  for (const auto &t : tensors)
    for (const double value : {t.xx, t.yy, t.zz, t.xy, t.xz, t.yz}) *buf++ = value;
  *buf = stiffest[i];
}

void PotdemStiffness::unpack(int i, const double *buf)
{
  const auto tensor = [](const double *v) {
    return Tensor{v[0], v[1], v[2], v[3], v[4], v[5]};
  };
  stiffness[i].add(tensor(buf));
  stiffest[i] = std::max(stiffest[i], buf[12]);
  const Tensor viscous = tensor(buf + 6);
  if (viscous.largest_row() == 0.0) return;
  if (viscosity.empty()) viscosity.assign(stiffness.size(), {});
  viscosity[i].add(viscous);
}

double PotdemStiffness::memory_usage() const
{
  return static_cast<double>((stiffness.capacity() + viscosity.capacity()) * sizeof(Tensor) +
                             (inverse_root.capacity() + stiffest.capacity()) * sizeof(double));
}
