/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A function that may run on a device too; on a host it goes into the loops that use it, whatever they are compiled for
   (core/contact/contact_batch.h). */

#ifndef POTDEM_DEVICE_H
#define POTDEM_DEVICE_H

#ifdef __CUDACC__
#define POTDEM_FUNCTION __host__ __device__
#elif defined(__GNUC__)
#define POTDEM_FUNCTION __attribute__((always_inline))
#else
#define POTDEM_FUNCTION
#endif

#endif
