/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the contacts of a pair style remember, in LAMMPS's own FixNeighHistory, which carries it through exchange,
   sorting, rebuilds of lists and restart files. One for each pair style whose contacts have something to remember,
   made at its init; it outlives a pair_style that is given again. Of each pair: the distance at which its law begins (0: where
   the two touch), then what the tangential law remembers while they touch.

   A contact that begins otherwise than by touch (the pair of a bond that failed, or that a crack cuts) is announced with what
   it is to remember, on the ranks that own one of the two. It remembers the distance for good: LAMMPS forgets pairs that leave
   the neighbour list, so those are kept with their particles meanwhile. */

#ifndef LMP_FIX_POTDEM_CONTACTS_H
#define LMP_FIX_POTDEM_CONTACTS_H

#include "lammps/glue/interfaces.h"

#include "fix_neigh_history.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class FixPotdemContacts : public FixNeighHistory {
 public:
  // a place among the fixes for the pair style that is being made: LAMMPS wants histories before fixes that
  // migrate particles. Returns the ID that it may have
  static std::string reserve(LAMMPS *);
  static void release(LAMMPS *,
                      const std::string &id);    // the pair style goes, what is remembered stays
  // state: numbers of the tangential law
  static FixPotdemContacts *ensure(LAMMPS *, const std::string &id, class Pair *, int state);

  FixPotdemContacts(LAMMPS *, int, char **);
  ~FixPotdemContacts() override;
  void init() override;
  void pre_exchange() override;
  void post_neighbor() override;
  void setup(int) override { stored = false; }
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  void unpack_restart(int, int) override;

  void expect(const std::vector<PotdemNewContact> &);

  bool any() const { return remembering > 0 || dnum > 1; }
  bool has_state() const { return dnum > 1; }
  // of the pair in place jj of the list of particle i: the distance, then the state. Null: it remembers nothing
  const double *memory(int i, int jj) const
  {
    return firstflag[i][jj] ? firstvalue[i] + dnum * static_cast<bigint>(jj) : nullptr;
  }

  // of the pairs in the list of a particle
  struct Row {
    int *flags = nullptr;
    double *values = nullptr;
    int width = 0;

    double *of(int jj) const { return values + width * static_cast<bigint>(jj); }
    // distance at which the law begins; 0: where the two touch
    double begins(int jj) const { return flags[jj] ? *of(jj) : 0.0; }
    // a pair that touches: its state, which begins with zeros
    double *touch(int jj) const
    {
      double *const mine = of(jj);
      if (!flags[jj]) std::fill_n(mine, width, 0.0);
      flags[jj] = 1;
      return mine + 1;
    }
    // one that does not
    void part(int jj) const
    {
      if (!flags[jj]) return;
      double *const mine = of(jj);
      std::fill_n(mine + 1, width - 1, 0.0);
      flags[jj] = *mine != 0.0;
    }
  };
  Row row(int i) const { return {firstflag[i], firstvalue[i], dnum}; }

 protected:
  void pre_exchange_newton() override;

 private:
  // of pairs that are not in this rank's list: owned particle and partner
  std::map<std::pair<int, tagint>, double> aside;
  bool
      stored;    // with the particles, as between runs and in a rebuild; else with the neighbour list
  bigint remembering;    // contacts of this rank's list, at most

  // of what the file that was read has of its contacts: how many, how wide, and their checksum; none: none was read, or it is checked
  std::vector<double> in_file;

  struct Kept {
    int i;    // owned particle
    tagint partner;
    std::vector<double> values;
  };

  std::vector<Kept> all_kept() const;
  void add_kept(const std::vector<Kept> &);
  std::vector<double> sum_kept() const;
  void check_kept();
  bool pages_will_change() const;
  void give_to_particles();
  bool set_listed(int i, tagint, double distance);
  void keep_aside(int i, tagint, double distance);
  void set_aside();
  void add_aside();
  int place_of_partner(int i, tagint) const;
  void set_partner(int i, tagint, double distance);
  double *add_partner(int i, tagint);    // its values, all 0
};

}    // namespace LAMMPS_NS

#endif
