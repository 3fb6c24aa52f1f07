/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Vectors in space, of any unit. */

#ifndef POTDEM_VECTOR3_H
#define POTDEM_VECTOR3_H

#include <array>

namespace POTDEM {

typedef std::array<double, 3> Vector3;

inline Vector3 operator-(const Vector3 &a, const Vector3 &b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Vector3 &a, const Vector3 &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3 &a, const Vector3 &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector3 add_scaled(const Vector3 &a, double s, const Vector3 &b)
{
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

}    // namespace POTDEM

#endif
