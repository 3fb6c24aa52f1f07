/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What a bond remembers: its reference length and what its law keeps of it, in LAMMPS's own FixBondHistory (which carries
   them through exchange, sorting and restart); its area in another one, only where areas are found, its part in the change of
   volume in a third one, only where Poisson's ratio is given, and its damage in a fourth one, only where cracks cost an energy. A bond that fails is
   gone, from here and from LAMMPS's lists. Created by potdem_bonds or a bond style, one per simulation. */

#ifndef LMP_FIX_POTDEM_BOND_HISTORY_H
#define LMP_FIX_POTDEM_BOND_HISTORY_H

#include "core/laws/law_list.h"
#include "core/laws/softening.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_pair_lists.h"

#include "fix_bond_history.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

// values of each bond that nobody needs in the order of LAMMPS's list
class FixPotdemBondValues : public FixBondHistory {
 public:
  FixPotdemBondValues(LAMMPS *lmp, int narg, char **arg) : FixBondHistory(lmp, narg, arg) {}
  int setmask() override { return 0; }
  virtual std::string gone() const;    // ID of a fix that it needs and that was taken away

  // all columns of a bond, a struct of as many doubles
  template <class Row> void put(int i, int slot, const Row &row)
  {
    static_assert(sizeof(Row) % sizeof(double) == 0, "a row of doubles");
    const auto *const values = reinterpret_cast<const double *>(&row);
    for (int k = 0; k < ndata; k++) update_atom_value(i, slot, k, values[k]);
  }
  template <class Row> Row get(int i, int slot)
  {
    static_assert(sizeof(Row) % sizeof(double) == 0, "a row of doubles");
    Row row;
    auto *const values = reinterpret_cast<double *>(&row);
    for (int k = 0; k < ndata; k++) values[k] = get_atom_value(i, slot, k);
    return row;
  }
};

class FixPotdemBondHistory : public FixPotdemBondValues {
 public:
  // columns. LENGTH: reference length; 0: not measured yet. STATE: the first of those that laws keep, all 0 at first
  enum { LENGTH, STATE };
  static constexpr int NSTATE = POTDEM::most_bond_state(), NDATA = STATE + NSTATE;

  static FixPotdemBondHistory *find(LAMMPS *);
  static FixPotdemBondHistory *create(LAMMPS *);
  // error if there was one that is gone; who: the style, for errors
  static FixPotdemBondHistory *ensure(LAMMPS *, const std::string &who = "bond_style potdem/truss");
  static FixPotdemBondHistory *get(LAMMPS *, const std::string &who);    // error if there is none

  FixPotdemBondHistory(LAMMPS *, int, char **);
  ~FixPotdemBondHistory() override;
  int setmask() override;
  void init() override;
  void pre_exchange() override;
  void min_pre_exchange() override;
  void post_run() override;
  void setup_pre_neighbor() override;
  void pre_neighbor() override;
  void min_pre_neighbor() override;
  void setup_post_neighbor() override;
  void post_neighbor() override;
  void min_post_neighbor() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  std::string gone() const override;

  // area: the section that was found for a bond once, by area body (> 0) or by area lattice (< 0, its negative); 0: none
  // yet. It stays, whatever becomes of the body and whatever bond_coeff says again
  void keep_areas();
  bool keeps_areas() const { return areas; }
  void store(int i, int slot, double length);
  void store_area(int i, int slot, double area) { areas->update_atom_value(i, slot, 0, area); }
  // what a bond counts in the dilatations of its own atom and of the other one (core/areas/dilatation.h), times the roots of their
  // volumes, and 1 + nu of the solid that it is of; 0: none is found
  struct Dilatation {
    double own, other, solid;
  };
  void keep_dilatations();
  bool keeps_dilatations() const { return dilatations; }
  void store_dilatation(int i, int slot, const Dilatation &one) { dilatations->put(i, slot, one); }
  Dilatation dilatation(int i, int slot) const
  {
    return dilatations ? dilatations->get<Dilatation>(i, slot) : Dilatation{};
  }
  // what a crack that opens has done to it; the same at both ends, up to rounding
  void keep_softening();
  bool keeps_softening() const { return softenings; }
  void store_softening(int i, int slot, const POTDEM::Softening &law)
  {
    softenings->put(i, slot, law);
  }
  POTDEM::Softening softening(int i, int slot) const
  {
    return softenings ? softenings->get<POTDEM::Softening>(i, slot) : POTDEM::Softening();
  }

  double length(int i, int slot) const { return values()[i][slot * NDATA + LENGTH]; }
  double area(int i, int slot) const { return areas ? areas->get_atom_value(i, slot, 0) : 0.0; }
  double *state(int i, int slot) const { return &values()[i][slot * NDATA + STATE]; }

  bool is_new(int i, int slot) const;    // a live bond without a reference length
  bool has_new_bonds() const;            // on this rank
  double longest() const;    // largest reference length on any rank; of new bonds, the present one
  int slot(int i, tagint partner) const;    // bond of owned atom i with this partner, or -1
  bigint measure_new_bonds();      // they get the present length; how many there were on this rank
  void remove(int i, int slot);    // bond of owned atom i

  // pairs of bonds that failed since the last rebuild
  PotdemPairLists parted;
  // pairs that a crack cuts, until the pair styles have taken them
  std::vector<PotdemNewContact> new_contacts;

  // per-particle values, `width` of them, from the owners to all copies
  void allow_exchange(int width);    // before Comm::init
  void forward(double *values, int width);
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;

  int generation;    // counts rebuilds of the bond list, so that its readers know theirs is old
  // the communication cutoff that bonds need, if the user has not set one; < 0: none
  double ghost_cutoff, widest;
  bool follows_bonds() const;
  void reach_at_most(double cutoff);

 private:
  FixPotdemBondValues *areas, *dilatations, *softenings;    // null where there are none
  std::vector<int> all_types;    // FixBondHistory asks which types it serves: all
  double *exchanged;
  int exchanged_width;
  bigint natoms_then;    // particles in the simulation when bonds were looked at last

  // of what the file that was read has of its bonds: how many ends, their checksum, and how many have softened; none: none was read, or it
  // is checked
  std::vector<double> in_file;

  double **values() const;
  FixPotdemBondValues *values_of(const char *id_of_fix, int columns);
  std::vector<double> ends_and_sum() const;
  double softened_ends() const;
  void check_values();
  double longest_new_bond() const;
  bool is_periodic() const;
  double longest_now() const;
  void look_after_removals();
  void refuse_lost_ends(bool all_reached) const;
  void acquire_ghosts();
};

}    // namespace LAMMPS_NS

#endif
