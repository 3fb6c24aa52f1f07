/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The place of a triangle that is nearest to a point, and on which part of the triangle it lies.

   C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5: which of the seven regions of its plane, seen along the
   normal, the point is in: of the face, of one of the edges or of one of the corners. */

#ifndef POTDEM_TRIANGLE_H
#define POTDEM_TRIANGLE_H

#include "core/geometry/vector3.h"

namespace POTDEM {

struct NearestPlace {
  Vector3 place;
  enum { FACE, EDGE, CORNER } on;
  int which;    // edge k: from corner k to the next
};

// of a triangle whose area is not zero
inline NearestPlace nearest_place(const Vector3 &x, const Vector3 &a, const Vector3 &b,
                                  const Vector3 &c)
{
  const Vector3 ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double ab_a = dot(ab, ax), ac_a = dot(ac, ax);
  if (ab_a <= 0.0 && ac_a <= 0.0) return {a, NearestPlace::CORNER, 0};
  const double ab_b = dot(ab, bx), ac_b = dot(ac, bx);
  if (ab_b >= 0.0 && ac_b <= ab_b) return {b, NearestPlace::CORNER, 1};
  const double of_c = ab_a * ac_b - ab_b * ac_a;
  if (of_c <= 0.0 && ab_a >= 0.0 && ab_b <= 0.0)
    return {add_scaled(a, ab_a / (ab_a - ab_b), ab), NearestPlace::EDGE, 0};
  const double ab_c = dot(ab, cx), ac_c = dot(ac, cx);
  if (ac_c >= 0.0 && ab_c <= ac_c) return {c, NearestPlace::CORNER, 2};
  const double of_b = ab_c * ac_a - ab_a * ac_c;
  if (of_b <= 0.0 && ac_a >= 0.0 && ac_c <= 0.0)
    return {add_scaled(a, ac_a / (ac_a - ac_c), ac), NearestPlace::EDGE, 2};
  const double of_a = ab_b * ac_c - ab_c * ac_b;
  const double to_c = ac_b - ab_b, to_b = ab_c - ac_c;
  if (of_a <= 0.0 && to_c >= 0.0 && to_b >= 0.0)
    return {add_scaled(b, to_c / (to_c + to_b), c - b), NearestPlace::EDGE, 1};
  const double sum = of_a + of_b + of_c;
  return {add_scaled(add_scaled(a, of_b / sum, ab), of_c / sum, ac), NearestPlace::FACE, 0};
}

}    // namespace POTDEM

#endif
