/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Non-penetration factor (thesis eqs 5.22 and 5.23a) with the dimensionless argument x = r/re:

     c(x) = (1 + (1+x)^-m) / (1 - (1+x)^-m) = 1 + 2 / ((1+x)^m - 1)      m = 1, 2, 3, ...

   c -> 2/(m x) as x -> 0, so that the truss force A E c eps goes to minus infinity and two centres
   cannot pass each other. (The thesis multiplies the stiffness instead, 5.23b; the force then stays
   finite at x = 0.) c(1) = (2^m + 1)/(2^m - 1) > 1 stiffens the truss at rest; `normalized` divides
   by it. The energy needs the integral of c eps; with y = 1 + x

     integral_1^x c eps dt = (x-1)^2 (x+2)/6  -  ln(x)/m  +  S(x),
     S'(x) = (x^2 - 1)/((1+x)^m - 1) + 1/(m x)      bounded on x >= 0

   S is tabulated once per m (on a host) by Gauss-Legendre quadrature and interpolated with cubic Hermite
   polynomials (exact slopes at the nodes): relative error of the energy below 1e-10 on
   0 < x <= x_table; beyond it the quadrature is done directly. */

#ifndef POTDEM_PENETRATION_H
#define POTDEM_PENETRATION_H

#include "device.h"

#include <cmath>
#include <map>
#include <vector>

namespace POTDEM {

constexpr int MAX_PENETRATION = 64;    // largest exponent m

class Penetration {
 public:
  Penetration() = default;

  Penetration(int exponent, bool normalized) :
      m(exponent), scale(normalized ? (power(2.0) - 1.0) / (power(2.0) + 1.0) : 1.0),
      table(table_of(exponent).data())
  {
  }

  // S at the nodes, for a device that has a copy of its own
  static constexpr int nodes = 4096;
  const double *tabulated() const { return table; }
  void use(const double *copy) { table = copy; }

  // of one number or of four
  template <class Number> POTDEM_FUNCTION Number value(const Number &x) const
  {
    return scale * (1.0 + 2.0 / (power(1.0 + x) - 1.0));
  }

  POTDEM_FUNCTION double slope(double x) const
  {
    const double y = 1.0 + x;
    const double p = power(y) - 1.0;
    return -2.0 * scale * m * (p + 1.0) / (y * p * p);
  }

  // integral of c eps from 1 to x
  POTDEM_FUNCTION double integral(double x) const
  {
    const double dx = x - 1.0;
    if (std::fabs(dx) < small) return small_integral(dx);
    return scale * (dx * dx * (x + 2.0) / 6.0 - std::log(x) / m + smooth(x));
  }

 private:
  static constexpr double x_table = 4.0;
  static constexpr int anchor = nodes / 4;    // the node at x = 1, where S = 0
  static constexpr double step = x_table / nodes;
  // next to x = 1 the energy is of second order and the table's absolute error would show
  static constexpr double small = 0.01;

  int m = 0;
  double scale = 1.0;
  const double *table = nullptr;    // S at the nodes

  // one for each exponent, for as long as the program runs
  static const std::vector<double> &table_of(int exponent)
  {
    static std::map<int, std::vector<double>> tables;
    auto &table = tables[exponent];
    if (table.empty()) table = Penetration(exponent).tabulate();
    return table;
  }

  explicit Penetration(int exponent) : m(exponent) {}

  std::vector<double> tabulate() const
  {
    std::vector<double> nodal(nodes + 1);
    double sum = 0.0;
    for (int k = anchor; k < nodes; k++) {
      nodal[k] = sum;
      sum += quadrature(k * step, (k + 1) * step);
    }
    nodal[nodes] = sum;
    for (int k = anchor - 1; k >= 0; k--)
      nodal[k] = nodal[k + 1] - quadrature(k * step, (k + 1) * step);
    return nodal;
  }

  template <class Number> POTDEM_FUNCTION Number power(const Number &y) const
  {
    Number p = y;
    for (int k = 1; k < m; k++) p *= y;
    return p;
  }

  // S'(x); its two singular terms cancel at x = 0, where the limit is (m - 1)/(2 m)
  POTDEM_FUNCTION double smooth_slope(double x) const
  {
    if (x < 1e-4) return (m - 1.0) / (2.0 * m) + x * series_slope();
    return (x * x - 1.0) / (power(1.0 + x) - 1.0) + 1.0 / (m * x);
  }

  // first-order coefficient of S' about x = 0, from 1/((1+x)^m - 1) = 1/(m x) - (m-1)/(2m)
  // + (m^2-1)/(12 m) x + O(x^2)
  POTDEM_FUNCTION double series_slope() const { return 1.0 / m - (m * m - 1.0) / (12.0 * m); }

  // Gauss-Legendre, five points
  template <class Function> POTDEM_FUNCTION static double gauss(double a, double b, Function f)
  {
    constexpr double at[] = {0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double mid = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = weight[0] * f(mid);
    for (int k = 1; k < 3; k++) sum += weight[k] * (f(mid - half * at[k]) + f(mid + half * at[k]));
    return half * sum;
  }

  POTDEM_FUNCTION double quadrature(double a, double b) const
  {
    return gauss(a, b, [this](double x) {
      return smooth_slope(x);
    });
  }

  // in dx = x - 1, so that nothing cancels
  POTDEM_FUNCTION double small_integral(double dx) const
  {
    return gauss(0.0, dx, [this](double u) {
      return value(1.0 + u) * u * (1.0 + 0.5 * u);
    });
  }

  POTDEM_FUNCTION double smooth(double x) const
  {
    if (x >= x_table) {
      const int pieces = 64 + static_cast<int>(16.0 * (x - x_table));
      const double width = (x - x_table) / pieces;
      double sum = table[nodes];
      for (int k = 0; k < pieces; k++)
        sum += quadrature(x_table + k * width, x_table + (k + 1) * width);
      return sum;
    }
    const int k = static_cast<int>(x / step);
    const double t = x / step - k, u = 1.0 - t;
    return u * u * (1.0 + 2.0 * t) * table[k] + t * t * (1.0 + 2.0 * u) * table[k + 1] +
        step * t * u * (u * smooth_slope(k * step) - t * smooth_slope((k + 1) * step));
  }
};

}    // namespace POTDEM

#endif
