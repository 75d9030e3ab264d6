# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Text files as a part of a program.
#
#   gpr_embed_texts(SOURCE NAMESPACE [FUNCTION FILE]...)
#
# makes SOURCE in the binary folder: for each pair a function `std::string FUNCTION()` that returns the
# content of FILE, and an empty text where FILE is "" or ends in -NOTFOUND.

function(gpr_embed_texts source namespace)
  set(_pairs ${ARGN})
  set(_files ${ARGN})
  list(FILTER _files INCLUDE REGEX "/")
  list(FILTER _files EXCLUDE REGEX "-NOTFOUND$")
  set(_script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_texts_script.cmake)
  add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${source}
    COMMAND ${CMAKE_COMMAND} "-DSOURCE=${CMAKE_CURRENT_BINARY_DIR}/${source}"
      "-DNAMESPACE=${namespace}" "-DPAIRS=${_pairs}" -P ${_script}
    DEPENDS ${_files} ${_script}
    VERBATIM)
endfunction()
