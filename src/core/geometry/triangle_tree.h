/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A tree of boxes around triangles: what is near a place is found without looking at the rest. Each box is halved at the
   median of its triangles' middles along its longest side. */

#ifndef POTDEM_TRIANGLE_TREE_H
#define POTDEM_TRIANGLE_TREE_H

#include "core/geometry/triangle.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace POTDEM {

struct Box {
  Vector3 lo, hi;

  void include(const Box &other)
  {
    for (int k = 0; k < 3; k++) {
      lo[k] = std::min(lo[k], other.lo[k]);
      hi[k] = std::max(hi[k], other.hi[k]);
    }
  }
  double distance2(const Vector3 &x) const
  {
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
      const double beyond = std::max(0.0, std::max(lo[k] - x[k], x[k] - hi[k]));
      sum += beyond * beyond;
    }
    return sum;
  }
};

class TriangleTree {
 public:
  void build(const std::vector<Box> &);    // of triangles 0, 1, ...

  // visit(triangle, reach2) of those whose box is within reach, the near ones first; it may make reach2, the square, smaller
  template <class Visit> void search(const Vector3 &x, double reach2, const Visit &visit) const;

 private:
  static constexpr int LEAF = 4;      // triangles at most in a box that is not halved
  static constexpr int DEPTH = 64;    // more than there can be: each halving is even

  // the first half is the next node; count > 0: a leaf, of triangles order[first] and so on
  struct Node {
    Box box;
    int first, count, second;
  };
  struct Pending {
    int node;
    double distance2;
  };
  std::vector<Node> nodes;
  std::vector<int> order;

  void halve(const std::vector<Box> &, int begin, int end);
};

template <class Visit>
void TriangleTree::search(const Vector3 &x, double reach2, const Visit &visit) const
{
  if (nodes.empty()) return;
  Pending pending[DEPTH];
  int n = 0;
  pending[n++] = {0, nodes[0].box.distance2(x)};
  while (n > 0) {
    const auto next = pending[--n];
    if (next.distance2 > reach2) continue;
    const auto &node = nodes[next.node];
    for (int k = 0; k < node.count; k++) visit(order[node.first + k], reach2);
    if (node.count > 0) continue;
    Pending near = {next.node + 1, nodes[next.node + 1].box.distance2(x)};
    Pending far = {node.second, nodes[node.second].box.distance2(x)};
    if (far.distance2 < near.distance2) std::swap(near, far);
    pending[n++] = far;
    pending[n++] = near;
  }
}

}    // namespace POTDEM

#endif
