#include "femoop/solver/multifrontal/dense_front.h"

#include "femoop/solver/multifrontal/dense_kernel.h"

namespace femoop {

const TileWorkers one_by_one{nullptr, [](void*, std::int32_t n, void (*work)(void*, std::int32_t), void* context) {
                                 for (std::int32_t tile = 0; tile < n; ++tile) work(context, tile);
                             }};

const DenseKernel& dense_kernel()
{
    static const DenseKernel kernel = [] {
#ifdef FEMOOP_HAS_AVX512_KERNEL
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma"))
            return DenseKernel{.eliminate = &avx512::eliminate,
                               .add_update = &avx512::add_update,
                               .solve_forward = &avx512::solve_forward,
                               .solve_backward = &avx512::solve_backward,
                               .name = "avx512"};
#endif
#ifdef FEMOOP_HAS_AVX2_KERNEL
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            return DenseKernel{.eliminate = &avx2::eliminate,
                               .add_update = &avx2::add_update,
                               .solve_forward = &avx2::solve_forward,
                               .solve_backward = &avx2::solve_backward,
                               .name = "avx2"};
#endif
        return DenseKernel{.eliminate = &baseline::eliminate,
                           .add_update = &baseline::add_update,
                           .solve_forward = &baseline::solve_forward,
                           .solve_backward = &baseline::solve_backward,
                           .name = "baseline"};
    }();
    return kernel;
}

} // namespace femoop
