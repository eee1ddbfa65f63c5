# The language, the warnings, the sanitizers, the compiler cache and the precompiled headers.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_SCAN_FOR_MODULES OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CREMONA_CCACHE ccache)
mark_as_advanced(CREMONA_CCACHE)
if(CREMONA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this sloppiness ccache does not cache what uses a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
      "CCACHE_SLOPPINESS=pch_defines,time_macros" "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" "${CREMONA_CCACHE}")
endif()

# Warnings are errors in our code, and silent for others. Link it PRIVATE $<BUILD_INTERFACE:cremona_warnings>.
add_library(cremona_warnings INTERFACE)
if(MSVC)
  target_compile_options(cremona_warnings INTERFACE /W4 /WX /permissive- /utf-8)
else()
  target_compile_options(cremona_warnings INTERFACE
    -Wall -Wextra -Wno-missing-field-initializers -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast
    -Wcast-align -Woverloaded-virtual -Wdouble-promotion -Wformat=2 -Werror
    # GCC reports these falsely in what it inlines from the standard library and Eigen.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow>
    $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wlogical-op -Wuseless-cast>)
endif()

# In a unity build a name of one source is seen by its neighbours, which may well use it for a variable of their own.
if(CREMONA_UNITY)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE ${CREMONA_UNITY_BATCH})
  target_compile_options(cremona_warnings INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-shadow -Wshadow=local -Wno-subobject-linkage>
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-shadow>)
endif()

if(CREMONA_SANITIZE)
  add_compile_options(-fsanitize=${CREMONA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # The checks of every pointer are two fifths of the compiler's time, and find what the address sanitizer finds by itself.
  if(CREMONA_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=null,alignment,vptr,object-size,nonnull-attribute,returns-nonnull-attribute)
  endif()
  add_link_options(-fsanitize=${CREMONA_SANITIZE})
endif()
if(CREMONA_FUZZERS)
  add_compile_options(-fsanitize=fuzzer-no-link) # coverage, in the libraries too
endif()

# GCC tidies its memory up whenever that has grown by 100 MB, which takes a tenth of its time; a source of ours needs about 1 GB in all.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=800000>)

# cremona_precompile(TARGET KIND): TARGET is compiled with the shared precompiled header KIND ("eigen", "model", "test").
# A header must still include what it uses: the lone-header check and clang-tidy compile without any.
function(cremona_precompile target kind)
  if(CREMONA_PCH)
    target_precompile_headers(${target} REUSE_FROM cremona_pch_${kind})
  endif()
endfunction()

# cremona_precompiled_header(KIND HEADERS h... LINK t...): makes the header that cremona_precompile reuses.
function(cremona_precompiled_header kind)
  if(NOT CREMONA_PCH)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LINK")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/pch_${kind}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Carries a precompiled header.\n")
  add_library(cremona_pch_${kind} OBJECT EXCLUDE_FROM_ALL "${source}")
  target_include_directories(cremona_pch_${kind} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(cremona_pch_${kind} PRIVATE ${arg_LINK} cremona_warnings)
  target_precompile_headers(cremona_pch_${kind} PRIVATE ${arg_HEADERS})
endfunction()
