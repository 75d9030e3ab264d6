# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Flags of the compiler, as far as it knows them. clang-cl takes those of clang behind /clang:.

include_guard(GLOBAL)
include(CheckCXXCompilerFlag)

# Sets the result to the spelling of the flag that the compiler takes, or to nothing.
function(gpr_spelling_of flag result)
  set(${result} "" PARENT_SCOPE)
  set(_spellings ${flag})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_CXX_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC" AND flag MATCHES "^-")
    set(_spellings /clang:${flag})
  endif()
  string(MAKE_C_IDENTIFIER "GPR_TAKES_${flag}" _known)
  check_cxx_compiler_flag("${_spellings}" ${_known})
  if(${_known})
    set(${result} "${_spellings}" PARENT_SCOPE)
  endif()
endfunction()

# All that are known.
function(gpr_known_flags result)
  set(_all "")
  foreach(_flag IN LISTS ARGN)
    gpr_spelling_of(${_flag} _spelling)
    list(APPEND _all ${_spelling})
  endforeach()
  set(${result} "${_all}" PARENT_SCOPE)
endfunction()

# The first that is known; it is an error where none is.
function(gpr_first_known_flag result)
  foreach(_flag IN LISTS ARGN)
    gpr_spelling_of(${_flag} _spelling)
    if(_spelling)
      set(${result} "${_spelling}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "This compiler takes none of: ${ARGN}")
endfunction()
