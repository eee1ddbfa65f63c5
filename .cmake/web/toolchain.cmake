# Debian's em++ (clang 14, libc++ 13) for the preset "web". What that library lacks of C++20 stands in libcxx13/, which is
# searched before the compiler's own headers. Exceptions are WebAssembly's own; there are no threads.
find_file(CREMONA_EMSCRIPTEN cmake/Modules/Platform/Emscripten.cmake PATHS /usr/share/emscripten NO_DEFAULT_PATH REQUIRED)
include("${CREMONA_EMSCRIPTEN}")

set(CMAKE_CXX_FLAGS_INIT "-isystem ${CMAKE_CURRENT_LIST_DIR}/libcxx13 -fwasm-exceptions -DEIGEN_DONT_VECTORIZE")
# Pages travel, so they are small; Speed.cmake says what is rather fast. With -Oz this compiler inlines nothing at all, unless
# it is told that inlining has no limit.
set(small "-Oz -sINLINING_LIMIT=0 -DNDEBUG")
set(CMAKE_C_FLAGS_RELEASE "${small}")
set(CMAKE_CXX_FLAGS_RELEASE "${small}")
# The stack of a native program, since models nest deeply; memory grows up to what a browser gives.
set(CMAKE_EXE_LINKER_FLAGS_INIT
  "-sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sTOTAL_STACK=8MB -sINITIAL_MEMORY=32MB -sABORTING_MALLOC=0")

# Programs of the command line run under node, with the files and the environment of their caller.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
