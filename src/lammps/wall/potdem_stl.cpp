/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/wall/potdem_stl.h"

#include "fmt/format.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

using namespace LAMMPS_NS;
using POTDEM::Vector3;

// binary: a title, a count, and for each triangle a normal, three corners (single precision) and two bytes
static constexpr std::size_t TITLE = 80, BEFORE = TITLE + 4, EACH = 50, NORMAL = 12;

static bool is_finite(const Vector3 &x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

static bool is_binary(const std::string &content)
{
  if (content.size() < BEFORE) return false;
  std::uint32_t count;
  std::memcpy(&count, &content[TITLE], sizeof(count));
  return content.size() == BEFORE + EACH * count;
}

static std::vector<Vector3> read_binary(const std::string &content)
{
  std::vector<Vector3> corners;
  for (std::size_t at = BEFORE; at < content.size(); at += EACH) {
    float numbers[9];
    std::memcpy(numbers, &content[at + NORMAL], sizeof(numbers));
    for (int k = 0; k < 9; k += 3) {
      corners.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
      if (!is_finite(corners.back()))
        throw std::runtime_error(
            fmt::format("triangle {} has a corner that is not a number", (corners.size() + 2) / 3));
    }
  }
  return corners;
}

static Vector3 read_corner(const std::vector<std::string> &words)
{
  Vector3 x;
  for (int k = 0; k < 3; k++) {
    if (words.size() != 4 || !utils::is_double(words[1 + k]))
      throw std::runtime_error("'vertex' needs three numbers");
    x[k] = std::stod(words[1 + k]);
  }
  if (!is_finite(x)) throw std::runtime_error("a corner is not a finite number");
  return x;
}

// one line of a text: corners are taken, all else is only checked
static void read_line(const std::string &line, std::vector<Vector3> &corners)
{
  const auto words = utils::split_words(utils::lowercase(line));
  if (words.empty()) return;
  const auto &first = words[0];
  if (first == "vertex") {
    corners.push_back(read_corner(words));
  } else if (first == "facet" || first == "endfacet") {
    if (corners.size() % 3 != 0) throw std::runtime_error("a facet without three corners");
  } else if (first != "solid" && first != "endsolid" && first != "outer" && first != "endloop") {
    throw std::runtime_error(fmt::format("'{}' is not an STL keyword", first));
  }
}

static std::vector<Vector3> read_text(const std::string &content)
{
  std::vector<Vector3> corners;
  std::size_t number = 0;
  for (std::size_t begin = 0, end; begin < content.size(); begin = end + 1) {
    end = std::min(content.find('\n', begin), content.size());
    number++;
    try {
      read_line(content.substr(begin, end - begin), corners);
    } catch (const std::exception &problem) {
      throw std::runtime_error(fmt::format("line {}: {}", number, problem.what()));
    }
  }
  if (corners.size() % 3 != 0 || content.find("endsolid") == std::string::npos)
    throw std::runtime_error("the file ends before 'endsolid'");
  return corners;
}

std::vector<Vector3> LAMMPS_NS::potdem_read_stl(const std::string &file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot be opened");
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  const bool binary = is_binary(content);
  if (!binary && !utils::strmatch(content, "^\\s*solid"))
    throw std::runtime_error("is neither a text that begins with 'solid' nor a binary STL file of "
                             "the length that it should have");
  const auto corners = binary ? read_binary(content) : read_text(content);
  if (corners.empty()) throw std::runtime_error("has no triangles");
  return corners;
}
