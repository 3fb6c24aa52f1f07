/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/geometry/triangle_tree.h"

#include <numeric>

using namespace POTDEM;

void TriangleTree::build(const std::vector<Box> &boxes)
{
  nodes.clear();
  order.resize(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  nodes.reserve(boxes.size());
  if (!boxes.empty()) halve(boxes, 0, static_cast<int>(boxes.size()));
}

void TriangleTree::halve(const std::vector<Box> &boxes, int begin, int end)
{
  const int mine = static_cast<int>(nodes.size());
  nodes.push_back({boxes[order[begin]], begin, end - begin, 0});
  auto &box = nodes[mine].box;
  for (int k = begin; k < end; k++) box.include(boxes[order[k]]);
  if (end - begin <= LEAF) return;
  const Vector3 size = box.hi - box.lo;
  const int axis = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  const int middle = begin + (end - begin) / 2;
  const auto before = [&boxes, axis](int a, int b) {
    return boxes[a].lo[axis] + boxes[a].hi[axis] < boxes[b].lo[axis] + boxes[b].hi[axis];
  };
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, before);
  nodes[mine].count = 0;
  halve(boxes, begin, middle);
  nodes[mine].second = static_cast<int>(nodes.size());
  halve(boxes, middle, end);
}
