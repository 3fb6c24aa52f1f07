/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Contacts of two particles, several at a time: gathered lane by lane, found together, and taken from there one by one, in the order
   in which they came. Where the laws have no branches (Law::wide) the compiler makes vector instructions of the loop over the lanes,
   for the widest registers that the machine has; every lane has the result of the one-lane code, to the last bit. One lane is the
   code for one contact. */

#ifndef POTDEM_CONTACT_BATCH_H
#define POTDEM_CONTACT_BATCH_H

#include "core/contact/contact.h"
#include "core/laws/contact_geometry.h"
#include "core/laws/width.h"

namespace POTDEM {

// has this law of friction a dashpot that may be none?
template <class Law>
constexpr auto has_undamped(int) -> decltype(std::declval<Law>().undamped(), true)
{
  return true;
}
template <class Law> constexpr bool has_undamped(long)
{
  return false;
}

// laws: of each pair of types
template <class Kernel, class Rate, class Tangential> struct PairLaws {
  const Kernel *kernels;
  const Rate *rates;
  const Tangential *rough;

  POTDEM_FUNCTION Rate rate(int pair) const
  {
    if constexpr (std::is_same_v<Rate, Elastic>)
      return {};
    else
      return rates[pair];
  }
  POTDEM_FUNCTION Tangential friction(int pair) const
  {
    if constexpr (std::is_same_v<Tangential, Frictionless>)
      return {};
    else
      return rough[pair];
  }
};

template <class Kernel, class Rate, class Tangential, bool SPIN, int NLANES> struct ContactBatch {
  static constexpr int LANES = NLANES;
  static constexpr int STATE = Tangential::STATE;
  static constexpr bool SLIDE = !std::is_same_v<Tangential, Frictionless>;
  static constexpr bool SPINS = SPIN, ROLL = is_rolling<Tangential>;
  static constexpr bool RATE = !std::is_same_v<Rate, Elastic>;

  // what is gathered
  int pair[LANES];
  double del[3][LANES], r2[LANES], v[3][LANES], wi[3][LANES], wj[3][LANES];
  double ri[LANES], rj[LANES], contact[LANES], mi[LANES], mj[LANES], weight[LANES];
  double state[STATE > 0 ? STATE : 1][LANES];

  // what is found, on the first: the whole force, and of it what is friction and what is viscous
  double push[3][LANES], friction[3][LANES], rolling[3][LANES];
  double turn[3][LANES];    // torque of friction over lever
  double r[LANES], pressing[LANES], viscous[LANES], energy[LANES];

  POTDEM_FUNCTION void find(int l, const Kernel &kernel, const Rate &rate, const Tangential &rough,
                            bool advance, double step, double dt)
  {
    constexpr double spin_share = SPIN ? sliding_mass(1.0, SPHERE_INERTIA) : 1.0;
    const double to[3] = {del[0][l], del[1][l], del[2][l]};
    const double distance = std::sqrt(r2[l]), radius_i = ri[l], radius_j = rj[l];
    const auto motion = [&]() POTDEM_FUNCTION {
      ContactMotion m{{to[0], to[1], to[2]}, distance, {v[0][l], v[1][l], v[2][l]}, {}, {}, {}};
      if constexpr (SPIN) {
        const double first[3] = {wi[0][l], wi[1][l], wi[2][l]},
                     second[3] = {wj[0][l], wj[1][l], wj[2][l]};
        spin_of(first, second, radius_i, radius_j, m);
      }
      return m;
    };
    const auto masses = [&]() POTDEM_FUNCTION {
      const ContactMasses both{spin_share * mi[l] * mj[l], mi[l] + mj[l], step, dt, spin_share};
      if constexpr (is_rolling<Tangential>)
        return with_rolling(both, mi[l], mj[l], radius_i, radius_j);
      else
        return both;
    };
    double remembered[STATE > 0 ? STATE : 1];
    for (int k = 0; k < STATE; k++) remembered[k] = state[k][l];
    const auto found =
        contact_forces<SPIN>(kernel, distance, ContactGeometry{radius_i, radius_j, contact[l]},
                             weight[l], rate, rough, remembered, advance, motion, masses);
    for (int k = 0; k < STATE; k++) state[k][l] = remembered[k];

    // that of a slide is at hand
    const double along = STATE > 0 ? found.normal * (1.0 / distance) : found.normal / distance;
    r[l] = distance;
    pressing[l] = found.pressing;
    viscous[l] = found.viscous;
    energy[l] = found.elastic.energy;
    for (int k = 0; k < 3; k++) push[k][l] = along * to[k];
    if constexpr (SLIDE) {
      for (int k = 0; k < 3; k++) {
        friction[k][l] = found.surface.friction[k];
        push[k][l] += found.surface.friction[k];
      }
      if constexpr (SPIN) {
        double torque[3];
        torque_over_lever(to, found.surface.friction, torque);
        const double inverse = 1.0 / (radius_i + radius_j);
        for (int k = 0; k < 3; k++) turn[k][l] = inverse * torque[k];
      }
      if constexpr (is_rolling<Tangential>)
        for (int k = 0; k < 3; k++) rolling[k][l] = found.surface.torque[k];
    }
  }

  POTDEM_FUNCTION void find_lanes(const Kernel &kernel, const Rate &rate, const Tangential &rough,
                                  bool advance, double step, double dt)
  {
// what one pass writes no other one reads
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#elif defined(__GNUC__)
#pragma GCC ivdep
#endif
    for (int l = 0; l < LANES; l++) find(l, kernel, rate, rough, advance, step, dt);
  }

  // all lanes have the laws of the first one's pair of types
  POTDEM_FUNCTION void find_alike(const PairLaws<Kernel, Rate, Tangential> &laws, double step,
                                  double dt)
  {
    const Kernel kernel = laws.kernels[pair[0]];
    const Rate rate = laws.rate(pair[0]);
    const Tangential rough = laws.friction(pair[0]);
    if constexpr (has_undamped<Tangential>(0))
      if (rough.xi == 0.0) return find_lanes(kernel, rate, rough.undamped(), true, step, dt);
    find_lanes(kernel, rate, rough, true, step, dt);
  }

  POTDEM_FUNCTION void find_one(int l, const PairLaws<Kernel, Rate, Tangential> &laws, bool advance,
                                double step, double dt)
  {
    find(l, laws.kernels[pair[l]], laws.rate(pair[l]), laws.friction(pair[l]), advance, step, dt);
  }

  void find_each(const PairLaws<Kernel, Rate, Tangential> &laws, bool advance, double step,
                 double dt)
  {
    for (int l = 0; l < LANES; l++) find_one(l, laws, advance, step, dt);
  }

#ifdef POTDEM_WIDE_CODE
  POTDEM_AVX2 void find_avx2(const PairLaws<Kernel, Rate, Tangential> &laws, double step, double dt)
  {
    find_alike(laws, step, dt);
  }
  POTDEM_AVX512 void find_avx512(const PairLaws<Kernel, Rate, Tangential> &laws, double step,
                                 double dt)
  {
    find_alike(laws, step, dt);
  }
#endif

  // a full batch: lanes that are not in use have the values of earlier contacts
  POTDEM_FUNCTION void find_all(Width width, const PairLaws<Kernel, Rate, Tangential> &laws,
                                bool advance, double step, double dt)
  {
    if constexpr (LANES == 1) return find_one(0, laws, advance, step, dt);
    bool alike = advance;
    for (int l = 1; l < LANES; l++) alike = alike && pair[l] == pair[0];
    if (!alike) return find_each(laws, advance, step, dt);
#ifdef POTDEM_WIDE_CODE
    if (width == Width::AVX512) return find_avx512(laws, step, dt);
    if (width == Width::AVX2) return find_avx2(laws, step, dt);
#endif
    find_alike(laws, step, dt);
  }
};

}    // namespace POTDEM

#endif
