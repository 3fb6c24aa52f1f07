/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What one core can do at most: bytes from memory and caches, and arithmetic in vectors of four and of eight numbers. A line for each,
   "name value", in GB/s, Gflop/s and ns for one division and one root of each number. bench/limits.py compiles and runs it. */

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

typedef double Four __attribute__((vector_size(32), aligned(8)));
typedef double Eight __attribute__((vector_size(64), aligned(8)));

static volatile double unknown = 1.0, sink;

// processor seconds of one call: the least of several samples, each long enough for the clock
template <class Work> static double seconds(Work work)
{
  double least = 1e300;
  for (int sample = 0; sample < 9; sample++) {
    double passed = 0.0;
    int calls = 1;
    for (; passed < 0.02; calls *= 2) {
      const auto start = std::clock();
      for (int k = 0; k < calls; k++) work();
      passed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    least = std::fmin(least, 2.0 * passed / calls);
  }
  return least;
}

template <class Vector> static double sum(const Vector &all)
{
  double total = 0.0;
  for (std::size_t k = 0; k < sizeof(Vector) / sizeof(double); k++) total += all[k];
  return total;
}

static void read_and_triad(const char *name, std::size_t bytes)
{
  std::vector<double> a(bytes / 8, 1.0);
  const double read = seconds([&] {
    Eight sums[4] = {};
    for (std::size_t k = 0; k + 32 <= a.size(); k += 32)
      for (int s = 0; s < 4; s++) sums[s] += *(const Eight *) &a[k + 8 * s];
    sink = sum(sums[0] + sums[1] + sums[2] + sums[3]);
  });
  const std::size_t n = a.size() / 3;
  const double factor = unknown;
  const double triad = seconds([&] {
    double *const to = a.data();
    const double *const one = to + n, *const other = one + n;
#pragma GCC ivdep
    for (std::size_t k = 0; k < n; k++) to[k] = one[k] + factor * other[k];
    sink = to[n / 2];
  });
  std::printf("read-%s %.2f\ntriad-%s %.2f\n", name, 1e-9 * bytes / read, name,
              1e-9 * 24 * n / triad);
}

constexpr int CHAINS = 14, TIMES = 10000;

// independent chains, so that what counts is how many can begin in a cycle
template <class Vector> static void multiply_and_add(const char *name)
{
  constexpr int WIDTH = sizeof(Vector) / sizeof(double);
  const Vector factor = Vector{} + 0.5 * unknown, term = Vector{} + unknown;
  const double passed = seconds([&] {
    Vector chain[CHAINS] = {};
    for (int t = 0; t < TIMES; t++)
#pragma GCC unroll 14
      for (int k = 0; k < CHAINS; k++) chain[k] = chain[k] * factor + term;
    for (const auto &one : chain) sink = sum(one);
  });
  std::printf("%s-%d %.2f\n", name, WIDTH, 2e-9 * WIDTH * CHAINS * TIMES / passed);
}

template <class Vector> static void divide_and_root(const char *name)
{
  constexpr int WIDTH = sizeof(Vector) / sizeof(double);
  const double passed = seconds([&] {
    Vector chain[CHAINS];
    for (auto &one : chain) one = Vector{} + 2.0 * unknown;
    for (int t = 0; t < TIMES; t++)
      for (auto &one : chain) {
        Vector root;
        for (int k = 0; k < WIDTH; k++) root[k] = std::sqrt(one[k]);
        one = 3.0 / root;
      }
    for (const auto &one : chain) sink = sum(one);
  });
  std::printf("%s-%d %.4f\n", name, WIDTH, 1e9 * passed / (WIDTH * CHAINS * TIMES));
}

int main()
{
  read_and_triad("L1", 24 << 10);
  read_and_triad("L2", 384 << 10);
  read_and_triad("L3", 6 << 20);
  read_and_triad("memory", 384 << 20);
#ifdef FUSED
  multiply_and_add<Four>("fused");
  multiply_and_add<Eight>("fused");
#else
  multiply_and_add<Four>("plain");
  multiply_and_add<Eight>("plain");
  divide_and_root<Four>("root");
  divide_and_root<Eight>("root");
#endif
}
