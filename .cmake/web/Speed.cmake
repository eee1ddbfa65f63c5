# What is compiled for speed and not for size: where the time of a large analysis goes.

cremona_compile_apart(femoop fast solver)
target_compile_options(femoop_fast PRIVATE -O2 -mbulk-memory)

# The elimination in dense fronts takes two numbers at a time: Eigen's path for SSE2, which emscripten writes in terms of
# WebAssembly's vectors. That path has assembler for GCC before 6.3 and from 6.0 on; 5.13 is neither to it.
target_compile_options(femoop_kernel_baseline PRIVATE -O2 -mbulk-memory -msimd128 -msse2 -UEIGEN_DONT_VECTORIZE -fgnuc-version=5.13
  "SHELL:-isystem ${CMAKE_CURRENT_LIST_DIR}/sse")
