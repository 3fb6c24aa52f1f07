/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Bodies for the tests of core/areas. */

#ifndef POTDEM_TEST_BLOCKS_H
#define POTDEM_TEST_BLOCKS_H

#include "core/areas/bonded_body.h"

namespace POTDEM {

struct Block {
  int nx, ny, nz;
  bool periodic;
  double spacing, reach;    // reach in spacings
};

// a simple cubic block on one rank
inline void fill(BondedBody &body, const Block &block, int copies = 1)
{
  const int n[3] = {block.nx, block.ny, block.nz}, size = n[0] * n[1] * n[2];
  body.nowned = body.nall = copies * size;
  body.diameter.assign(body.nall, block.spacing);
  for (int i = 0; i < body.nall; i++) body.id.push_back(i + 1);
  const int far = static_cast<int>(block.reach);
  for (int i = 0; i < body.nall; i++) {
    const int site = i % size, at[3] = {site % n[0], site / n[0] % n[1], site / (n[0] * n[1])};
    for (int x = -far; x <= far; x++)
      for (int y = -far; y <= far; y++)
        for (int z = -far; z <= far; z++) {
          const double r = std::sqrt(x * x + y * y + z * z);
          int to[3] = {at[0] + x, at[1] + y, at[2] + z};
          bool outside = r == 0.0 || r > block.reach + 1e-9;
          for (int k = 0; k < 3; k++) {
            if (block.periodic) to[k] = (to[k] + n[k]) % n[k];
            outside = outside || to[k] < 0 || to[k] >= n[k];
          }
          if (outside) continue;
          const int j = i - site + to[0] + n[0] * (to[1] + n[1] * to[2]);
          if (i < j)
            body.bonds.push_back({i, j, {x / r, y / r, z / r}, r * block.spacing, true, 0.0});
        }
  }
}

}    // namespace POTDEM

#endif
