/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Reads triangles from an STL file, text or binary. */

#ifndef LMP_POTDEM_STL_H
#define LMP_POTDEM_STL_H

#include "core/geometry/triangle.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

// three corners for each triangle; the normals in the file are not read. A text begins with the word solid, and a binary file
// has the length that its count of triangles says.
// Throws std::runtime_error that says what is wrong with the file, and in which line or triangle
std::vector<POTDEM::Vector3> potdem_read_stl(const std::string &file);

}    // namespace LAMMPS_NS

#endif
