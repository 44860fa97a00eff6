# SPDX-License-Identifier: MIT
# Toolchain of the preset aarch64: Debian's cross compiler, and the arm64 packages of tools/packages-aarch64, which lie beside
# the native ones. A program that was built this way runs here under qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)

# What a search finds in the folders of the native architecture is not to be linked: pkg-config looks among the arm64 packages and
# those for every architecture only. Programs that run while building are native.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)

# -L /: its loader and libraries are at their own places (/lib/ld-linux-aarch64.so.1, /lib/aarch64-linux-gnu).
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /)
