# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# The same styles for a LAMMPS that is already there: build/potdemplugin.so, to be loaded, and
# build/potdemstyles.so beside it, which potdemplugin.so loads once it has seen that the versions match.
# In one file the dynamic linker would refuse another version first, with the name of a missing symbol.
# The styles are the objects that are linked into LAMMPS (POTDEM.cmake), compiled once for both.

set(POTDEM_PLUGIN_SYMBOLS ${PROJECT_SOURCE_DIR}/cmake/plugin.symbols)

function(potdem_shared_object target)
  set_target_properties(${target} PROPERTIES PREFIX "" SUFFIX .so
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR} INSTALL_RPATH "" LINK_DEPENDS ${POTDEM_PLUGIN_SYMBOLS})
  # nothing else is seen from outside, and nothing within is taken from a host that has the styles compiled in as well
  target_link_options(${target} PRIVATE -Wl,-Bsymbolic -Wl,--version-script=${POTDEM_PLUGIN_SYMBOLS})
  # a LAMMPS without the package OPENMP lacks functions that only the styles /omp call (plugin.cpp)
  target_link_options(${target} PRIVATE -Wl,-z,lazy)
  target_compile_definitions(${target} PRIVATE POTDEM_VERSION="${PROJECT_VERSION}")
  potdem_compile_settings(${target})
endfunction()

function(potdem_plugin target styles version)
  add_library(${target} MODULE ${PROJECT_SOURCE_DIR}/src/lammps/plugin.cpp)
  potdem_shared_object(${target})
  target_compile_definitions(${target} PRIVATE POTDEM_PLUGIN_LAMMPS_VERSION="${version}"
    POTDEM_PLUGIN_STYLES="$<TARGET_FILE_NAME:${styles}>")
  target_link_libraries(${target} PRIVATE ${CMAKE_DL_LIBS})
  add_dependencies(${target} ${styles})
endfunction()

add_library(potdemstyles MODULE ${PROJECT_SOURCE_DIR}/src/lammps/plugin_styles.cpp $<TARGET_OBJECTS:potdem>)
potdem_shared_object(potdemstyles)
target_compile_definitions(potdemstyles PRIVATE POTDEM_PLUGIN_LAMMPS_VERSION="${POTDEM_LAMMPS_VERSION}")
potdem_plugin(potdemplugin potdemstyles ${POTDEM_LAMMPS_VERSION})
