# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What `cmake --install` lays where, in four parts (its option --component):
#   program      gpremesh, its manual page
#   meshlab      the plugins for MeshLab 2020.09, filters and edit tool, and the scripts
#   meshlab2025  those for MeshLab 2025.07 and PyMeshLab, of which no Debian package is made
# packaging/debian makes packages of the others.
#   development  the engine, the templates for vcglib, and what find_package(gpremesh) reads
#
#   GPR_PLUGIN_DIR   folder for the plugins for MeshLab 2020.09, below the prefix or absolute; where
#                    MeshLab looks below a prefix, so that the prefix of MeshLab (/usr) is right at once

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# ---- program

if(TARGET gpremesh)
  install(TARGETS gpremesh RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
if(TARGET gpremesh_manual_page)
  install(FILES ${PROJECT_BINARY_DIR}/man/gpremesh.1.gz
          DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endif()

# ---- meshlab

# MeshLab 2020.09 finds its plugins from where its program lies: PREFIX/bin, PREFIX/lib/.../plugins.
set(_below_prefix lib/meshlab/plugins)
if(GPR_MESHLAB_2020_LIBRARY MATCHES "/(lib(/[^/]+)?/meshlab)/[^/]+$")
  set(_below_prefix ${CMAKE_MATCH_1}/plugins)
endif()
set(GPR_PLUGIN_DIR ${_below_prefix} CACHE STRING "Where the plugin for MeshLab 2020.09 is installed")
if(TARGET filter_geodesic_poisson)
  install(TARGETS filter_geodesic_poisson edit_geodesic_poisson
          LIBRARY DESTINATION ${GPR_PLUGIN_DIR} COMPONENT meshlab)
endif()
# MeshLab 2025.07 and PyMeshLab load a plugin from anywhere.
foreach(_scalar float double)
  if(TARGET filter_geodesic_poisson_2025_${_scalar})
    install(TARGETS filter_geodesic_poisson_2025_${_scalar} edit_geodesic_poisson_2025_${_scalar}
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gpremesh/meshlab-2025.07/${_scalar}
            COMPONENT meshlab2025)
  endif()
endforeach()
# The scripts, and the documents that the texts of the filters name.
if(TARGET filter_geodesic_poisson)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/filter_geodesic_poisson/mlx
          DESTINATION ${CMAKE_INSTALL_DATADIR}/gpremesh COMPONENT meshlab)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/vcg_extras/docs/
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gpremesh-meshlab COMPONENT meshlab
          FILES_MATCHING PATTERN "CHANGELOG.md" EXCLUDE PATTERN "*.md")
endif()

# ---- development

set(_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gpremesh)
install(TARGETS gpr_core vcg_extras EXPORT gpremesh
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
# The public headers of the engine lie in its folder, those of its rooms below are its own.
get_target_property(_public_headers gpr_core GPR_PUBLIC_HEADERS)
install(FILES ${_public_headers} DESTINATION include/vcg_extras/core COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/vcg_extras/complex/algorithms
        DESTINATION include/vcg_extras/complex COMPONENT development
        FILES_MATCHING PATTERN "*.h")
install(EXPORT gpremesh FILE gpremeshTargets.cmake NAMESPACE vcg_extras::
        DESTINATION ${_cmake_dir} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gpremeshConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/gpremeshConfig.cmake INSTALL_DESTINATION ${_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/gpremeshConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/gpremeshConfig.cmake
  ${PROJECT_BINARY_DIR}/package/gpremeshConfigVersion.cmake
  DESTINATION ${_cmake_dir} COMPONENT development)
