/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the pair styles of this package share whatever their law: sizes of particles, what contacts remember, the ledger and
   the monitor. The style itself is PairPotdem<Law> (pair_potdem.h). */

#ifndef LMP_PAIR_POTDEM_BASE_H
#define LMP_PAIR_POTDEM_BASE_H

#include "core/laws/contact_geometry.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/output/fix_potdem_ledger.h"

#include "pair.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairPotdemBase :
    public PotdemCompat::PairWithCutoffsBySize,
    public StiffnessSource,
    public EnergySource,
    public SizedReach,
    public ContactMemory,
    public MonitorUser {
 public:
  PairPotdemBase(class LAMMPS *);
  ~PairPotdemBase() override;

  bool outgrown() const override;
  void find_sizes() override;
  double reach_per_size() const override;
  void expect_contacts(const std::vector<PotdemNewContact> &) override;
  void lose_contacts() override;
  void lose_monitor() override { monitor = nullptr; }

  double atom2cut(int) override;
  double radii2cut(double, double) override;

 protected:
  std::vector<double> largest_radius;    // per type
  std::vector<double> least_radius, least_mass;
  int rotation;
  class FixPotdemLedger *ledger;        // null: no compute potdem/energy
  class FixPotdemContacts *contacts;    // null: nothing to remember
  class FixPotdemMonitor *monitor;      // null: nothing to warn of
  int atom_types;

  // the part of the list that one thread does, where its forces go, and what it found
  struct ThreadShare {
    int from, to;
    double **f, **torque;
    class ThrData *thread;                   // null: no threads
    double energy = 0.0;                     // where nothing else is asked for
    int i = -1, j = -1;                      // a pair that has collapsed
    int doubtful_i = -1, doubtful_j = -1;    // one too deep or too stiff for the step
  };

  static ThreadShare share(int from, int to, double **f, double **torque, class ThrData *thread)
  {
    return {from, to, f, torque, thread};
  }

  // the style's part
  virtual const char *name() const = 0;
  virtual double reach(int itype, int jtype, double dbar) const = 0;
  // where the forces and energies of a pair are summed up, and whose they are (threads have their own)
  virtual void tally(const ThreadShare &, int i, int j, const double *del, double energy,
                     const double *f);

  int at(int itype, int jtype) const { return itype * (atom_types + 1) + jtype; }
  void require_particles(bool contact_only, bool sliding, bool viscous);
  void find_contacts(int state);    // numbers that a contact remembers beside where it begins
  POTDEM::ContactGeometry geometry(int i, int j) const;
  POTDEM::ContactGeometry geometry(int i, int j, double begins) const;
  const double *remembered(int i, int j, bool &turned) const;
  void note(FixPotdemLedger::Kind, int i, int j, const double *f) const;
  void note_torque(int i, int j, double lever_i, double lever_j, const double *turn) const;
  double distance(int i, int j) const;
  double without_particles() const;
  [[noreturn]] void cannot_mix(int i, int j, const std::string &coefficient) const;
  [[noreturn]] void collapsed(int i, int j, double hard_core) const;

 private:
  std::string contacts_id;
  bool lost_contacts;

  void add_announced_radii(std::vector<double> &largest) const;
};

}    // namespace LAMMPS_NS

#endif
