/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the pair styles of this package share: friction, diameters, neighbour list, restart, and the one
   loop over pairs. A style derives from PairPotdem<Law> and reads and mixes its own coefficients.

   A Law is a trivially copyable struct of coefficients (laws/) with
     using Kernel = ...;                       the law made ready for the loop, built once per init
     Kernel kernel() const;
     static double reach(double dbar);         interaction distance for mean diameter dbar
   and a Kernel has evaluate(r, dbar, dref) -> Evaluation, where dref is the contact distance: dbar,
   or less for a pair whose bond failed while it overlapped. */

#ifndef LMP_PAIR_POTDEM_H
#define LMP_PAIR_POTDEM_H

#include "laws/evaluation.h"
#include "laws/friction.h"

#include "pair.h"

#include <vector>

namespace LAMMPS_NS {

class PairPotdemBase : public Pair {
 public:
  PairPotdemBase(class LAMMPS *);
  ~PairPotdemBase() override;
  void init_style() override;
  void settings(int, char **) override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;

 protected:
  std::vector<POTDEM::Friction> friction;    // per pair of types
  std::vector<double> largest_radius;        // per type
  bool sliding;                              // any friction at all
  class PotdemBondStore *bond_store;         // null: no bonds in this simulation

  int at(int itype, int jtype) const { return itype * (atom_types + 1) + jtype; }
  int atom_types;

  virtual void allocate();
  void set_coeff(int ilo, int ihi, int jlo, int jhi, const POTDEM::Friction &);
  void mix_friction(int i, int j);
  double contact_distance(int i, int j, double dbar) const;
  void slide(int i, int j, const POTDEM::Friction &, double normal, const double *del, double r2,
             double *drag) const;
  [[noreturn]] void collapsed(int i, int j, double r2) const;

  // the style's part
  virtual const char *name() const = 0;
  virtual void mix(int i, int j) = 0;
  virtual double reach(int i, int j, double dbar) const = 0;
  virtual POTDEM::Evaluation evaluate(int pair, double r, double dbar, double dref) const = 0;
  virtual void *coeff_data(int pair) = 0;
  virtual std::size_t coeff_size() const = 0;

 private:
  void find_diameters();
  template <class Action> void for_each_coeff(Action);
};

template <class Law> class PairPotdem : public PairPotdemBase {
 public:
  using PairPotdemBase::PairPotdemBase;
  void compute(int, int) override;
  void init_style() override;
  double init_one(int, int) override;

 protected:
  std::vector<Law> laws;
  std::vector<typename Law::Kernel> kernels;

  void allocate() override;
  void set_laws(int ilo, int ihi, int jlo, int jhi, const Law &, const POTDEM::Friction &);
  double reach(int i, int j, double dbar) const override { return laws[at(i, j)].reach(dbar); }
  POTDEM::Evaluation evaluate(int pair, double r, double dbar, double dref) const override
  {
    return kernels[pair].evaluate(r, dbar, dref);
  }
  void *coeff_data(int pair) override { return &laws[pair]; }
  std::size_t coeff_size() const override { return sizeof(Law); }

 private:
  template <bool SLIDE, bool EV> void loop();
};

}    // namespace LAMMPS_NS

#endif
