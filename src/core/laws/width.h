/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Registers for which loops are compiled. Which of them the machine has is asked when the program runs, so that what is built does not
   depend on where. With POTDEM_PLAIN_CODE there is one only: for builds with sanitizers, which take many times as long for the others. */

#ifndef POTDEM_WIDTH_H
#define POTDEM_WIDTH_H

#if defined(__x86_64__) && defined(__GNUC__) && !defined(POTDEM_PLAIN_CODE)
#define POTDEM_WIDE_CODE 1
#define POTDEM_AVX2 __attribute__((target("avx2")))
#define POTDEM_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl")))
#endif

namespace POTDEM {

enum class Width { PLAIN, AVX2, AVX512 };

inline Width widest()
{
#ifdef POTDEM_WIDE_CODE
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return Width::AVX512;
  if (__builtin_cpu_supports("avx2")) return Width::AVX2;
#endif
  return Width::PLAIN;
}

// can this law take several contacts, or bonds, at once? A law that says nothing cannot
template <class Law> constexpr auto is_wide(int) -> decltype(Law::wide)
{
  return Law::wide;
}
template <class Law> constexpr bool is_wide(long)
{
  return false;
}

}    // namespace POTDEM

#endif
