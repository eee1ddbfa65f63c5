# What is compiled for speed and not for size: the elimination in dense fronts, where the time of a large analysis goes.
target_compile_options(femoop_kernel_baseline PRIVATE -O2)
