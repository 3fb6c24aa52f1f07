/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the contacts of a pair style remember, in LAMMPS's own FixNeighHistory, which carries it through exchange,
   sorting, rebuilds of lists and restart files. One for each pair style whose contacts have something to remember,
   made at its init; it outlives a pair_style that is given again.

   A contact that begins otherwise than by touch (the pair of a bond that failed, or that a crack cuts) is announced with what
   it is to remember, on all ranks, and is in the lists from the next rebuild on. It remembers for good: LAMMPS forgets pairs
   that leave the neighbour list, so those are kept with their particles meanwhile. */

#ifndef LMP_FIX_POTDEM_CONTACTS_H
#define LMP_FIX_POTDEM_CONTACTS_H

#include "lammps/glue/interfaces.h"

#include "fix_neigh_history.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixPotdemContacts : public FixNeighHistory {
 public:
  // a place among the fixes for the pair style that is being made: LAMMPS wants histories before fixes that
  // migrate particles. Returns the ID that it may have
  static std::string reserve(LAMMPS *);
  static void release(LAMMPS *,
                      const std::string &id);    // the pair style goes, what is remembered stays
  static FixPotdemContacts *ensure(LAMMPS *, const std::string &id, class Pair *);

  FixPotdemContacts(LAMMPS *, int, char **);
  ~FixPotdemContacts() override;
  void init() override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void post_neighbor() override;
  void post_run() override;
  void write_restart(FILE *) override;

  void expect(const std::vector<PotdemNewContact> &);

  // of the pair in place jj of the list of particle i: 0 if it remembers nothing
  bool any() const { return remembering > 0; }
  double distance(int i, int jj) const { return firstflag[i][jj] ? firstvalue[i][jj] : 0.0; }

 protected:
  void pre_exchange_newton() override;

 private:
  std::vector<PotdemNewContact> expected;    // the same on all ranks
  struct Aside {
    int i;    // owned particle
    tagint partner;
    double distance;
  };
  std::vector<Aside> aside;    // of pairs that are not in this rank's list
  bool stored;                 // with the particles, as between runs; else with the neighbour list
  bigint remembering;          // contacts of this rank's list, at most

  bool pages_will_change() const;
  void add_expected();
  void set_aside();
  void add_aside();
  int place_of_partner(int i, tagint) const;
  void set_partner(int i, tagint, double distance);
  void add_partner(int i, tagint, double distance);
};

}    // namespace LAMMPS_NS

#endif
