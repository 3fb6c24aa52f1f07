/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/wall/potdem_wall_surface.h"

#include "lammps/wall/region_potdem_mesh.h"

#include "domain.h"
#include "math_extra.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace LAMMPS_NS;

// LAMMPS looks for contacts with an ellipsoid between it and one with other axes, not in a layer of equal thickness;
// twice as far it misses none up to an aspect ratio of 13
static constexpr double ELLIPSOID_SEARCH = 2.0;
// over the reach: parts closer than this are flush
static constexpr double FLUSH = 1e-6;
// of one that has only flat ones: a bit for each
static constexpr int MOST_FACES = 64;
// over the reach: how far beyond a seam a surface must rise to count as a new one
static constexpr double BEYOND = 1e-3;

/* ----------------------------------------------------------------------
   unions and intersections; what a union leaves out is the intersection of what its parts leave out
------------------------------------------------------------------------- */

static bool is_intersection(const Region *whole)
{
  return utils::strmatch(whole->style, "^intersect") == (whole->interior != 0);
}

static void turn_parts_inside_out(Region *whole)
{
  for (int k = 0; k < whole->nregion; k++) whole->reglist[k]->interior ^= 1;
}

static bool is_free(Region *part, const double *x)
{
  if (!part->reglist) return part->match(x[0], x[1], x[2]) != 0;
  const auto begin = part->reglist, end = begin + part->nregion;
  const auto free = [x](Region *sub) {
    return is_free(sub, x);
  };
  const bool inside = utils::strmatch(part->style, "^intersect") ? std::all_of(begin, end, free)
                                                                 : std::any_of(begin, end, free);
  return inside == (part->interior != 0);
}

template <class Action> static void for_each_part(Region *whole, Action action)
{
  if (!whole->reglist) return action(whole);
  for (int k = 0; k < whole->nregion; k++) for_each_part(whole->reglist[k], action);
}

// not what a union leaves out: its parts are turned while it is asked
static bool keeps_shape(Region *part)
{
  if (part->varshape) return false;
  if (!part->reglist) return true;
  return part->interior && std::all_of(part->reglist, part->reglist + part->nregion, keeps_shape);
}

/* ---------------------------------------------------------------------- */

PotdemWallSurface::PotdemWallSurface(LAMMPS *lmp) :
    Pointers(lmp), region(nullptr), step(-1), moving(false)
{
}

void PotdemWallSurface::init(Region *wall)
{
  region = wall;
  std::vector<Part> now;
  for_each_part(region, [&now](Region *part) {
    const bool ellipsoid = utils::strmatch(part->style, "^ellipsoid");
    now.push_back({part,
                   dynamic_cast<RegPotdemMesh *>(part),
                   ellipsoid ? ELLIPSOID_SEARCH : 1.0,
                   0.0,
                   0.0,
                   {},
                   {}});
  });
  const bool same = std::equal(now.begin(), now.end(), parts.begin(), parts.end(),
                               [](const Part &a, const Part &b) {
                                 return a.region == b.region;
                               });
  if (same) return;
  parts = now;
  step = -1;
}

/* ----------------------------------------------------------------------
   places, and velocities as differences of places
------------------------------------------------------------------------- */

void PotdemWallSurface::follow()
{
  for (const auto &part : parts) part.region->prematch();
  // at the set-up of a further run the step has been taken already: the velocities are still there
  if (step == update->ntimestep) return;
  moving = step >= 0 && step == update->ntimestep - 1 && is_dynamic();
  step = update->ntimestep;
  for (auto &part : parts) {
    if (!part.region->dynamic_check()) continue;
    std::copy_n(part.region->prev, part.before.size(), part.before.begin());
    part.region->set_velocity();
    if (!part.region->rotateflag) continue;
    const double length = MathExtra::len3(part.region->omega);
    const double speed = fabs(part.region->theta - part.angle) / update->dt;
    part.axis_scale = length > 0.0 ? speed / length : 0.0;
    part.angle = part.region->theta;
  }
}

bool PotdemWallSurface::is_dynamic() const
{
  return std::any_of(parts.begin(), parts.end(), [](const Part &part) {
    return part.region->dynamic_check();
  });
}

// the latest step, and of each part what LAMMPS kept of the one before
std::vector<double> PotdemWallSurface::way() const
{
  std::vector<double> all;
  if (!moving) return all;
  all.push_back(static_cast<double>(step));
  for (const auto &part : parts) all.insert(all.end(), part.before.begin(), part.before.end());
  return all;
}

// the set-up of a run then finds the velocities as the latest step did
void PotdemWallSurface::go_on(const std::vector<double> &way)
{
  const std::size_t width = std::tuple_size<decltype(Part::before)>::value;
  if (way.size() != 1 + width * parts.size() || !is_dynamic()) return;
  step = static_cast<bigint>(way[0]) - 1;
  auto of_part = way.begin() + 1;
  for (auto &part : parts) {
    std::copy_n(of_part, width, part.region->prev);
    part.angle = part.region->prev[3];
    of_part += width;
  }
}

void PotdemWallSurface::velocity(const Face &face, double *u, double when) const
{
  u[0] = u[1] = u[2] = 0.0;
  if (!moving) return;
  const auto &part = parts[face.part];
  if (part.region->moveflag) MathExtra::copy3(part.region->v, u);
  if (part.region->rotateflag) {
    double arm[3], turn[3];
    MathExtra::sub3(face.foot, part.region->rpoint, arm);
    MathExtra::cross3(part.region->omega, arm, turn);
    if (when != 0.0) {
      MathExtra::scaleadd3(when * part.axis_scale, turn, arm, arm);
      MathExtra::cross3(part.region->omega, arm, turn);
    }
    MathExtra::scaleadd3(part.axis_scale, turn, u, u);
  }
  if (face.grows) {
    double foot[3] = {face.foot[0], face.foot[1], face.foot[2]};
    part.region->velocity_contact_shape(u, foot);
  }
}

/* ----------------------------------------------------------------------
   lists of what is near
------------------------------------------------------------------------- */

bool PotdemWallSurface::can_be_listed() const
{
  return keeps_shape(region);
}

void PotdemWallSurface::begin_list()
{
  for (auto &part : parts) {
    const double now[4] = {part.region->dx, part.region->dy, part.region->dz, part.region->theta};
    std::copy_n(now, 4, part.listed);
  }
  planes.assign(MOST_FACES, Plane());
}

double PotdemWallSurface::moved() const
{
  double most = 0.0;
  for (const auto &part : parts) {
    const auto *const of = part.region;
    const double way[3] = {of->dx - part.listed[0], of->dy - part.listed[1],
                           of->dz - part.listed[2]};
    double far = of->moveflag ? MathExtra::len3(way) : 0.0;
    if (of->rotateflag) {
      double arm[3];
      for (int k = 0; k < 3; k++)
        arm[k] = std::fmax(std::fabs(domain->boxlo[k] - of->rpoint[k]),
                           std::fabs(domain->boxhi[k] - of->rpoint[k]));
      far += MathExtra::len3(arm) * std::fabs(of->theta - part.listed[3]);
    }
    most = std::fmax(most, far);
  }
  return most;
}

bool PotdemWallSurface::is_flat() const
{
  if (region->reglist || !region->interior || region->openflag || region->dynamic_check())
    return false;
  return utils::strmatch(region->style, "^block") || utils::strmatch(region->style, "^plane") ||
      utils::strmatch(region->style, "^prism");
}

bool PotdemWallSurface::find_planes(const double *x, double reach, Planes &which)
{
  which = 0;
  if (!is_free(x)) return false;
  const int n = region->surface(x[0], x[1], x[2], reach);
  if (n == 0) return true;
  const std::vector<Region::Contact> contacts(region->contact, region->contact + n);
  for (const auto &contact : contacts) {
    if (contact.iwall >= MOST_FACES || !learn(contact, x, reach)) return false;
    which |= Planes(1) << contact.iwall;
  }
  return true;
}

// from a place next to it, where its distance has no rounding of its own
bool PotdemWallSurface::learn(const Region::Contact &seen, const double *x, double reach)
{
  auto &plane = planes[seen.iwall];
  if (plane.known) return true;
  if (!(seen.r > 0.0)) return false;
  const double del[3] = {seen.delx, seen.dely, seen.delz};
  double place[3];
  for (int k = 0; k < 3; k++) {
    plane.n[k] = del[k] / seen.r;
    place[k] = x[k] - del[k] + BEYOND * reach * plane.n[k];
  }
  const int n = region->surface(place[0], place[1], place[2], reach);
  for (int k = 0; k < n; k++) {
    const auto &contact = region->contact[k];
    if (contact.iwall != seen.iwall) continue;
    const double foot[3] = {place[0] - contact.delx, place[1] - contact.dely,
                            place[2] - contact.delz};
    plane.offset = MathExtra::dot3(plane.n, foot);
    plane.known = true;
  }
  return plane.known;
}

bool PotdemWallSurface::faces_of(Planes which, const double *x, double reach,
                                 std::vector<Face> &out) const
{
  for (int k = 0; which; k++, which >>= 1) {
    if (!(which & 1)) continue;
    const auto &plane = planes[k];
    const double r = MathExtra::dot3(plane.n, x) - plane.offset;
    if (!(r >= 0.0)) return false;
    if (r >= reach) continue;
    Face face{0, {}, {plane.n[0], plane.n[1], plane.n[2]}, r, false, 1 + k};
    MathExtra::scaleadd3(-r, plane.n, x, face.foot);
    out.push_back(face);
  }
  return true;
}

bool PotdemWallSurface::is_near(const double *x, double reach) const
{
  return !is_free(x) || std::any_of(parts.begin(), parts.end(), [x, reach](const Part &part) {
    return part.region->surface(x[0], x[1], x[2], part.search * reach) > 0;
  });
}

void PotdemWallSurface::spin(const Face &face, double *w) const
{
  const auto &part = parts[face.part];
  const bool turns = moving && part.region->rotateflag;
  for (int k = 0; k < 3; k++) w[k] = turns ? part.axis_scale * part.region->omega[k] : 0.0;
}

bool PotdemWallSurface::is_beside(int key, int other) const
{
  const int n = static_cast<int>(parts.size()), part = (key - 1) % n;
  return parts[part].mesh && (other - 1) % n == part &&
      parts[part].mesh->is_beside((key - 1) / n, (other - 1) / n);
}

/* ---------------------------------------------------------------------- */

bool PotdemWallSurface::is_free_of_parts(const double *x) const
{
  return ::is_free(region, x);
}

const std::vector<PotdemWallSurface::Face> &PotdemWallSurface::face_before(const double *x,
                                                                           double depth)
{
  found.clear();
  if (region->reglist) return found;
  region->interior ^= 1;
  add_faces(0, region->surface(x[0], x[1], x[2], parts[0].search * depth), x, depth, found);
  region->interior ^= 1;
  if (found.empty()) return found;
  found = {*std::min_element(found.begin(), found.end(), [](const Face &a, const Face &b) {
    return a.r < b.r;
  })};
  MathExtra::negate3(found[0].n);
  found[0].r = -found[0].r;
  return found;
}

void PotdemWallSurface::collect_all(const double *x, double reach)
{
  int part = 0;
  collect(region, part, x, reach, found);
}

// part: number of the first part, then of the one after the last
void PotdemWallSurface::collect(Region *whole, int &part, const double *x, double reach,
                                std::vector<Face> &out) const
{
  if (!whole->reglist) {
    add_faces(part, whole->surface(x[0], x[1], x[2], parts[part].search * reach), x, reach, out);
    part++;
    return;
  }
  if (!whole->interior) turn_parts_inside_out(whole);
  std::vector<Sibling> siblings;
  for (int k = 0; k < whole->nregion; k++) {
    siblings.push_back({whole->reglist[k], part, out.size(), 0});
    collect(whole->reglist[k], part, x, reach, out);
    siblings.back().end = out.size();
  }
  if (out.size() > siblings[0].begin) prune(siblings, is_intersection(whole), FLUSH * reach, out);
  if (!whole->interior) turn_parts_inside_out(whole);
}

// the n contacts of a part
void PotdemWallSurface::add_faces(int part, int n, const double *x, double reach,
                                  std::vector<Face> &out) const
{
  const auto from = parts[part].region;
  if (n > 1 && from->openflag && !from->rotateflag) {
    // exactly on the boundary of a region with open faces LAMMPS counts the contacts seen from outside and from
    // inside, and describes the latter
    double place[3] = {x[0] - from->dx, x[1] - from->dy, x[2] - from->dz};
    n = from->surface_interior(place, parts[part].search * reach);
  }
  for (int k = 0; k < n; k++) {
    const auto &contact = from->contact[k];
    if (contact.r >= reach) continue;
    const double del[3] = {contact.delx, contact.dely, contact.delz};
    const int key = 1 + part + static_cast<int>(parts.size()) * contact.iwall;
    Face face{part, {}, {}, contact.r, from->varshape && contact.varflag, key};
    MathExtra::sub3(x, del, face.foot);
    for (int c = 0; contact.r > 0.0 && c < 3; c++) face.n[c] = del[c] / contact.r;
    out.push_back(face);
  }
}

/* ----------------------------------------------------------------------
   of the faces of the parts those that belong to the whole
------------------------------------------------------------------------- */

void PotdemWallSurface::prune(const std::vector<Sibling> &siblings, bool intersection, double lift,
                              std::vector<Face> &out) const
{
  std::vector<Face> kept(out.begin(), out.begin() + siblings[0].begin);
  for (const auto &owner : siblings)
    for (std::size_t k = owner.begin; k < owner.end; k++)
      if (std::none_of(siblings.begin(), siblings.end(), [&](const Sibling &other) {
            return &other != &owner && hides(other, owner, out, k, intersection, lift);
          }))
        kept.push_back(out[k]);
  out = kept;
}

// In a union a face is hidden where another part is free behind it. In an intersection every part pushes by its own
// distance, which is continuous; only of faces that meet flush the nearest one counts.
bool PotdemWallSurface::hides(const Sibling &other, const Sibling &owner,
                              const std::vector<Face> &faces, std::size_t k, bool intersection,
                              double lift) const
{
  const auto &face = faces[k];
  if (!intersection && !other.region->openflag) {
    double behind[3];
    MathExtra::scaleadd3(-lift, face.n, face.foot, behind);
    if (::is_free(other.region, behind)) return true;
  }
  for (std::size_t m = other.begin; m < other.end; m++) {
    if (faces[m].r > face.r || (faces[m].r == face.r && m > k)) continue;
    const bool same = MathExtra::distsq3(face.foot, faces[m].foot) <= lift * lift;
    if (same || (intersection && is_flush(other, owner, face, faces[m], lift))) return true;
  }
  return false;
}

// a face whose foot is on the other part, too, and does not rise from it there as the side of a hollow does
bool PotdemWallSurface::is_flush(const Sibling &other, const Sibling &owner, const Face &face,
                                 const Face &nearer, double lift) const
{
  double place[3], along[3];
  MathExtra::scaleadd3(lift, face.n, face.foot, place);
  std::vector<Face> touched;
  int part = other.part;
  collect(other.region, part, place, 2.0 * lift, touched);
  if (touched.empty()) return false;
  MathExtra::sub3(face.foot, nearer.foot, along);
  const double beyond = BEYOND / FLUSH * lift / MathExtra::len3(along);
  MathExtra::scaleadd3(beyond, along, face.foot, place);
  MathExtra::scaleadd3(lift, nearer.n, place, place);
  return ::is_free(owner.region, place);
}
