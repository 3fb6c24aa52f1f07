/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the pair styles of this package share: friction, rotation, diameters, neighbour list, restart, and the
   one loop over pairs (potdem_pair_loop.h). A style derives from PairPotdem<Law> and reads, mixes and prints
   its own coefficients.

   A Law is a trivially copyable struct of coefficients (laws/) with
     Kernel kernel(bool shift) const           the law made ready for the loop, once per init
     double reach(double dbar) const           interaction distance for mean diameter dbar
     touching                                  reach is dbar: the short neighbour list by diameters will do
     rated                                     Kernel has with_rate(force, r, pairing, dr/dt)
   and a Kernel has evaluate(r, pairing) -> Evaluation and core(pairing), the distance that must not be
   reached. */

#ifndef LMP_PAIR_POTDEM_H
#define LMP_PAIR_POTDEM_H

#include "laws/evaluation.h"
#include "laws/friction.h"
#include "laws/pairing.h"

#include "pair.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class PotdemInput;

class PairPotdemBase : public Pair {
 public:
  PairPotdemBase(class LAMMPS *);
  ~PairPotdemBase() override;
  void init_style() override;
  void settings(int, char **) override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  void write_data(FILE *) override;
  void write_data_all(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;

 protected:
  std::vector<POTDEM::Friction> friction;    // per pair of types
  std::vector<double> largest_radius;        // per type
  bool sliding;                              // any friction at all
  int rotation;
  class PotdemLedger *ledger;           // null: no compute potdem/energy
  class PotdemBondStore *bond_store;    // null: no bonds in this simulation

  int at(int itype, int jtype) const { return itype * (atom_types + 1) + jtype; }
  int atom_types;

  virtual void allocate();
  void set_coeff(int ilo, int ihi, int jlo, int jhi, const POTDEM::Friction &);
  POTDEM::Pairing pairing(int i, int j) const;

  // two particles that slide on each other: del = x_i - x_j, r its length
  struct Touch {
    int i, j;
    const double *del;
    double r;
  };
  double rate(const Touch &) const;                                       // dr/dt
  void note(int kind, const Touch &, double fx, double fy, double fz);    // dissipative force on i
  void slide(const Touch &, const POTDEM::Friction &, double normal, double *drag);
  [[noreturn]] void cannot_mix(int i, int j, const std::string &coefficient) const;
  [[noreturn]] void collapsed(int i, int j, double r, double core) const;

  // the style's part
  virtual const char *name() const = 0;
  virtual bool read_setting(PotdemInput &) { return false; }
  virtual const char *setting_names() const { return "rotation"; }
  virtual int *extra_setting() { return nullptr; }    // one flag of the style, for restart files
  virtual void mix(int i, int j) = 0;
  virtual std::string coeff_text(int pair) const = 0;    // as pair_coeff takes it, without friction
  virtual bool touching() const = 0;
  virtual bool needs_velocity() const = 0;
  virtual double reach(int i, int j, double dbar) const = 0;
  virtual double core(int pair, const POTDEM::Pairing &) const = 0;
  virtual POTDEM::Evaluation evaluate(int pair, double r, const POTDEM::Pairing &) const = 0;
  virtual void *coeff_data(int pair) = 0;
  virtual std::size_t coeff_size() const = 0;

 private:
  void find_diameters();
  void mix_friction(int i, int j);
  void slide_velocity(const Touch &, double *u) const;
  void twist(const Touch &, const double *drag);
  void write_coeff(FILE *, const std::string &types, int pair) const;
  template <class Action> void for_each_setting(Action);
  template <class Action> void for_each_coeff(Action);
  void read_item(void *data, std::size_t size, FILE *);
};

template <class Law> class PairPotdem : public PairPotdemBase {
 public:
  using PairPotdemBase::PairPotdemBase;
  void compute(int, int) override;
  void coeff(int, char **) override;
  double init_one(int, int) override;

 protected:
  std::vector<Law> laws;
  std::vector<typename Law::Kernel> kernels;

  virtual void prepare(Law &) const {}    // what pair_style itself says about a law
  void allocate() override;
  std::string coeff_text(int pair) const override;
  bool touching() const override { return Law::touching; }
  bool needs_velocity() const override;
  double reach(int i, int j, double dbar) const override { return laws[at(i, j)].reach(dbar); }
  double core(int pair, const POTDEM::Pairing &pairing) const override
  {
    return kernels[pair].core(pairing);
  }
  POTDEM::Evaluation evaluate(int pair, double r, const POTDEM::Pairing &pairing) const override
  {
    return kernels[pair].evaluate(r, pairing);
  }
  void *coeff_data(int pair) override { return &laws[pair]; }
  std::size_t coeff_size() const override { return sizeof(Law); }

 private:
  template <bool EV> void choose();
  template <bool SLIDE, bool RATE, bool EV> void loop();
};

}    // namespace LAMMPS_NS

#endif
