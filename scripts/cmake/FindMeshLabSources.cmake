# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Finds vcglib, MeshLab's plugin headers and libmeshlab-common. Nothing here is required: what is not
# found leaves its variable empty, and who needs it is skipped.
#
# The user may give (and is told when a given path is wrong):
#   VCGDIR                   folder that holds vcg/ and wrap/
#   MESHLAB_SOURCE_DIR       MeshLab's src folder, or the folder above it
#   MESHLAB_COMMON_LIBRARY   libmeshlab-common.so of the MeshLab that shall load the plugin
# Otherwise the folder in which scripts/setup leaves the sources is looked in.
#
# Sets:
#   GPR_VCGLIB_DIR, GPR_MESHLAB_SOURCE_DIR (with common/), GPR_MESHLAB_COMMON_LIBRARY
#   GPR_MESHLAB_VCGLIB_DIR   the vcglib that came with those MeshLab sources: the plugin shares CMeshO
#                            with the host and must be compiled with no other
# Defines, where vcglib and Eigen were found:
#   gpr_vcglib               interface target: system include paths of vcglib and Eigen

set(VCGDIR "" CACHE PATH "vcglib: the folder that holds vcg/ and wrap/")
set(MESHLAB_SOURCE_DIR "" CACHE PATH "MeshLab's src folder, or the folder above it")

# The cache folder of scripts/setup.
if(NOT "$ENV{GPR_CACHE_DIR}" STREQUAL "")
  set(_gpr_cache "$ENV{GPR_CACHE_DIR}")
elseif(NOT "$ENV{XDG_CACHE_HOME}" STREQUAL "")
  set(_gpr_cache "$ENV{XDG_CACHE_HOME}/gpremesh")
else()
  set(_gpr_cache "$ENV{HOME}/.cache/gpremesh")
endif()
set(_gpr_fetched "${_gpr_cache}/meshlab-2020.09")

# MeshLab's headers. 2020.09 has common/interfaces.h, later versions common/plugins.
set(GPR_MESHLAB_SOURCE_DIR "")
set(_gpr_candidates "${_gpr_fetched}/src")
if(MESHLAB_SOURCE_DIR)
  set(_gpr_candidates "${MESHLAB_SOURCE_DIR}" "${MESHLAB_SOURCE_DIR}/src")
endif()
foreach(_dir IN LISTS _gpr_candidates)
  if(NOT GPR_MESHLAB_SOURCE_DIR AND (EXISTS "${_dir}/common/interfaces.h" OR EXISTS "${_dir}/common/plugins"))
    set(GPR_MESHLAB_SOURCE_DIR "${_dir}")
  endif()
endforeach()
if(MESHLAB_SOURCE_DIR AND NOT GPR_MESHLAB_SOURCE_DIR)
  message(FATAL_ERROR "MESHLAB_SOURCE_DIR=${MESHLAB_SOURCE_DIR} has no common/interfaces.h")
endif()

set(GPR_MESHLAB_VCGLIB_DIR "")
if(GPR_MESHLAB_SOURCE_DIR)
  set(_gpr_candidates "${GPR_MESHLAB_SOURCE_DIR}/../vcglib" "${GPR_MESHLAB_SOURCE_DIR}/vcglib" ${VCGDIR})
  foreach(_dir IN LISTS _gpr_candidates)
    if(NOT GPR_MESHLAB_VCGLIB_DIR AND EXISTS "${_dir}/vcg/complex/complex.h")
      get_filename_component(GPR_MESHLAB_VCGLIB_DIR "${_dir}" ABSOLUTE)
    endif()
  endforeach()
endif()

if(VCGDIR AND NOT EXISTS "${VCGDIR}/vcg/complex/complex.h")
  message(FATAL_ERROR "VCGDIR=${VCGDIR} has no vcg/complex/complex.h")
endif()
set(GPR_VCGLIB_DIR "")
foreach(_dir ${VCGDIR} ${GPR_MESHLAB_VCGLIB_DIR} "${_gpr_fetched}/vcglib")
  if(NOT GPR_VCGLIB_DIR AND EXISTS "${_dir}/vcg/complex/complex.h")
    set(GPR_VCGLIB_DIR "${_dir}")
  endif()
endforeach()

find_library(MESHLAB_COMMON_LIBRARY NAMES meshlab-common PATH_SUFFIXES meshlab
             DOC "libmeshlab-common of the MeshLab that shall load the plugin")
set(GPR_MESHLAB_COMMON_LIBRARY "")
if(MESHLAB_COMMON_LIBRARY)
  if(NOT EXISTS "${MESHLAB_COMMON_LIBRARY}")
    message(FATAL_ERROR "MESHLAB_COMMON_LIBRARY=${MESHLAB_COMMON_LIBRARY} does not exist")
  endif()
  set(GPR_MESHLAB_COMMON_LIBRARY "${MESHLAB_COMMON_LIBRARY}")
endif()

find_path(GPR_EIGEN_DIR NAMES Eigen/Core PATH_SUFFIXES eigen3 DOC "Eigen 3, which vcglib includes")
mark_as_advanced(GPR_EIGEN_DIR)

if(GPR_VCGLIB_DIR AND GPR_EIGEN_DIR AND NOT TARGET gpr_vcglib)
  add_library(gpr_vcglib INTERFACE IMPORTED GLOBAL)
  # Include paths of an imported target are system paths: vcglib's own warnings stay quiet.
  set_target_properties(gpr_vcglib PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${GPR_VCGLIB_DIR};${GPR_EIGEN_DIR}")
  message(STATUS "vcglib: ${GPR_VCGLIB_DIR}")
elseif(NOT TARGET gpr_vcglib)
  message(STATUS "vcglib or Eigen not found: what needs them is left out (run scripts/setup, or give VCGDIR)")
endif()
