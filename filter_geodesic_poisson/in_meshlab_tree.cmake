# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The plugins as two of MeshLab's own, from 2025.07 on: this folder lies in src/meshlabplugins, and MESHLAB_PLUGINS
# names meshlabplugins/filter_geodesic_poisson. The engine is one of MeshLab's externals (packaging/meshlab), or
# vcg_extras lies beside or within this folder.

set(_extras "")
if(TARGET external-gpremesh)
  get_target_property(_engine external-gpremesh INTERFACE_INCLUDE_DIRECTORIES)
  set(_extras ${_engine}/vcg_extras)
endif()
foreach(_dir ${CMAKE_CURRENT_SOURCE_DIR}/vcg_extras ${CMAKE_CURRENT_SOURCE_DIR}/../vcg_extras)
  if(NOT _extras AND EXISTS ${_dir}/core/CMakeLists.txt)
    set(_extras ${_dir})
  endif()
endforeach()
if(NOT _extras)
  message(STATUS "  - filter_geodesic_poisson - Skipping, vcg_extras is not beside it.")
  return()
endif()

# What the project around the engine gives it elsewhere.
find_package(Threads REQUIRED)
foreach(_target gpr_warnings gpr_sanitizers)
  if(NOT TARGET ${_target})
    add_library(${_target} INTERFACE)
  endif()
endforeach()
add_subdirectory(${_extras}/core ${CMAKE_CURRENT_BINARY_DIR}/vcg_extras_core)
set_target_properties(gpr_core PROPERTIES AUTOMOC OFF AUTOUIC OFF AUTORCC OFF)

include(${_extras}/complex/baselines/baselines.cmake)
gpr_set_up_baselines(${GPR_QUADRIC_COLLAPSE})
add_meshlab_plugin(filter_geodesic_poisson ${_shared} ${GPR_QUADRIC_COLLAPSE}
  meshlab_2025/filter_geodesic_poisson.cpp meshlab_2025/filter_geodesic_poisson.h)
target_include_directories(filter_geodesic_poisson PRIVATE meshlab_2025)
target_link_libraries(filter_geodesic_poisson PUBLIC gpr_core)
add_meshlab_plugin(edit_geodesic_poisson ${_shared} ${_edit} ${GPR_QUADRIC_COLLAPSE})
target_include_directories(edit_geodesic_poisson PRIVATE meshlab_2025)
target_link_libraries(edit_geodesic_poisson PUBLIC gpr_core OpenGL::GL)
set_target_properties(filter_geodesic_poisson edit_geodesic_poisson PROPERTIES
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON)
