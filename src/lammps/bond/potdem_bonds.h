/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* potdem_bonds GROUP BTYPE r_infl [diameters] [crack REGION]
   The truss network of a body: every pair of the group within r_infl (thesis 5.2.3). */

#ifndef LMP_POTDEM_BONDS_H
#define LMP_POTDEM_BONDS_H

#include "command.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class PotdemBonds : public Command {
 public:
  PotdemBonds(class LAMMPS *);
  void command(int, char **) override;

 private:
  struct NewBond {
    int i;    // owned atom
    tagint partner;
    double length;    // negative: no bond but a contact of this length
    double area;      // as in FixPotdemBondHistory
  };

  int igroup, btype;
  double reach;
  bool in_diameters;
  std::string crack;
  class Region *region;

  void read(int, char **);
  void check_style();
  void check_atoms();
  void take_over_settings();
  class NeighList *neighbours(double cutoff);
  std::vector<NewBond> find_pairs(class NeighList *);
  bigint count_bonds(const std::vector<NewBond> &) const;
  [[noreturn]] void found_none(double cutoff);
  double shortest_distance(double cutoff);
  bool may_bond(int i, int j) const;
  bool crosses_crack(const double *from, const double *to) const;
  void announce_contacts(const std::vector<NewBond> &);
  void make_room(const std::vector<NewBond> &);
  void grow_bonds_per_atom(int);
  void add(const std::vector<NewBond> &);
  void report(bigint count);
};

}    // namespace LAMMPS_NS

#endif
