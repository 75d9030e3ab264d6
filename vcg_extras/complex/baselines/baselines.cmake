# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later

# MeshLab's own remeshers, for comparisons. Never with assertions: they would be timed too.
set(GPR_QUADRIC_COLLAPSE ${CMAKE_CURRENT_LIST_DIR}/quadric_collapse.cpp)

# vcglib leaves the place of a collapse unset where its equations have no solution; as zero it is
# at least the same in every run.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-ftrivial-auto-var-init=zero GPR_CAN_ZERO_VARIABLES)

# To be called in the folder whose targets have the sources.
function(gpr_set_up_baselines)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_DEFINITIONS NDEBUG
    COMPILE_OPTIONS "-Wno-maybe-uninitialized;$<$<BOOL:${GPR_CAN_ZERO_VARIABLES}>:-ftrivial-auto-var-init=zero>")
endfunction()
