# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# Builds LAMMPS from POTDEM_LAMMPS_DIR with the styles of this package compiled in: build/lmp.
# LAMMPS's tree is not written to.

set(BUILD_SHARED_LIBS ON CACHE BOOL "Build liblammps as a shared library")
set(BUILD_MPI ON CACHE BOOL "Build LAMMPS with MPI")
set(BUILD_OMP ON CACHE BOOL "Build LAMMPS with OpenMP")
foreach(feature CURL FFMPEG GZIP JPEG PNG)
  set(WITH_${feature} OFF CACHE BOOL "LAMMPS: use ${feature}")
endforeach()
foreach(package IN LISTS POTDEM_LAMMPS_PACKAGES)
  set(PKG_${package} ON CACHE BOOL "LAMMPS package ${package}")
endforeach()
foreach(package IN LISTS POTDEM_PEER_PACKAGES)
  if(IS_DIRECTORY ${POTDEM_LAMMPS_DIR}/src/${package})
    set(PKG_${package} ON CACHE BOOL "LAMMPS package ${package}")
  endif()
endforeach()

set(MPI_CXX_SKIP_MPICXX TRUE CACHE BOOL "Leave out the obsolete C++ bindings of MPI")
if(BUILD_MPI)
  find_package(MPI REQUIRED COMPONENTS CXX)
endif()
find_package(OpenMP REQUIRED COMPONENTS CXX)

# LAMMPS writes style_pair.h etc. from these lists; ours go in before it reads them
set(POTDEM_STYLES_HEADER ${PROJECT_SOURCE_DIR}/src/lammps/potdem_styles.h)
foreach(kind PAIR BOND FIX COMPUTE COMMAND REGION)
  set_property(GLOBAL APPEND PROPERTY ${kind} ${POTDEM_STYLES_HEADER})
endforeach()

add_subdirectory(${POTDEM_LAMMPS_DIR}/cmake lammps)
get_target_property(POTDEM_LAMMPS_INCLUDES lammps INCLUDE_DIRECTORIES)

# nobody reads errno or traps, so that loops may become vector instructions; every width gives the same bits, so no fused operations
set(POTDEM_FLOATING_POINT -fno-math-errno -fno-trapping-math -ffp-contract=off)

# psabi: see core/laws/four.h
set(POTDEM_WARNINGS -Wall -Wextra -Wno-psabi)

# what a source of this package is compiled with, in liblammps and in the plugin alike
function(potdem_compile_settings target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(${target} SYSTEM PRIVATE ${POTDEM_LAMMPS_INCLUDES})
  target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:lammps,COMPILE_DEFINITIONS>)
  target_compile_options(${target} PRIVATE ${POTDEM_WARNINGS})
  target_compile_options(${target} PRIVATE ${POTDEM_FLOATING_POINT})
  target_link_libraries(${target} PRIVATE OpenMP::OpenMP_CXX)
  if(BUILD_MPI)
    target_link_libraries(${target} PRIVATE MPI::MPI_CXX)
  endif()
endfunction()

# core knows nothing of LAMMPS: unittest compiles it alone
file(GLOB_RECURSE POTDEM_CORE_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/core/*.cpp)
file(GLOB POTDEM_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/lammps/*/*.cpp)
list(APPEND POTDEM_SOURCES ${POTDEM_CORE_SOURCES})
add_library(potdem OBJECT ${POTDEM_SOURCES})
set_target_properties(potdem PROPERTIES POSITION_INDEPENDENT_CODE ON)
potdem_compile_settings(potdem)
target_sources(lammps PRIVATE $<TARGET_OBJECTS:potdem>)
target_include_directories(lammps PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/lammps)
