# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Debian packages of three of the parts that Install.cmake knows, by CPack;
# scripts/release/make_deb makes them.

if(NOT GPR_GZIP)
  return()
endif()
set(GPR_MAINTAINER "" CACHE STRING
    "Who is asked about the packages, as \"Name <address>\"; empty: the project's name without an address")
# Neither CPack nor dpkg takes a package without this field. An address that nobody reads is worse than none.
set(_maintainer "${GPR_MAINTAINER}")
set(_signature "${GPR_MAINTAINER}")
if(NOT GPR_MAINTAINER)
  set(_maintainer "the gpremesh authors")
  set(_signature "the gpremesh authors <>") # the form of a Debian changelog wants the brackets
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gpremesh)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # or it would come before the line of each package
set(CPACK_PACKAGE_VENDOR "the gpremesh authors")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${_maintainer}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

# What the policy wants in /usr/share/doc of every package.
set(_changes ${PROJECT_BINARY_DIR}/package/changelog)
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${_changes}.Debian
"gpremesh (${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Made from gpremesh ${PROJECT_VERSION}.

 -- ${_signature}  ${_date}
")
configure_file(${PROJECT_SOURCE_DIR}/vcg_extras/docs/CHANGELOG.md ${_changes} COPYONLY)
execute_process(COMMAND ${GPR_GZIP} -9nf ${_changes} ${_changes}.Debian)

# A package of a part, if the part is built: its name, its section, one line and one paragraph.
function(gpr_package component name section line paragraph)
  string(TOUPPER ${component} _key)
  set(_of CPACK_DEBIAN_${_key})
  set(${_of}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(${_of}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(${_of}_DESCRIPTION "${line}\n${paragraph}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/copyright ${_changes}.gz ${_changes}.Debian.gz
          DESTINATION share/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

if(TARGET gpremesh)
  gpr_package(program gpremesh graphics "remesher for triangle meshes such as scans"
"Turns a dense triangle mesh into one with about-equilateral triangles and exactly
as many vertices as asked for, fitted to the input, sharp edges and borders kept.
Reads and writes PLY, OBJ, OFF and STL.")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS gpremesh-meshlab)
endif()
if(TARGET filter_geodesic_poisson)
  gpr_package(meshlab gpremesh-meshlab graphics "geodesic Poisson-disk remeshing for MeshLab"
"Filters for MeshLab 2020.09 and meshlabserver: remeshing, sampling, retriangulation
from samples, feature detection, comparison; with a script for each. An edit tool
for the window remeshes while a slider is dragged.")
  set(CPACK_DEBIAN_MESHLAB_PACKAGE_SHLIBDEPS ON)
  get_filename_component(_dir "${GPR_MESHLAB_2020_LIBRARY}" DIRECTORY)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${_dir}")
  # It shares the layout of meshes with that very MeshLab, which does not check it.
  set(CPACK_DEBIAN_MESHLAB_PACKAGE_DEPENDS "meshlab (>= 2020.09), meshlab (<< 2020.10)")
  set(CPACK_DEBIAN_MESHLAB_PACKAGE_SUGGESTS gpremesh)
endif()
gpr_package(development libgpremesh-dev libdevel "geodesic Poisson-disk remeshing, library"
"The engine on flat arrays as a static library for C++17, the templates for vcglib,
and what find_package(gpremesh) of CMake reads.")

include(CPack)
