/* A sphere and a flat wall under any of the pair laws (thesis 5.3: "the particle-boundary phenomenon can be
   described by the same potentials"): the wall is a particle without extent on the surface, so that the mean
   diameter of the pair is the sphere's radius ri and contact begins at the distance ri. Lengths of the law (R, the
   cut) are measured as between particles; alpha and x are fractions of ri. */

#ifndef POTDEM_WALL_H
#define POTDEM_WALL_H

#include "hertz_wall.h"
#include "regularised_granular.h"
#include "shifted_lj.h"
#include "truss_contact.h"

namespace POTDEM {

// distance: of the sphere's centre from the surface
template <class Law> struct LawWall {
  Law law;
  typename Law::Kernel kernel;

  static constexpr bool viscous = false;

  double reach(double ri) const { return law.reach(ri); }
  double hard_core(double ri) const { return kernel.hard_core(partners(ri)); }
  Evaluation evaluate(double distance, double ri) const
  {
    return kernel.evaluate(distance, partners(ri));
  }

 private:
  static ContactGeometry partners(double ri) { return {ri, 0.0, ri}; }
};

// Hertz under its soft layer
struct LayeredHertzWall {
  HertzWall law;

  static constexpr bool viscous = true;

  double reach(double ri) const { return ri + law.thickness(ri); }
  static double hard_core(double) { return 0.0; }
  Evaluation evaluate(double distance, double ri) const
  {
    return law.evaluate(reach(ri) - distance, ri);
  }
};

}    // namespace POTDEM

#endif
