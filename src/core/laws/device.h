/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A function that may run on a device too: nothing on a host compiler. */

#ifndef POTDEM_DEVICE_H
#define POTDEM_DEVICE_H

#ifdef __CUDACC__
#define POTDEM_FUNCTION __host__ __device__
#else
#define POTDEM_FUNCTION
#endif

#endif
