/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Four numbers at once, in one register where the machine has such (AVX), in two or four elsewhere: the same operations on
   each in any case, and so the same bits. They are the vectors of GCC and clang, which know + - * / and comparisons of them. */

#ifndef POTDEM_FOUR_H
#define POTDEM_FOUR_H

#include "device.h"

#include <cmath>
#include <cstring>

#if defined(__GNUC__) && !defined(__CUDACC__)
#define POTDEM_HAS_FOUR 1
#endif

namespace POTDEM {

POTDEM_FUNCTION inline double square_root(double a)
{
  return std::sqrt(a);
}

POTDEM_FUNCTION inline double sum(double a)
{
  return a;
}

// what a function of one number has for one, or for each of four
template <class Function> POTDEM_FUNCTION inline double of_each(double a, const Function &function)
{
  return function(a);
}

#ifdef POTDEM_HAS_FOUR

// these vectors are only passed between functions that are inlined: no ABI is concerned
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

typedef double Two __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(32)));

POTDEM_FUNCTION inline Four square_root(const Four &a)
{
  Four root;
  for (int m = 0; m < 4; m++) root[m] = std::sqrt(a[m]);
  return root;
}

template <class Function>
POTDEM_FUNCTION inline Four of_each(const Four &a, const Function &function)
{
  Four found;
  for (int m = 0; m < 4; m++) found[m] = function(a[m]);
  return found;
}

// in a row in memory
template <class Vector> POTDEM_FUNCTION inline Vector read_vector(const double *from)
{
  Vector found;
  std::memcpy(&found, from, sizeof found);
  return found;
}

// of a comparison
template <class Mask> POTDEM_FUNCTION inline bool any(const Mask &mask)
{
  return mask[0] | mask[1] | mask[2] | mask[3];
}

// vectors in space
struct Four3 {
  Four x, y, z;

  Four3() = default;
  // rows p[0] to p[3] of an array, less `from`: three columns
  template <int COLUMNS>
  POTDEM_FUNCTION Four3(const double (*rows)[COLUMNS], const int *p, const double *from)
  {
    const Two a = read_vector<Two>(rows[p[0]]), b = read_vector<Two>(rows[p[1]]),
              c = read_vector<Two>(rows[p[2]]), d = read_vector<Two>(rows[p[3]]);
    x = Four{a[0], b[0], c[0], d[0]} - from[0];
    y = Four{a[1], b[1], c[1], d[1]} - from[1];
    z = Four{rows[p[0]][2], rows[p[1]][2], rows[p[2]][2], rows[p[3]][2]} - from[2];
  }
  POTDEM_FUNCTION Four dot(const Four3 &other) const
  {
    return x * other.x + y * other.y + z * other.z;
  }
  POTDEM_FUNCTION void operator*=(const Four &scale)
  {
    x *= scale;
    y *= scale;
    z *= scale;
  }
  POTDEM_FUNCTION void operator+=(const Four3 &other)
  {
    x += other.x;
    y += other.y;
    z += other.z;
  }
};

POTDEM_FUNCTION inline double sum(const Four &a)
{
  return a[0] + a[1] + a[2] + a[3];
}

#pragma GCC diagnostic pop

#endif

}    // namespace POTDEM

#endif
