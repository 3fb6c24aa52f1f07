/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* potdem_bonds GROUP BTYPE r_infl [diameters] [crack REGION]
   The truss network of a body: every pair of the group within r_infl (thesis 5.2.3). */

#ifndef LMP_POTDEM_BONDS_H
#define LMP_POTDEM_BONDS_H

#include "lammps/glue/interfaces.h"

#include "command.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class PotdemBonds : public Command {
 public:
  PotdemBonds(class LAMMPS *);
  void command(int, char **) override;

 private:
  int igroup, btype;
  double reach;
  bool in_diameters;
  std::string crack;
  class Region *region;
  std::vector<PotdemNewContact> contacts;    // pairs that the crack cuts

  void check_reach(double cutoff) const;
  void read(int, char **);
  void check_style();
  void check_atoms();
  void take_over_settings();
  class NeighList *neighbours(double cutoff);
  bigint keep_bonds(class NeighList *);
  bool will_bond(int i, int j);
  double distance(int i, int j) const;
  [[noreturn]] void found_none(double cutoff);
  double shortest_distance(double cutoff);
  bool may_bond(int i, int j) const;
  bool crosses_crack(int i, int j) const;
  void make_room(const class NeighList *);
  void grow_bonds_per_atom(int);
  void add(const class NeighList *);
  void report(bigint count);
};

}    // namespace LAMMPS_NS

#endif
