# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# What "cmake --install build" and "cpack" (from the build folder) give, beside what LAMMPS installs of itself (headers, its
# CMake and pkg-config files, potentials). cpack takes the component potdem alone. The installed folder can be moved.

set(data ${CMAKE_INSTALL_DATADIR}/potdem)
set(POTDEM_PLUGIN_DIR ${CMAKE_INSTALL_LIBDIR}/lammps/plugins)

install(TARGETS lmp RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT potdem)
install(TARGETS lammps LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT potdem)
# the folder for LAMMPS_PLUGIN_PATH
install(TARGETS potdemplugin potdemstyles LIBRARY DESTINATION ${POTDEM_PLUGIN_DIR} COMPONENT potdem)
# where LAMMPS's own install has its potentials, for LAMMPS_POTENTIALS
install(DIRECTORY potentials DESTINATION ${CMAKE_INSTALL_DATADIR}/lammps COMPONENT potdem)

install(FILES README.md CHANGELOG.md AUTHORS LICENSE CITATION.cff DESTINATION ${data} COMPONENT potdem)
install(DIRECTORY docs potentials DESTINATION ${data} COMPONENT potdem)
install(DIRECTORY examples DESTINATION ${data} COMPONENT potdem PATTERN run EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY tools/potdem ${POTDEM_LAMMPS_DIR}/python/lammps DESTINATION ${data}/tools COMPONENT potdem
  PATTERN __pycache__ EXCLUDE)

# beside its module LAMMPS's Python looks for the library first
file(RELATIVE_PATH library /${data}/tools/lammps /${CMAKE_INSTALL_LIBDIR}/liblammps.so.0)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/python)
file(CREATE_LINK ${library} ${PROJECT_BINARY_DIR}/python/liblammps.so SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/python/liblammps.so DESTINATION ${data}/tools/lammps COMPONENT potdem)

file(RELATIVE_PATH POTDEM_BIN_TO_DATA /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_DATADIR})
configure_file(cmake/potdem-env.in ${PROJECT_BINARY_DIR}/potdem-env @ONLY)
install(PROGRAMS ${PROJECT_BINARY_DIR}/potdem-env DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT potdem)

set(CPACK_GENERATOR TGZ)
set(CPACK_PACKAGE_NAME potdem)
set(CPACK_PACKAGE_FILE_NAME potdem-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_COMPONENTS_ALL potdem)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
