# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# Sets POTDEM_LAMMPS_DIR, the LAMMPS source tree to build with, POTDEM_LAMMPS_VERSION ("4 Feb 2025")
# and POTDEM_LAMMPS_PACKAGES. The tree is the user's own (LAMMPS_SOURCE_DIR) or a fetched one.

include(LAMMPSFetch)

set(LAMMPS_SOURCE_DIR "" CACHE PATH "LAMMPS source tree to build with (empty: fetch one)")
set(POTDEM_OLDEST_LAMMPS 20250204)
set(POTDEM_LAMMPS_PACKAGES MOLECULE BPM PLUGIN OPENMP)
# for comparisons (GRANULAR) and for scripts (clumps, servo control, images, cells); left out where the tree lacks them
set(POTDEM_PEER_PACKAGES GRANULAR RIGID EXTRA-FIX EXTRA-DUMP)

# "4 Feb 2025" in src/version.h becomes 20250204; both are empty where there is no such file
function(potdem_lammps_version tree version date)
  set(${version} "" PARENT_SCOPE)
  set(${date} "" PARENT_SCOPE)
  if(NOT EXISTS ${tree}/src/version.h)
    return()
  endif()
  file(READ ${tree}/src/version.h text)
  if(NOT text MATCHES "LAMMPS_VERSION \"(([0-9]+) ([A-Z][a-z][a-z])[a-z]* ([0-9]+))\"")
    return()
  endif()
  set(found ${CMAKE_MATCH_1})
  set(day ${CMAKE_MATCH_2})
  set(year ${CMAKE_MATCH_4})
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  list(FIND months ${CMAKE_MATCH_3} month)
  math(EXPR number "${year} * 10000 + (${month} + 1) * 100 + ${day}")
  set(${version} ${found} PARENT_SCOPE)
  set(${date} ${number} PARENT_SCOPE)
endfunction()

# problem: empty when POTDEM can be built with this tree, else the reason why not
function(potdem_check_tree tree problem)
  potdem_lammps_version(${tree} version date)
  set(${problem} "" PARENT_SCOPE)
  if(NOT date OR NOT EXISTS ${tree}/cmake/CMakeLists.txt)
    set(${problem} "${tree} is not a LAMMPS source tree (no src/version.h with a version, \
or no cmake/CMakeLists.txt)" PARENT_SCOPE)
    return()
  endif()
  if(date LESS POTDEM_OLDEST_LAMMPS)
    set(${problem} "${tree} holds LAMMPS ${version}, POTDEM needs 4 Feb 2025 or newer" PARENT_SCOPE)
    return()
  endif()
  foreach(package IN LISTS POTDEM_LAMMPS_PACKAGES)
    if(NOT IS_DIRECTORY ${tree}/src/${package})
      set(${problem} "${tree} lacks the LAMMPS package ${package} (src/${package})" PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

function(potdem_users_tree tree)
  get_filename_component(given "${LAMMPS_SOURCE_DIR}" ABSOLUTE)
  potdem_check_tree(${given} problem)
  if(problem)
    message(FATAL_ERROR "LAMMPS_SOURCE_DIR: ${problem}.\n"
      "Give the folder that holds LAMMPS's src and cmake folders, or leave LAMMPS_SOURCE_DIR empty "
      "(-D LAMMPS_SOURCE_DIR=) to have LAMMPS fetched.")
  endif()
  set(${tree} ${given} PARENT_SCOPE)
endfunction()

if(LAMMPS_SOURCE_DIR)
  potdem_users_tree(tree)
else()
  potdem_fetched_tree(tree)
endif()
set(POTDEM_LAMMPS_DIR ${tree} CACHE INTERNAL "LAMMPS source tree in use")
potdem_lammps_version(${POTDEM_LAMMPS_DIR} POTDEM_LAMMPS_VERSION date)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${POTDEM_LAMMPS_DIR}/src/version.h)
message(STATUS "POTDEM: LAMMPS ${POTDEM_LAMMPS_VERSION} from ${POTDEM_LAMMPS_DIR}")
