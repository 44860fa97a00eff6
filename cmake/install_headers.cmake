# SPDX-License-Identifier: MIT
# Run by cmake --install: copies `headers` from `source` to `destination` in the prefix, below reorient/. In the tree an include
# contains the position of a file ("geometry/angle.h"); among headers of other projects it must also contain the project.
file(REMOVE_RECURSE "${stage}")
foreach(header ${headers})
  file(READ "${source}/${header}" text)
  string(REGEX REPLACE "(^|\n)#include \"" "\\1#include \"reorient/" text "${text}")
  file(WRITE "${stage}/reorient/${header}" "${text}")
endforeach()
file(INSTALL "${stage}/reorient" DESTINATION "${CMAKE_INSTALL_PREFIX}/${destination}")
