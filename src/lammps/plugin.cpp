/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Entry of the plugin. Only LAMMPS's C library interface is used here, because nothing else is the same
   in all versions: the styles are loaded after the host has been found to be the version that
   they were compiled for. */

#include "lammpsplugin.h"
#include "library.h"
#include "lmptype.h"

#include <cstring>
#include <dlfcn.h>
#include <string>

namespace {

const char *const remedy = "Build the plugin for this LAMMPS: cmake --preset default -D "
                           "LAMMPS_SOURCE_DIR=/path/to/the/sources/of/this/LAMMPS";

void warn(void *lmp, const std::string &text)
{
  if (lammps_extract_setting(lmp, "world_rank") == 0)
    lammps_error(lmp, LMP_ERROR_WARNING,
                 ("POTDEM " POTDEM_VERSION " plugin not loaded: " + text).c_str());
}

bool same_version(void *lmp)
{
  const std::string host = static_cast<const char *>(lammps_extract_global(lmp, "lammps_version"));
  if (host == POTDEM_PLUGIN_LAMMPS_VERSION) return true;
  warn(lmp,
       "it was compiled for LAMMPS version " POTDEM_PLUGIN_LAMMPS_VERSION
       ", this LAMMPS is version " +
           host + ". " + remedy);
  return false;
}

bool same_integers(void *lmp)
{
  if (lammps_extract_setting(lmp, "tagint") == sizeof(LAMMPS_NS::tagint) &&
      lammps_extract_setting(lmp, "bigint") == sizeof(LAMMPS_NS::bigint))
    return true;
  warn(lmp,
       std::string("its integer sizes are not those of this LAMMPS. ") + remedy +
           " and the LAMMPS_SIZES that this LAMMPS was built with (lmp -h shows them)");
  return false;
}

// the one package of LAMMPS, beside its core, without which no style can work
bool has_bonded_particles(void *lmp)
{
  if (lammps_config_has_package("BPM")) return true;
  warn(lmp, "this LAMMPS lacks the package BPM. Build it with -D PKG_BPM=on");
  return false;
}

std::string beside_this_file(const char *name)
{
  Dl_info here;
  dladdr(reinterpret_cast<void *>(&lammpsplugin_init), &here);
  const std::string path = here.dli_fname;
  const auto slash = path.rfind('/');
  return (slash == std::string::npos ? "./" : path.substr(0, slash + 1)) + name;
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  if (!same_version(lmp) || !same_integers(lmp) || !has_bonded_particles(lmp)) return;

  // without the package OPENMP the styles /omp are not registered, and nobody calls what is missing
  const int when = lammps_config_has_package("OPENMP") ? RTLD_NOW : RTLD_LAZY;
  void *styles = dlopen(beside_this_file(POTDEM_PLUGIN_STYLES).c_str(), when | RTLD_LOCAL);
  void *init = styles ? dlsym(styles, "potdem_register_styles") : nullptr;
  if (!init) {
    warn(lmp,
         std::string(dlerror()) +
             ". " POTDEM_PLUGIN_STYLES
             " must lie beside the plugin, and both must be built for this LAMMPS");
    return;
  }
  reinterpret_cast<lammpsplugin_initfunc>(init)(lmp, handle, regfunc);
}
