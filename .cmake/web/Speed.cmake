# What is compiled for speed and not for size: where the time of a large analysis goes.

# cremona_compile_folders_for_speed(TARGET FOLDER...): of the sources of TARGET those in these folders of its own.
function(cremona_compile_folders_for_speed target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  list(TRANSFORM ARGN PREPEND "${folder}/" OUTPUT_VARIABLE folders)
  list(JOIN folders "|" fast)
  set(rest "${sources}")
  list(FILTER sources INCLUDE REGEX "^(${fast})/.*[.]cpp$")
  list(FILTER rest EXCLUDE REGEX "^(${fast})/.*[.]cpp$")
  set_target_properties(${target} PROPERTIES SOURCES "${rest}")
  add_library(${target}_fast OBJECT ${sources})
  target_include_directories(${target}_fast PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target}_fast PRIVATE ${libraries})
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_fast>)
  target_compile_options(${target}_fast PRIVATE -O2 -mbulk-memory)
endfunction()
cremona_compile_folders_for_speed(femoop solver)

# The elimination in dense fronts takes two numbers at a time: Eigen's path for SSE2, which emscripten writes in terms of
# WebAssembly's vectors. That path has assembler for GCC before 6.3 and from 6.0 on; 5.13 is neither to it.
target_compile_options(femoop_kernel_baseline PRIVATE -O2 -mbulk-memory -msimd128 -msse2 -UEIGEN_DONT_VECTORIZE -fgnuc-version=5.13
  "SHELL:-isystem ${CMAKE_CURRENT_LIST_DIR}/sse")
