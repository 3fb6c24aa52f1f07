# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# The sources of this package and what they are compiled with, in LAMMPS and in the plugin alike.

include_guard()
get_filename_component(POTDEM_DIR ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)

# nobody reads errno or traps, so that loops may become vector instructions; every width gives the same bits, so no fused operations
set(POTDEM_FLOATING_POINT -fno-math-errno -fno-trapping-math -ffp-contract=off)

# psabi: see core/laws/four.h
set(POTDEM_WARNINGS -Wall -Wextra -Wno-psabi)

# for what looks at the package itself: coverage, sanitizers (unittest/trust)
set(POTDEM_EXTRA_OPTIONS "" CACHE STRING "further options with which the sources of POTDEM, not those of LAMMPS, are compiled and linked")

# messages name their place in the source by __FILE__: without the folder on the machine that it was compiled on
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-fmacro-prefix-map=/a/=/b/ POTDEM_CAN_MAP_FILES)
function(potdem_without_folder options folder)
  set(${options} "" PARENT_SCOPE)
  if(POTDEM_CAN_MAP_FILES)
    set(${options} -fmacro-prefix-map=${folder}/= PARENT_SCOPE)
  endif()
endfunction()

# the folders of LAMMPS's headers, without ours
function(potdem_lammps_includes folders)
  get_target_property(found lammps INCLUDE_DIRECTORIES)
  list(REMOVE_ITEM found ${POTDEM_DIR}/src ${POTDEM_DIR}/src/lammps)
  set(${folders} ${found} PARENT_SCOPE)
endfunction()

# once LAMMPS's target is there
function(potdem_compile_settings target)
  potdem_lammps_includes(folders)
  target_include_directories(${target} PRIVATE ${POTDEM_DIR}/src)
  target_include_directories(${target} SYSTEM PRIVATE ${folders})
  target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:lammps,COMPILE_DEFINITIONS>)
  potdem_without_folder(options ${POTDEM_DIR})
  target_compile_options(${target} PRIVATE ${POTDEM_WARNINGS})
  target_compile_options(${target} PRIVATE ${POTDEM_FLOATING_POINT} ${options} ${POTDEM_EXTRA_OPTIONS})
  target_link_options(${target} PRIVATE ${POTDEM_EXTRA_OPTIONS})
  if(BUILD_OMP)
    target_link_libraries(${target} PRIVATE OpenMP::OpenMP_CXX)
  endif()
  if(BUILD_MPI)
    target_link_libraries(${target} PRIVATE MPI::MPI_CXX)
  endif()
endfunction()

# core knows nothing of LAMMPS: unittest compiles it alone
file(GLOB_RECURSE POTDEM_CORE_SOURCES CONFIGURE_DEPENDS ${POTDEM_DIR}/src/core/*.cpp)

# a source for each row of CONTACT_LAWS
function(potdem_pair_sources files)
  set(list ${POTDEM_DIR}/src/core/laws/law_list.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(READ ${list} text)
  string(REGEX MATCH "define CONTACT_LAWS[(]X[)][^#/]*" block "${text}")
  string(REGEX MATCHALL "X[(][a-z_0-9]+, [A-Za-z_0-9]+[)]" rows "${block}")
  foreach(row IN LISTS rows)
    string(REGEX REPLACE "X[(](.*), (.*)[)]" "\\1;\\2" row "${row}")
    list(GET row 0 name)
    list(GET row 1 law)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/potdem/pair_potdem_${name}.cpp)
    configure_file(${POTDEM_DIR}/src/lammps/pair/pair_potdem_law.cpp.in ${source} @ONLY)
    list(APPEND made ${source})
  endforeach()
  set(${files} ${made} PARENT_SCOPE)
endfunction()

# all that LAMMPS's packages allow, once it is known which these are
function(potdem_sources files)
  file(GLOB found CONFIGURE_DEPENDS ${POTDEM_DIR}/src/lammps/*/*.cpp)
  if(NOT PKG_OPENMP)
    list(FILTER found EXCLUDE REGEX "_omp[.]cpp$")
  endif()
  potdem_pair_sources(pairs)
  set(${files} ${found} ${pairs} ${POTDEM_CORE_SOURCES} PARENT_SCOPE)
endfunction()
