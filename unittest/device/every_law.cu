/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Every contact law with every rate law and tangential law, and every bond law, in a kernel for a device. With no argument it
   compares what the device finds with what the host finds, and prints the largest relative difference. */

#include "core/contact/contact.h"
#include "core/laws/hertz_wall.h"
#include "core/laws/law_list.h"
#include "core/stability/critical_step.h"
#include "core/stability/turning_point.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

using namespace POTDEM;

namespace {

constexpr int WIDTH = 24;    // numbers of one contact, at most

struct Motion {
  ContactMotion at;
  POTDEM_FUNCTION ContactMotion operator()() const { return at; }
};

struct Masses {
  POTDEM_FUNCTION ContactMasses operator()() const
  {
    return {0.25, 1.0, 1e-4, 1e-4, 2.0 / 7.0, 0.8, 0.625};
  }
};

// a contact at the distance r, with forces, spring and turning point
template <class Kernel, class Geometry, class Rate, class Tangential>
POTDEM_FUNCTION void contact(const Kernel &kernel, double r, const Geometry &geometry,
                             const Rate &rate, const Tangential &rough, double *out)
{
  double state[Tangential::STATE + 1] = {};
  const Motion motion{{{0.6 * r, 0.0, 0.8 * r},
                       r,
                       {-0.1, 0.2, 0.05},
                       {0.3, -0.2, 0.1},
                       {0.5, 0.7, -0.4},
                       {0.2, 0.1, 0.6}}};
  const double n[3] = {0.6, 0.0, 0.8};
  const auto forces =
      contact_forces<true>(kernel, r, geometry, 1.0, rate, rough, state, true, motion, Masses());
  const auto spring = contact_spring(kernel, r, geometry, 1.0, rate, rough, Masses()(), n);
  const auto law = [&](double distance) {
    return kernel.evaluate(distance, geometry);
  };
  const double found[] = {
      forces.elastic.energy,
      forces.elastic.force,
      forces.elastic.stiffness,
      forces.normal,
      forces.viscous,
      forces.surface.friction[0],
      forces.surface.friction[1],
      forces.surface.friction[2],
      forces.surface.torque[0],
      forces.surface.torque[1],
      forces.surface.torque[2],
      spring.along,
      spring.across,
      spring.viscosity,
      spring.friction,
      closest_approach(r, -0.5, 1.0, geometry.contact, kernel.hard_core(geometry), 1e-3, law),
      critical_step(spring.along, spring.viscosity),
      state[0],
      state[Tangential::STATE > 4 ? Tangential::STATE - 2 : 0]};
  static_assert(sizeof(found) <= WIDTH * sizeof(double));
  for (int k = 0; k < static_cast<int>(sizeof(found) / sizeof(double)); k++) out[k] = found[k];
}

template <class Law, class Rate, class Tangential>
POTDEM_FUNCTION void contacts(const typename Law::Kernel &kernel, const Rate &rate,
                              const Tangential &rough, int k, double *out)
{
  const double r = 1.0 - 1e-3 * (k + 1);
  if constexpr (std::is_same_v<Law, HertzWall>)
    contact(kernel, r, WallGeometry{1.0, 1.1}, rate, rough, out);
  else
    contact(kernel, r, ContactGeometry{0.4, 0.6, 1.0}, rate, rough, out);
}

template <class Law, class Rate, class Tangential>
__global__ void all_contacts(typename Law::Kernel kernel, Rate rate, Tangential rough, int n,
                             double *out)
{
  const int k = blockIdx.x * blockDim.x + threadIdx.x;
  if (k < n) contacts<Law>(kernel, rate, rough, k, out + WIDTH * k);
}

template <class Law>
POTDEM_FUNCTION void bonds(const typename Law::Kernel &kernel, int k, double *out)
{
  double state[Law::STATE + 1] = {};
  const double x = 0.9 + 1e-3 * k;
  out[0] = kernel.load(x * x, state);
  const auto found = kernel.evaluate(x, 1.0, 1e6, state);
  out[1] = found.energy;
  out[2] = found.force;
  out[3] = found.stiffness;
}

template <class Law> __global__ void all_bonds(typename Law::Kernel kernel, int n, double *out)
{
  const int k = blockIdx.x * blockDim.x + threadIdx.x;
  if (k < n) bonds<Law>(kernel, k, out + WIDTH * k);
}

constexpr int N = 200;
double largest = 0.0;

void check(cudaError_t status)
{
  if (status == cudaSuccess) return;
  std::printf("%s\n", cudaGetErrorString(status));
  std::exit(2);
}

template <class Launch, class Host>
void compare(const char *name, const Launch &launch, const Host &host)
{
  double *there;
  check(cudaMalloc(&there, N * WIDTH * sizeof(double)));
  check(cudaMemset(there, 0, N * WIDTH * sizeof(double)));
  launch(there);
  check(cudaGetLastError());
  std::vector<double> device(N * WIDTH), here(N * WIDTH, 0.0);
  check(cudaMemcpy(device.data(), there, N * WIDTH * sizeof(double), cudaMemcpyDeviceToHost));
  check(cudaFree(there));
  host(here.data());
  double most = 0.0;
  int filled = 0;
  for (int c = 0; c < WIDTH; c++) {
    double scale = 0.0;
    for (int k = 0; k < N; k++) scale = std::fmax(scale, std::fabs(here[WIDTH * k + c]));
    filled += scale > 0.0;
    for (int k = 0; k < N && scale > 0.0; k++)
      most = std::fmax(most, std::fabs(device[WIDTH * k + c] - here[WIDTH * k + c]) / scale);
  }
  std::printf("%-56s %2d columns, largest difference %.2e\n", name, filled, most);
  largest = std::fmax(largest, most);
}

// a kernel with its table, if it has one, where the device can read it
template <class Kernel> auto for_device(Kernel kernel, int) -> decltype(kernel.factor, Kernel())
{
  if (!kernel.factor.tabulated()) return kernel;
  const std::size_t size = (Penetration::nodes + 1) * sizeof(double);
  double *copy;
  check(cudaMalloc(&copy, size));
  check(cudaMemcpy(copy, kernel.factor.tabulated(), size, cudaMemcpyHostToDevice));
  kernel.factor.use(copy);
  return kernel;
}
template <class Kernel> auto for_device(Kernel kernel, int) -> decltype(kernel.truss, Kernel())
{
  kernel.truss = for_device(kernel.truss, 0);
  return kernel;
}
template <class Kernel> Kernel for_device(Kernel kernel, long)
{
  return kernel;
}

template <class Law, class Rate, class Tangential>
void compare_contact(const std::string &name, Law law, Rate rate, Tangential rough)
{
  const auto kernel = law.kernel(false), there = for_device(kernel, 0);
  compare(
      name.c_str(),
      [&](double *out) {
        all_contacts<Law><<<1, 256>>>(there, rate, rough, N, out);
      },
      [&](double *out) {
        for (int k = 0; k < N; k++) contacts<Law>(kernel, rate, rough, k, out + WIDTH * k);
      });
}

template <class Law> void compare_bond(const char *name, Law law)
{
  const auto kernel = law.kernel(), there = for_device(kernel, 0);
  compare(
      name,
      [&](double *out) {
        all_bonds<Law><<<1, 256>>>(there, N, out);
      },
      [&](double *out) {
        for (int k = 0; k < N; k++) bonds<Law>(kernel, k, out + WIDTH * k);
      });
}

// all coefficients from the table: a value in the range of each
template <class Law> Law some_law()
{
  Law law{};
  for (const auto &one : Law::coefficients()) {
    double value = one.range.low + 0.5;
    if (one.range.bounded()) value = 0.5 * (one.range.low + one.range.high);
    if (one.range.whole) value = 2.0;
    if (std::strcmp(one.unit, "1") != 0 && std::strcmp(one.unit, "length") != 0) value = 1e4;
    if (std::strcmp(one.unit, "time") == 0) value = 1e-3;
    if (one.kind == CoefficientTraits::FLAG || one.kind == CoefficientTraits::SETTING) value = 0.0;
    law.*one.value = value;
  }
  return law;
}

template <class Law> auto completed(Law law, int) -> decltype(law.complete(), Law())
{
  law.complete();
  return law;
}
template <class Law> Law completed(Law law, long)
{
  return law;
}

template <class Law, class Rate>
void with_every_friction(const std::string &name, Law law, Rate rate)
{
  compare_contact(name, law, rate, Frictionless());
#define POTDEM_WITH(Tangential)                                               \
  {                                                                           \
    const auto rough = completed(some_law<Tangential>(), 0);                  \
    compare_contact(name + ", " #Tangential, law, rate, rough);               \
    compare_contact(name + ", " #Tangential ", rolls", law, rate,             \
                    Rolls<Tangential>{rough, some_law<RollingResistance>()}); \
  }
  TANGENTIAL_LAWS(POTDEM_WITH)
#undef POTDEM_WITH
}

template <class Law> void with_every_rate(const std::string &name)
{
  const auto law = completed(some_law<Law>(), 0);
  with_every_friction(name, law, Elastic());
#define POTDEM_WITH(Rate)            \
  if constexpr (Rate::serves<Law>()) \
    with_every_friction(name + ", " #Rate, law, completed(some_law<Rate>(), 0));
  RATE_LAWS(POTDEM_WITH)
#undef POTDEM_WITH
}

}    // namespace

int main()
{
#define POTDEM_CONTACT(name, Law) with_every_rate<Law>(#name);
  CONTACT_LAWS(POTDEM_CONTACT)
  with_every_rate<HertzWall>("hertz wall");
#define POTDEM_BOND(name, Law) compare_bond(#name " bond", completed(some_law<Law>(), 0));
  BOND_LAWS(POTDEM_BOND)
  std::printf("largest %.3e\n", largest);
  return largest < 1e-12 ? 0 : 1;
}
