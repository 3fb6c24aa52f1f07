/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* libFuzzer against the package in a LAMMPS that goes on after errors: whatever is in a material file, in the arguments of a command,
   or in a sequence of commands, there is an error or a result, and no crash. POTDEM_FUZZ says which of the three; POTDEM_FUZZ_PLUGIN
   is the plugin, compiled with the sanitizers, if it is not the LAMMPS that has the styles.

   Without libFuzzer (POTDEM_FUZZ_ALONE) the program takes the files that it is given and, after the number that comes first, as many
   inputs that are made of them by chance, the same in every run: a short run for the tests. The last one is in the file input. */

#include "library.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

void *lmp = nullptr;
std::string kind;

// commands in lines, up to one that fails; POTDEM_FUZZ_SHOW: they are shown, and what fails
bool run(const std::string &commands)
{
  static const bool show = std::getenv("POTDEM_FUZZ_SHOW");
  std::istringstream lines(commands);
  for (std::string command; std::getline(lines, command);) {
    if (show) fprintf(stderr, "%s\n", command.c_str());
    lammps_command(lmp, command.c_str());
    if (!lammps_has_error(lmp)) continue;
    char message[512];
    lammps_get_last_error_message(lmp, message, sizeof(message));
    if (show) fprintf(stderr, "  %s\n", message);
    return false;
  }
  return true;
}

// a body of 3 x 3 x 3 particles of two types, bonded, with a wall; every command of the package has something to work on
const char *const BODY[] = {"units si",
                            "atom_style bpm/sphere",
                            "boundary f f f",
                            "region box block -9 9 -9 9 -9 9 units box",
                            "create_box 2 box bond/types 2",
                            "neighbor 0.3 bin",
                            "lattice sc 1.0",
                            "region body block -1 1 -1 1 -1 1 units box",
                            "create_atoms 1 region body",
                            "set group all diameter 1.0",
                            "set group all density 1.0",
                            "pair_style potdem/truss",
                            "pair_coeff * * 100 0.5",
                            "bond_style potdem/truss",
                            "bond_coeff * 100 area factor 0.5",
                            "potdem_bonds all 1 1.2",
                            "region floor plane 0 0 -3 0 0 1 units box",
                            "timestep 1e-3",
                            "fix move all nve"};

void begin(bool body)
{
  run("clear");
  if (const char *const plugin = std::getenv("POTDEM_FUZZ_PLUGIN"))
    run(std::string("plugin load ") + plugin);
  if (!body) return;
  for (const char *const command : BODY) run(command);
}

void start()
{
  const char *arguments[] = {"lmp", "-log", "none", "-screen", "none", "-nocite"};
  lmp = lammps_open_no_mpi(6, const_cast<char **>(arguments), nullptr);
  kind = std::getenv("POTDEM_FUZZ");
  begin(true);
  if (run("pair_style potdem/truss")) return;
  fprintf(stderr, "ERROR: this LAMMPS has none of the styles: %s is not loaded\n",
          std::getenv("POTDEM_FUZZ_PLUGIN"));
  std::abort();
}

// bytes that decide
struct Bytes {
  const std::uint8_t *at, *end;

  bool empty() const { return at == end; }
  unsigned next() { return empty() ? 0 : *at++; }
  unsigned below(unsigned n) { return next() % n; }
};

/* ---------------------------------------------------------------------- */

void material_file(const std::uint8_t *data, std::size_t size)
{
  const std::string name = std::string("fuzzed.") + std::to_string(getpid());
  std::ofstream(name, std::ios::binary).write(reinterpret_cast<const char *>(data), size);
  run("pair_coeff * * " + name + " soft hard 0.5");
  run("bond_coeff 1 " + name + " soft area factor 0.4");
  run("potdem_material " + name + " soft density r");
  std::remove(name.c_str());
}

/* ---------------------------------------------------------------------- */

const char *const STYLES[] = {"pair_coeff * *",
                              "pair_coeff 1 2",
                              "bond_coeff *",
                              "potdem_bonds",
                              "potdem_material",
                              "fix f all potdem/failure",
                              "fix d all potdem/damping",
                              "fix t all potdem/timestep",
                              "fix w all potdem/wall/region floor",
                              "compute e all potdem/energy",
                              "compute s all potdem/strain/atom",
                              "compute p all potdem/piece/atom",
                              "compute c all potdem/timestep",
                              "region m potdem/mesh",
                              "pair_style potdem/hertz",
                              "pair_style potdem/lj",
                              "pair_style potdem/granular",
                              "pair_style potdem/dmt",
                              "pair_style potdem/truss",
                              "bond_style potdem/truss"};

const char *const WORDS[] = {"1",
                             "0",
                             "-1",
                             "0.5",
                             "100",
                             "1e3",
                             "1e-3",
                             "1e308",
                             "1e-308",
                             "nan",
                             "inf",
                             "-inf",
                             "2147483648",
                             "*",
                             "1*2",
                             "all",
                             "body",
                             "none",
                             "yes",
                             "no",
                             "auto",
                             "file",
                             "mixed",
                             "NULL",
                             "friction",
                             "spring",
                             "mindlin",
                             "damping",
                             "rolling",
                             "twisting",
                             "viscous",
                             "restitution",
                             "penetration",
                             "normalized",
                             "area",
                             "factor",
                             "lattice",
                             "density",
                             "cut",
                             "linear",
                             "layer",
                             "particle",
                             "law",
                             "hertz",
                             "lj",
                             "granular",
                             "dmt",
                             "truss",
                             "rotation",
                             "disc",
                             "tension",
                             "compression",
                             "scatter",
                             "weibull",
                             "normal",
                             "max",
                             "ahead",
                             "form",
                             "vector",
                             "component",
                             "weight",
                             "reference",
                             "skin",
                             "units",
                             "box",
                             "side",
                             "in",
                             "out",
                             "move",
                             "open",
                             "floor",
                             "potdem/hertz",
                             "potdem/truss",
                             "1.2",
                             "3",
                             "64",
                             "0.3",
                             "v_x",
                             "c_x",
                             "\"\"",
                             "\"two words\"",
                             "1e",
                             "--",
                             "é"};
constexpr unsigned NWORDS = sizeof(WORDS) / sizeof(WORDS[0]),
                   NSTYLES = sizeof(STYLES) / sizeof(STYLES[0]);

void arguments(Bytes bytes)
{
  std::string command = STYLES[bytes.below(NSTYLES)];
  while (!bytes.empty()) command += std::string(" ") + WORDS[bytes.below(NWORDS)];
  run(command);
  for (const char *const undo : {"unfix f", "unfix d", "unfix t", "unfix w", "uncompute e",
                                 "uncompute s", "uncompute p", "uncompute c", "region m delete"})
    run(undo);
  if (command.rfind("pair_", 0) == 0 || command.rfind("bond_", 0) == 0 ||
      command.rfind("potdem_bonds", 0) == 0)
    begin(true);
}

/* ---------------------------------------------------------------------- */

const char *const COMMANDS[] = {
    "run 0", "run 1", "run 7", "run 1 post no\nrun 3 pre no",
    "run 1 post no\npair_style potdem/hertz\nrun 3 pre no",
    "run 1 post no\nbond_style potdem/truss\nrun 3 pre no",
    "run 1 post no\nfix d all potdem/damping 0.3\nrun 3 pre no", "minimize 0 1e-6 5 20",
    "potdem_bonds all 1 1.2", "potdem_bonds all 2 1.5", "potdem_bonds half 1 1.9",
    "group half id <= 13", "group half clear", "delete_atoms group half",
    "delete_atoms group half bond yes", "delete_atoms overlap 0.9 all all",
    "delete_bonds all bond 1 remove special", "delete_bonds half bond 1",
    "delete_bonds all bond 1 undo", "create_bonds many half all 1 0.5 1.3",
    "create_atoms 1 single 3 3 3", "create_atoms 2 single 0.4 2.5 0", "set group all diameter 1.0",
    "set group half diameter 1.3", "set group all density 2.0", "set atom 3 x 0.1",
    "set group half type 2", "set group half bond 2", "displace_atoms half move 0.3 0 0",
    "displace_atoms half rotate 0 0 0 0 0 1 20", "velocity all create 1.0 4711 loop geom",
    "velocity half set 3 0 0", "change_box all x scale 1.05 remap", "change_box all boundary p p p",
    "change_box all boundary f f f", "write_restart fuzzed.restart", "read_restart fuzzed.restart",
    "write_data fuzzed.data", "clear", "reset_atoms id", "reset_atoms id sort yes",
    "replicate 1 1 1", "replicate 2 1 1 bond/periodic", "fix f all potdem/failure 1 tension 3",
    "fix f all potdem/failure * compression 2 scatter weibull 3 5", "unfix f",
    "fix d all potdem/damping 0.3", "unfix d", "fix t all potdem/timestep 2 0.5 max 0.01",
    "unfix t",
    "fix w all potdem/wall/region floor 100 0.3 particle 100 0.3 friction 0.3 spring 0.5",
    "unfix w", "fix w all potdem/wall/region floor law truss 100 0.5", "region floor delete",
    "region floor plane 0 0 -1.4 0 0 1 units box", "compute e all potdem/energy", "uncompute e",
    "compute s all potdem/strain/atom", "uncompute s", "compute p all potdem/piece/atom",
    "compute c all potdem/timestep", "thermo_style custom step pe bonds",
    "thermo_style custom step c_e c_e[7] c_c", "variable n equal f_f", "thermo 1",
    "pair_style potdem/truss", "pair_coeff * * 50 0.4 friction 0.3 spring 0.6",
    "pair_coeff * * 50 0.4", "pair_style potdem/hertz rotation yes",
    "pair_coeff * * 100 0.3 friction 0.3 mindlin rolling 0.1 0.5 0.1", "pair_style none",
    "bond_style potdem/truss", "bond_style none",
    "bond_coeff * 100 area factor 0.4 penetration 2 damping 0.1", "bond_coeff 1 100 area lattice",
    "bond_coeff 2 50 area body", "pair_style hybrid/overlay potdem/truss potdem/lj",
    "pair_coeff * * potdem/truss 50 0.4", "pair_coeff * * potdem/lj 50 0.1 2 0.2",
    "special_bonds lj 1 1 1", "special_bonds lj 0 1 1 coul 0 1 1", "newton off", "neighbor 0.1 bin",
    "neigh_modify exclude type 1 2", "comm_modify cutoff 0.5", "comm_modify cutoff 3.0",
    "atom_modify sort 1 0.5", "timestep 1e-2", "timestep 0.1", "timestep 0", "fix move all nve",
    "unfix move", "fix move all nve/sphere",
    // LAMMPS's fix adapt does not live through create_atoms before a run (docs/upstream.md)
    "fix a all adapt 1 atom diameter v_big\nrun 0", "variable big equal 1+0.01*step", "unfix a",
    "fix p all deposit 3 1 2 5 region body", "unfix p", "restart 2 fuzzed.a fuzzed.b", "restart 0",
    "unfix POTDEM_BONDS", "unfix POTDEM_LEDGER", "unfix POTDEM_MONITOR", "reset_timestep 0",
    "reset_timestep 5", "region m potdem/mesh none.stl", "run_style respa 2 2"};
constexpr unsigned NCOMMANDS = sizeof(COMMANDS) / sizeof(COMMANDS[0]);

// after an error of a command of its own LAMMPS itself may not go on: of thermo_style there is no thermo output any more, a run that failed
// in its set-up leaves requests for neighbour lists, and a fix that was to take the place of another one a gap. It begins anew
bool goes_on(const std::string &command)
{
  if (command.rfind("run", 0) == 0 || command.rfind("fix", 0) == 0) return false;
  return command.find("potdem") != std::string::npos || command.find("_coeff") != std::string::npos;
}

void sequence(Bytes bytes)
{
  begin(true);
  for (int k = 0; k < 40 && !bytes.empty(); k++) {
    const std::string command = COMMANDS[bytes.below(NCOMMANDS)];
    if (!run(command) && !goes_on(command)) return begin(true);
    if (command == "clear") begin(true);
  }
}

}    // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  if (!lmp) start();
  if (kind == "material") material_file(data, size);
  if (kind == "arguments") arguments({data, data + size});
  if (kind == "sequence") sequence({data, data + size});
  return 0;
}

#ifdef POTDEM_FUZZ_ALONE

using Input = std::vector<std::uint8_t>;

static Input read(const char *name)
{
  std::ifstream file(name, std::ios::binary);
  return Input(std::istreambuf_iterator<char>(file), {});
}

// one with a few bytes changed, or a new one
static Input made(const std::vector<Input> &kept, std::mt19937 &chance)
{
  const bool is_new = kept.empty() || chance() % 2;
  Input input = is_new ? Input(chance() % 40 + 1) : kept[chance() % kept.size()];
  for (auto &byte : input)
    if (is_new || chance() % 16 == 0) byte = chance();
  return input;
}

int main(int narg, char **arg)
{
  std::vector<Input> kept;
  for (int k = 2; k < narg; k++) kept.push_back(read(arg[k]));
  for (const auto &input : kept) LLVMFuzzerTestOneInput(input.data(), input.size());
  std::mt19937 chance(1);
  for (int k = 0; k < std::atoi(arg[1]); k++) {
    const Input input = made(kept, chance);
    std::ofstream("input", std::ios::binary).write((const char *) input.data(), input.size());
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  lammps_close(lmp);
  printf("%d inputs\n", narg - 2 + std::atoi(arg[1]));
  return 0;
}

#endif
