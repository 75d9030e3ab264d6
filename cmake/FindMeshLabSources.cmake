# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Finds vcglib, MeshLab's plugin headers and libmeshlab-common. Nothing here is required: what is not
# found leaves its variable empty, and who needs it is skipped.
#
# The user may give (and is told when a given path is wrong):
#   GPR_MESHLAB              the versions to build the plugin for: 2020.09, 2025.07, or both as a list
#   VCGDIR                   folder that holds vcg/ and wrap/
#   MESHLAB_SOURCE_DIR       MeshLab's src folder, or the folder above it; its version is that tree's
#   MESHLAB_COMMON_LIBRARY   libmeshlab-common.so of the MeshLab that shall load the plugin
#   MESHLAB_COMMON_LIBRARY_DOUBLE   2025.07: that of a MeshLab with double scalars
#   GPR_PYMESHLAB_PYTHON     Python that has PyMeshLab 2025.7
# Otherwise the folders in which scripts/setup leaves sources and libraries are looked in.
#
# Sets for each version V of 2020 and 2025 that is wanted:
#   GPR_MESHLAB_V_SOURCE_DIR   with common/
#   GPR_MESHLAB_V_VCGLIB_DIR   the vcglib that came with those MeshLab sources: the plugin shares
#                              CMeshO with the host and must be compiled with no other
#   GPR_MESHLAB_V_LIBRARY, GPR_MESHLAB_2025_LIBRARY_DOUBLE
#   GPR_MESHLAB_2025_VERSION   as the tree states it
# Sets GPR_PYTHON_OF_TESTS (with PyMeshLab, or empty) and GPR_VCGLIB_DIR, and defines, where vcglib and Eigen were found:
#   gpr_vcglib                 interface target: system include paths of vcglib and Eigen

set(VCGDIR "" CACHE PATH "vcglib: the folder that holds vcg/ and wrap/")
set(MESHLAB_SOURCE_DIR "" CACHE PATH "MeshLab's src folder, or the folder above it")
set(GPR_MESHLAB "2020.09" CACHE STRING "MeshLab's versions to build the plugin for: 2020.09;2025.07")

# The cache folder of scripts/setup, in GPR_CACHE_DIR.
if(NOT "$ENV{GPR_CACHE_DIR}" STREQUAL "")
  set(GPR_CACHE_DIR "$ENV{GPR_CACHE_DIR}")
elseif(NOT "$ENV{XDG_CACHE_HOME}" STREQUAL "")
  set(GPR_CACHE_DIR "$ENV{XDG_CACHE_HOME}/gpremesh")
else()
  set(GPR_CACHE_DIR "$ENV{HOME}/.cache/gpremesh")
endif()
set(_gpr_2020 "${GPR_CACHE_DIR}/meshlab-2020.09")
set(_gpr_2025 "${GPR_CACHE_DIR}/meshlab-2025.07")

# Each version is known by a file of its interface.
set(_gpr_mark_2020 common/interfaces.h)
set(_gpr_mark_2025 common/plugins/interfaces/filter_plugin.h)

# Sets in the caller the first of some folders that has a file.
function(gpr_first_with variable file)
  set(${variable} "" PARENT_SCOPE)
  foreach(_dir IN LISTS ARGN)
    if(EXISTS "${_dir}/${file}")
      get_filename_component(_found "${_dir}" ABSOLUTE)
      set(${variable} "${_found}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# A tree that was given tells its version by itself.
set(GPR_MESHLAB_WANTED ${GPR_MESHLAB})
if(MESHLAB_SOURCE_DIR)
  set(_gpr_given "${MESHLAB_SOURCE_DIR}" "${MESHLAB_SOURCE_DIR}/src")
  gpr_first_with(_gpr_given_2020 ${_gpr_mark_2020} ${_gpr_given})
  gpr_first_with(_gpr_given_2025 ${_gpr_mark_2025} ${_gpr_given})
  if(_gpr_given_2025)
    set(GPR_MESHLAB_WANTED 2025.07)
  elseif(_gpr_given_2020)
    set(GPR_MESHLAB_WANTED 2020.09)
  else()
    message(FATAL_ERROR "MESHLAB_SOURCE_DIR=${MESHLAB_SOURCE_DIR} has neither ${_gpr_mark_2020} nor ${_gpr_mark_2025}")
  endif()
endif()
foreach(_version IN LISTS GPR_MESHLAB_WANTED)
  if(NOT _version MATCHES "^(2020\\.09|2025\\.07)$")
    message(FATAL_ERROR "GPR_MESHLAB=${GPR_MESHLAB}: the plugin is for 2020.09 and 2025.07")
  endif()
endforeach()

foreach(_path VCGDIR MESHLAB_COMMON_LIBRARY MESHLAB_COMMON_LIBRARY_DOUBLE)
  set(_file "${${_path}}")
  if(_path STREQUAL VCGDIR AND VCGDIR)
    set(_file "${VCGDIR}/vcg/complex/complex.h")
  endif()
  if(_file AND NOT _file MATCHES "-NOTFOUND$" AND NOT EXISTS "${_file}")
    message(FATAL_ERROR "${_path}=${${_path}}: there is no ${_file}")
  endif()
endforeach()

# 2020.09, whose library the distribution has.
if(2020.09 IN_LIST GPR_MESHLAB_WANTED)
  gpr_first_with(GPR_MESHLAB_2020_SOURCE_DIR ${_gpr_mark_2020} ${_gpr_given_2020} "${_gpr_2020}/src")
  find_library(MESHLAB_COMMON_LIBRARY NAMES meshlab-common PATH_SUFFIXES meshlab
               DOC "libmeshlab-common of the MeshLab that shall load the plugin")
  set(GPR_MESHLAB_2020_LIBRARY "")
  if(MESHLAB_COMMON_LIBRARY)
    set(GPR_MESHLAB_2020_LIBRARY "${MESHLAB_COMMON_LIBRARY}")
  endif()
endif()

# 2025.07, of which scripts/setup has built the library for both scalars.
if(2025.07 IN_LIST GPR_MESHLAB_WANTED)
  gpr_first_with(GPR_MESHLAB_2025_SOURCE_DIR ${_gpr_mark_2025}
                 ${_gpr_given_2025} "${_gpr_2025}/source/src")
  set(_gpr_built src/distrib/libmeshlab-common.so)
  set(GPR_MESHLAB_2025_LIBRARY "")
  set(GPR_MESHLAB_2025_LIBRARY_DOUBLE "")
  if(_gpr_given_2025)
    set(GPR_MESHLAB_2025_LIBRARY "${MESHLAB_COMMON_LIBRARY}")
    set(GPR_MESHLAB_2025_LIBRARY_DOUBLE "${MESHLAB_COMMON_LIBRARY_DOUBLE}")
  else()
    if(EXISTS "${_gpr_2025}/float/${_gpr_built}")
      set(GPR_MESHLAB_2025_LIBRARY "${_gpr_2025}/float/${_gpr_built}")
    endif()
    if(EXISTS "${_gpr_2025}/double/${_gpr_built}")
      set(GPR_MESHLAB_2025_LIBRARY_DOUBLE "${_gpr_2025}/double/${_gpr_built}")
    endif()
  endif()
  set(GPR_MESHLAB_2025_VERSION 2025.07)
  if(EXISTS "${GPR_MESHLAB_2025_SOURCE_DIR}/../ML_VERSION")
    file(STRINGS "${GPR_MESHLAB_2025_SOURCE_DIR}/../ML_VERSION" GPR_MESHLAB_2025_VERSION LIMIT_COUNT 1)
  endif()
endif()

# PyMeshLab of that version, for tests.
set(GPR_PYMESHLAB_PYTHON "" CACHE FILEPATH "Python that has PyMeshLab 2025.7; scripts/setup makes one")
set(GPR_PYTHON_OF_TESTS "${GPR_PYMESHLAB_PYTHON}")
if(NOT GPR_PYTHON_OF_TESTS AND EXISTS "${GPR_CACHE_DIR}/pymeshlab-2025.7/.complete")
  set(GPR_PYTHON_OF_TESTS "${GPR_CACHE_DIR}/pymeshlab-2025.7/bin/python")
endif()

foreach(_year 2020 2025)
  set(_src "${GPR_MESHLAB_${_year}_SOURCE_DIR}")
  set(GPR_MESHLAB_${_year}_VCGLIB_DIR "")
  if(_src)
    gpr_first_with(GPR_MESHLAB_${_year}_VCGLIB_DIR vcg/complex/complex.h
                   "${_src}/../vcglib" "${_src}/vcglib" ${VCGDIR})
  endif()
endforeach()

# One vcglib for the programs, whatever MeshLab the plugin is for.
gpr_first_with(GPR_VCGLIB_DIR vcg/complex/complex.h
  ${VCGDIR} ${GPR_MESHLAB_2020_VCGLIB_DIR} "${_gpr_2020}/vcglib" ${GPR_MESHLAB_2025_VCGLIB_DIR})

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
