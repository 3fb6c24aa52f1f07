# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# Builds LAMMPS from POTDEM_LAMMPS_DIR with the styles of this package compiled in: build/lmp.

set(BUILD_SHARED_LIBS ON CACHE BOOL "Build liblammps as a shared library")
set(BUILD_MPI ON CACHE BOOL "Build LAMMPS with MPI")
set(BUILD_OMP ON CACHE BOOL "Build LAMMPS with OpenMP")
set(WITH_CURL OFF CACHE BOOL "LAMMPS: use CURL")
list(APPEND CMAKE_MODULE_PATH ${POTDEM_LAMMPS_DIR}/cmake/Modules)
find_package(VORO QUIET)
if(VORO_FOUND)    # else VORONOI would fetch and build it
  list(APPEND POTDEM_PEER_PACKAGES VORONOI)
endif()
foreach(package IN LISTS POTDEM_LAMMPS_PACKAGES)
  set(PKG_${package} ON CACHE BOOL "LAMMPS package ${package}")
endforeach()
foreach(package IN LISTS POTDEM_PEER_PACKAGES)
  if(IS_DIRECTORY ${POTDEM_LAMMPS_DIR}/src/${package})
    set(PKG_${package} ON CACHE BOOL "LAMMPS package ${package}")
  endif()
endforeach()

# LAMMPS finds these itself; here so that targets outside its folder can link with what liblammps links with
foreach(library JPEG PNG ZLIB)
  find_package(${library} QUIET)
endforeach()
set(MPI_CXX_SKIP_MPICXX TRUE CACHE BOOL "Leave out the obsolete C++ bindings of MPI")
if(BUILD_MPI)
  find_package(MPI REQUIRED COMPONENTS CXX)
endif()
if(BUILD_OMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
endif()

# an installed program finds its library wherever the folder with both is moved
include(GNUInstallDirs)
file(RELATIVE_PATH from_bin_to_lib /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
list(APPEND CMAKE_INSTALL_RPATH $ORIGIN/${from_bin_to_lib})

include(POTDEMSources)
potdem_without_folder(options ${POTDEM_LAMMPS_DIR})
add_compile_options(${options})
set(CMAKE_PROJECT_lammps_INCLUDE ${PROJECT_SOURCE_DIR}/cmake/POTDEM.cmake)
add_subdirectory(${POTDEM_LAMMPS_DIR}/cmake lammps)
