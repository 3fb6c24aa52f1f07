/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

// Stands for styles compiled for another LAMMPS: they need a function that the host does not have.

extern "C" void function_of_another_lammps();

extern "C" void potdem_register_styles(void *, void *, void *)
{
  function_of_another_lammps();
}
