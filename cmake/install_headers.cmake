# SPDX-License-Identifier: MIT
# Run by cmake --install: copies `headers` from `source` to `destination` in the prefix, below reorient/. In the tree an
# include contains the path of a file ("geometry/angle.h"); installed headers need the project's name before it.
file(REMOVE_RECURSE "${stage}")
foreach(header ${headers})
  file(READ "${source}/${header}" text)
  string(REGEX REPLACE "(^|\n)#include \"" "\\1#include \"reorient/" text "${text}")
  file(WRITE "${stage}/reorient/${header}" "${text}")
endforeach()
file(INSTALL "${stage}/reorient" DESTINATION "${CMAKE_INSTALL_PREFIX}/${destination}")
