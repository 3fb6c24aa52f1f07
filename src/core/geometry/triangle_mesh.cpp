/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/geometry/triangle_mesh.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

using namespace POTDEM;

// of directions to one contact: 30 degrees
static constexpr double ONE_SURFACE = 0.8660254037844386;
// a place within this of a plane is in it
static constexpr double IN_PLANE = 1e-9;

TriangleMesh::TriangleMesh(const std::vector<Vector3> &corners) : bounds(), flat(0), open(0)
{
  share_points(corners);
  join_edges();
  if (is_closed()) {
    turn_outwards();
    find_normals();
  }
  fill_tree();
}

// corners with the same three numbers are one point
void TriangleMesh::share_points(const std::vector<Vector3> &corners)
{
  std::vector<int> order(corners.size()), point(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&corners](int a, int b) {
    return corners[a] < corners[b];
  });
  for (const int k : order) {
    if (points.empty() || points.back() != corners[k]) points.push_back(corners[k]);
    point[k] = static_cast<int>(points.size()) - 1;
  }
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
    const Vector3 out = cross(corners[k + 1] - corners[k], corners[k + 2] - corners[k]);
    if (dot(out, out) > 0.0)
      triangles.push_back({point[k], point[k + 1], point[k + 2]});
    else
      flat++;
  }
}

// an edge and its other direction come together, and each but once, where two triangles are joined well
void TriangleMesh::join_edges()
{
  struct Edge {
    int low, high, forward, triangle, which;
    bool operator<(const Edge &other) const
    {
      return std::tie(low, high, forward) < std::tie(other.low, other.high, other.forward);
    }
    bool joins(const Edge &other) const { return low == other.low && high == other.high; }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (int t = 0; t < size(); t++)
    for (int k = 0; k < 3; k++) {
      const int from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to, t, k});
    }
  std::sort(edges.begin(), edges.end());
  neighbours.assign(triangles.size(), {-1, -1, -1});
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    for (end = begin; end < edges.size() && edges[end].joins(edges[begin]);) end++;
    const auto &a = edges[begin], &b = edges[end - 1];
    if (end - begin != 2 || a.forward == b.forward) {
      open += static_cast<int>(end - begin);
      continue;
    }
    neighbours[a.triangle][a.which] = b.triangle;
    neighbours[b.triangle][b.which] = a.triangle;
  }
}

double TriangleMesh::volume() const
{
  double sum = 0.0;
  for (const auto &of : triangles)
    sum +=
        dot(points[of[0]] - points[0], cross(points[of[1]] - points[0], points[of[2]] - points[0]));
  return sum / 6.0;
}

void TriangleMesh::turn_outwards()
{
  if (volume() >= 0.0) return;
  for (int t = 0; t < size(); t++) {
    std::swap(triangles[t][1], triangles[t][2]);
    std::swap(neighbours[t][0], neighbours[t][2]);
  }
}

Vector3 TriangleMesh::normal(int t) const
{
  const auto &of = triangles[t];
  const Vector3 out = cross(points[of[1]] - points[of[0]], points[of[2]] - points[of[0]]);
  return add_scaled({}, 1.0 / std::sqrt(dot(out, out)), out);
}

void TriangleMesh::find_normals()
{
  at_points.assign(points.size(), Vector3{});
  for (int t = 0; t < size(); t++)
    for (int k = 0; k < 3; k++) {
      const int at = triangles[t][k];
      const Vector3 one = points[triangles[t][(k + 1) % 3]] - points[at],
                    two = points[triangles[t][(k + 2) % 3]] - points[at];
      const Vector3 across = cross(one, two);
      const double angle = std::atan2(std::sqrt(dot(across, across)), dot(one, two));
      at_points[at] = add_scaled(at_points[at], angle, normal(t));
    }
}

void TriangleMesh::fill_tree()
{
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const auto &of : triangles) {
    boxes.push_back({points[of[0]], points[of[0]]});
    for (const int k : of) boxes.back().include({points[k], points[k]});
  }
  tree.build(boxes);
  if (boxes.empty()) return;
  bounds = boxes[0];
  for (const auto &box : boxes) bounds.include(box);
}

/* ---------------------------------------------------------------------- */

NearestPlace TriangleMesh::nearest_place_of(int t, const Vector3 &x) const
{
  const auto &of = triangles[t];
  return nearest_place(x, points[of[0]], points[of[1]], points[of[2]]);
}

void TriangleMesh::contacts(const Vector3 &x, double reach, std::vector<Contact> &out) const
{
  std::vector<Contact> all;
  tree.search(x, reach * reach, [&](int t, double &reach2) {
    const auto near = nearest_place_of(t, x);
    const Vector3 del = near.place - x;
    const double r2 = dot(del, del);
    if (r2 < reach2) all.push_back({near.place, std::sqrt(r2), t, near.on, near.which});
  });
  std::sort(all.begin(), all.end(), [](const Contact &a, const Contact &b) {
    return a.r != b.r ? a.r < b.r : a.triangle < b.triangle;
  });
  out.clear();
  for (auto contact = all.begin(); contact != all.end(); ++contact) {
    const Vector3 del = contact->place - x;
    const auto is_one_with = [&](const Contact &nearer) {
      const double along = dot(del, nearer.place - x);
      return along >= (1.0 - IN_PLANE) * nearer.r * nearer.r ||
          along >= ONE_SURFACE * nearer.r * contact->r;
    };
    const auto leads_to = [&](const Contact &nearer) {
      return goes_nearer(*contact, nearer);
    };
    if (std::none_of(out.begin(), out.end(), is_one_with) &&
        std::none_of(all.begin(), contact, leads_to))
      out.push_back(*contact);
  }
}

// is the triangle of another contact, which is nearer, one of those at the place?
bool TriangleMesh::goes_nearer(const Contact &contact, const Contact &other) const
{
  if (contact.on == NearestPlace::FACE || !(other.r < contact.r)) return false;
  const auto &mine = triangles[contact.triangle], &of = triangles[other.triangle];
  const auto has = [&of](int point) {
    return std::find(of.begin(), of.end(), point) != of.end();
  };
  return has(mine[contact.which]) &&
      (contact.on == NearestPlace::CORNER || has(mine[(contact.which + 1) % 3]));
}

bool TriangleMesh::is_beside(int t, int other) const
{
  const auto exists = [this](int k) {
    return k >= 0 && k < size();
  };
  return exists(t) && exists(other) && std::fabs(dot(normal(t), normal(other))) > ONE_SURFACE;
}

Vector3 TriangleMesh::normal_at(const Contact &contact) const
{
  const int t = contact.triangle;
  if (contact.on == NearestPlace::CORNER) return at_points[triangles[t][contact.which]];
  if (contact.on == NearestPlace::FACE) return normal(t);
  return add_scaled(normal(t), 1.0, normal(neighbours[t][contact.which]));
}

bool TriangleMesh::is_behind(const Vector3 &x, const Contact &nearest) const
{
  return dot(x - nearest.place, normal_at(nearest)) <= 0.0;
}

bool TriangleMesh::is_inside(const Vector3 &x) const
{
  if (triangles.empty() || bounds.distance2(x) > 0.0) return false;
  Contact nearest{};
  tree.search(x, std::numeric_limits<double>::infinity(), [&](int t, double &reach2) {
    const auto near = nearest_place_of(t, x);
    const Vector3 del = near.place - x;
    const double r2 = dot(del, del);
    if (r2 >= reach2) return;
    reach2 = r2;
    nearest = {near.place, std::sqrt(r2), t, near.on, near.which};
  });
  return is_behind(x, nearest);
}
