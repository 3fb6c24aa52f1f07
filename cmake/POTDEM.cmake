# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# Builds the styles of this package into LAMMPS. LAMMPS's own project includes this file:
#   cmake -S /path/to/lammps/cmake -B build -D PKG_BPM=on \
#     -D CMAKE_PROJECT_lammps_INCLUDE=/path/to/potdem/cmake/POTDEM.cmake
# and so does the build of this package. LAMMPS's tree is not written to.

if(CMAKE_VERSION VERSION_LESS 3.21)
  message(FATAL_ERROR "POTDEM needs CMake 3.21 or newer, this is ${CMAKE_VERSION}")
endif()

include(${CMAKE_CURRENT_LIST_DIR}/POTDEMSources.cmake)

# LAMMPS writes style_pair.h etc. from these lists; ours go in before it reads them
foreach(kind PAIR BOND FIX COMPUTE COMMAND REGION)
  set_property(GLOBAL APPEND PROPERTY ${kind} ${POTDEM_DIR}/src/lammps/potdem_styles.h)
endforeach()

# called where LAMMPS's CMakeLists.txt ends: its target and its options are known then
function(potdem_into_lammps)
  if(NOT PKG_BPM)
    message(FATAL_ERROR "POTDEM needs LAMMPS's package BPM: add -D PKG_BPM=on")
  endif()
  if(NOT BUILD_MPI)
    message(FATAL_ERROR "POTDEM needs MPI, not LAMMPS's stand-in for it: add -D BUILD_MPI=on")
  endif()
  if(CMAKE_CXX_STANDARD LESS 17)
    message(FATAL_ERROR "POTDEM needs C++17: add -D CMAKE_CXX_STANDARD=17")
  endif()
  potdem_sources(sources)
  add_library(potdem OBJECT ${sources})
  set_target_properties(potdem PROPERTIES POSITION_INDEPENDENT_CODE ON)
  potdem_compile_settings(potdem)
  target_sources(lammps PRIVATE $<TARGET_OBJECTS:potdem>)
  target_link_options(lammps PRIVATE ${POTDEM_EXTRA_OPTIONS})
  target_include_directories(lammps PRIVATE ${POTDEM_DIR}/src ${POTDEM_DIR}/src/lammps)
endfunction()
cmake_language(DEFER CALL potdem_into_lammps)
