/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Registers the styles of the table potdem_styles.h with the LAMMPS that loads the plugin. */

#include "lammps/potdem_styles.h"

#include "lammpsplugin.h"
#include "library.h"

#include "bond.h"
#include "command.h"
#include "compute.h"
#include "fix.h"
#include "pair.h"
#include "region.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace {

template <class Base, class Style> Base *create(LAMMPS *lmp)
{
  return new Style(lmp);
}

template <class Base, class Style> Base *create_with_args(LAMMPS *lmp, int narg, char **arg)
{
  return new Style(lmp, narg, arg);
}

class Registration {
 public:
  Registration(void *lmp, void *handle, void *regfunc) :
      lmp(lmp), handle(handle), regfunc(reinterpret_cast<lammpsplugin_regfunc>(regfunc)),
      openmp(lammps_config_has_package("OPENMP"))
  {
  }

  template <class Base>
  void add(const char *style, const char *name, Base *(*creator)(LAMMPS *) ) const
  {
    auto plugin = entry(style, name);
    plugin.creator.v1 = reinterpret_cast<lammpsplugin_factory1 *>(creator);
    show(plugin);
  }

  template <class Base>
  void add(const char *style, const char *name, Base *(*creator)(LAMMPS *, int, char **) ) const
  {
    auto plugin = entry(style, name);
    plugin.creator.v2 = reinterpret_cast<lammpsplugin_factory2 *>(creator);
    show(plugin);
  }

 private:
  lammpsplugin_t entry(const char *style, const char *name) const
  {
    lammpsplugin_t plugin{};
    plugin.version = POTDEM_PLUGIN_LAMMPS_VERSION;
    plugin.style = style;
    plugin.name = name;
    plugin.info = name;
    plugin.author = "POTDEM " POTDEM_VERSION;
    plugin.handle = handle;
    return plugin;
  }

  void show(lammpsplugin_t &plugin) const
  {
    if (openmp || !utils::strmatch(plugin.name, "/omp$")) regfunc(&plugin, lmp);
  }

  void *lmp, *handle;
  lammpsplugin_regfunc regfunc;
  bool openmp;    // a package of this LAMMPS
};

}    // namespace

extern "C" void potdem_register_styles(void *lmp, void *handle, void *regfunc)
{
  const Registration registration(lmp, handle, regfunc);

#define PairStyle(key, Class) registration.add("pair", #key, &create<Pair, Class>)
#define BondStyle(key, Class) registration.add("bond", #key, &create<Bond, Class>)
#define CommandStyle(key, Class) registration.add("command", #key, &create<Command, Class>)
#define FixStyle(key, Class) registration.add("fix", #key, &create_with_args<Fix, Class>)
#define RegionStyle(key, Class) registration.add("region", #key, &create_with_args<Region, Class>)
#define ComputeStyle(key, Class) \
  registration.add("compute", #key, &create_with_args<Compute, Class>)

#define PAIR_CLASS
#include "lammps/potdem_styles.h"
#undef PAIR_CLASS
#define BOND_CLASS
#include "lammps/potdem_styles.h"
#undef BOND_CLASS
#define FIX_CLASS
#include "lammps/potdem_styles.h"
#undef FIX_CLASS
#define COMPUTE_CLASS
#include "lammps/potdem_styles.h"
#undef COMPUTE_CLASS
#define COMMAND_CLASS
#include "lammps/potdem_styles.h"
#undef COMMAND_CLASS
#define REGION_CLASS
#include "lammps/potdem_styles.h"
#undef REGION_CLASS
}
