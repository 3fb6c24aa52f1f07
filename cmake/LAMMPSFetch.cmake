# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# Gets the sources of one LAMMPS release: upstream first, then Debian's archive of the same release from
# the mirrors that this machine's package manager is set up with.

set(POTDEM_RELEASE 4Feb2025)
set(POTDEM_UPSTREAM_URL https://github.com/lammps/lammps/archive/refs/tags/patch_4Feb2025.tar.gz
  CACHE STRING "Upstream's archive of the LAMMPS release")
set(POTDEM_MIRRORS "" CACHE STRING "Debian mirrors to try (empty: those of this machine's apt)")
set(POTDEM_DEBIAN_FILE pool/main/l/lammps/lammps_20250204+dfsg.1.orig.tar.xz)
set(POTDEM_DEBIAN_SHA256 3671165bd52fad36734e0a9136c5bc5ecb225e03988f8c89aa13366a8b53b1c7)

if(DEFINED ENV{XDG_CACHE_HOME})
  set(cache $ENV{XDG_CACHE_HOME}/potdem)
else()
  set(cache $ENV{HOME}/.cache/potdem)
endif()
# outside the build tree, so that a second build does not fetch again
set(POTDEM_CACHE_DIR ${cache} CACHE PATH "Where fetched LAMMPS sources are kept")

# Upstream generates this archive on request, so no checksum of it can be known in advance: its contents
# are checked after unpacking. curl, because file(DOWNLOAD) cannot limit the time to connect alone, and
# a slow line may be slow.
function(potdem_download_upstream file problem)
  message(STATUS "POTDEM: fetching LAMMPS ${POTDEM_RELEASE} from upstream")
  find_program(CURL curl)
  if(NOT CURL)
    set(${problem} "upstream: curl is not installed" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND ${CURL} --fail --location --silent --show-error --connect-timeout 10
      --speed-limit 1 --speed-time 30 --output ${file} ${POTDEM_UPSTREAM_URL}
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE text)
  set(${problem} "" PARENT_SCOPE)
  if(NOT code EQUAL 0)
    string(STRIP "${text}" text)
    set(${problem} "upstream: ${text}" PARENT_SCOPE)
  endif()
endfunction()

function(potdem_mirrors mirrors)
  set(found ${POTDEM_MIRRORS})
  find_program(APT_GET apt-get)
  if(NOT found AND APT_GET)
    execute_process(COMMAND ${APT_GET} indextargets --format "$(REPO_URI)"
      OUTPUT_VARIABLE found ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REPLACE "\n" ";" found "${found}")
    list(TRANSFORM found REPLACE "/$" "")
    list(REMOVE_DUPLICATES found)
  endif()
  set(${mirrors} ${found} PARENT_SCOPE)
endfunction()

# apt's own downloader, because it knows the machine's proxies and mirror lists
function(potdem_download_mirror mirror file problem)
  execute_process(
    COMMAND /usr/lib/apt/apt-helper download-file ${mirror}/${POTDEM_DEBIAN_FILE} ${file}
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE text)
  if(NOT code EQUAL 0)
    string(REGEX REPLACE "[\r\n]+" " " text "${text}")
    set(${problem} "package mirror: ${text}" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 ${file} sum)
  if(NOT sum STREQUAL POTDEM_DEBIAN_SHA256)
    set(${problem} "package mirror: wrong checksum (sha256 ${sum}, expected ${POTDEM_DEBIAN_SHA256})"
      PARENT_SCOPE)
  else()
    set(${problem} "" PARENT_SCOPE)
  endif()
endfunction()

# Moves the archive's tree to its place in one rename, so that an interrupted run leaves no half tree.
function(potdem_unpack archive work tree problem)
  set(folder ${work}/unpacked)
  file(REMOVE_RECURSE ${folder})
  message(STATUS "POTDEM: unpacking LAMMPS ${POTDEM_RELEASE}")
  # not file(ARCHIVE_EXTRACT), which ends the run when the archive is broken
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${CMAKE_COMMAND} -E tar xf ${archive} WORKING_DIRECTORY ${folder}
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
  if(NOT code EQUAL 0)
    set(${problem} "the archive cannot be unpacked" PARENT_SCOPE)
    return()
  endif()
  file(GLOB roots ${folder} ${folder}/*/src/version.h)
  foreach(root IN LISTS roots)
    string(REGEX REPLACE "/src/version.h$" "" folder ${root})
  endforeach()
  potdem_check_tree(${folder} wrong)
  potdem_lammps_version(${folder} version date)
  string(REPLACE " " "" version "${version}")
  if(NOT wrong AND NOT version STREQUAL POTDEM_RELEASE)
    set(wrong "the archive holds LAMMPS ${version}, not ${POTDEM_RELEASE}")
  endif()
  if(NOT wrong)
    file(RENAME ${folder} ${tree})
  endif()
  set(${problem} "${wrong}" PARENT_SCOPE)
endfunction()

function(potdem_fetch tree)
  set(work ${POTDEM_CACHE_DIR}/fetching)
  file(MAKE_DIRECTORY ${work})
  set(archive ${work}/archive)
  potdem_download_upstream(${archive} problem)
  if(NOT problem)
    potdem_unpack(${archive} ${work} ${tree} problem)
  endif()
  set(problems "${problem}")
  potdem_mirrors(mirrors)
  if(NOT mirrors)
    string(APPEND problems "\n  package mirror: apt names none (apt-get update has it read its sources)")
  endif()
  foreach(mirror IN LISTS mirrors)
    if(problem)
      message(STATUS "POTDEM: fetching LAMMPS ${POTDEM_RELEASE} (132 MB) from this machine's package mirror")
      file(REMOVE ${archive})
      potdem_download_mirror(${mirror} ${archive} problem)
      if(NOT problem)
        potdem_unpack(${archive} ${work} ${tree} problem)
      endif()
      string(APPEND problems "\n  ${problem}")
    endif()
  endforeach()
  file(REMOVE_RECURSE ${work})
  if(problem)
    message(FATAL_ERROR "LAMMPS ${POTDEM_RELEASE} could not be fetched:\n  ${problems}\n"
      "Remedy: get the LAMMPS sources (4Feb2025 or newer) in some other way and say where they are:\n"
      "  cmake --preset default -D LAMMPS_SOURCE_DIR=/path/to/lammps")
  endif()
endfunction()

function(potdem_fetched_tree tree)
  set(place ${POTDEM_CACHE_DIR}/lammps-${POTDEM_RELEASE})
  # two builds may start at the same time
  file(LOCK ${POTDEM_CACHE_DIR} DIRECTORY GUARD FUNCTION)
  if(NOT EXISTS ${place}/src/version.h)
    potdem_fetch(${place})
  endif()
  set(${tree} ${place} PARENT_SCOPE)
endfunction()
