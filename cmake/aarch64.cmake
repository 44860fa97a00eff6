# SPDX-License-Identifier: MIT
# Toolchain of the preset aarch64: Debian's cross compiler and the arm64 packages of tools/packages-aarch64, which are
# installed beside the native packages. A program of this build runs here under qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)

# Do not link libraries of the native architecture: pkg-config searches only the arm64 packages and the packages for all
# architectures. Programs that run during the build are native.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)

# -L /: the loader and the libraries have paths of their own (/lib/ld-linux-aarch64.so.1, /lib/aarch64-linux-gnu).
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /)
