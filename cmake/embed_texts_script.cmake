# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by what gpr_embed_texts makes: see EmbedTexts.cmake.
cmake_policy(SET CMP0007 NEW) # empty elements of a list count

# Compilers take texts of some ten thousand bytes; longer ones are put together.
function(append_literals file)
  file(SIZE "${file}" size)
  set(offset 0)
  while(offset LESS size)
    file(READ "${file}" bytes OFFSET ${offset} LIMIT 12000 HEX)
    string(REGEX REPLACE "(..)" "\\\\x\\1" escaped "${bytes}")
    file(APPEND "${SOURCE}" "\ttext.append(\"${escaped}\", ")
    string(LENGTH "${bytes}" digits)
    math(EXPR length "${digits} / 2")
    file(APPEND "${SOURCE}" "${length});\n")
    math(EXPR offset "${offset} + 12000")
  endwhile()
endfunction()

file(WRITE "${SOURCE}" "#include <string>\n\nnamespace ${NAMESPACE} {\n\n")
while(PAIRS)
  list(GET PAIRS 0 name)
  list(GET PAIRS 1 file)
  list(REMOVE_AT PAIRS 0 1)
  file(APPEND "${SOURCE}" "std::string ${name}();\nstd::string ${name}()\n{\n\tstd::string text;\n")
  if(file AND NOT file MATCHES "-NOTFOUND$")
    append_literals("${file}")
  endif()
  file(APPEND "${SOURCE}" "\treturn text;\n}\n\n")
endwhile()
file(APPEND "${SOURCE}" "} // namespace ${NAMESPACE}\n")
