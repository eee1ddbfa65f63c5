#include <cholmod.h>

#include "femoop/analysis/stopwatch.h"
#include "tests/bench/in_child.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/reference_system.h"

namespace bench {

namespace {

Reference run(FrameSize size, int ordering)
{
    System s = plane_frame_system(size);
    cholmod_common common;
    cholmod_start(&common);
    common.nmethods = 1;
    common.method[0].ordering = ordering;
    common.supernodal = CHOLMOD_SUPERNODAL;
    cholmod_sparse K{};
    K.nrow = K.ncol = s.f.size();
    K.nzmax = s.rows.size();
    K.p = s.start.data();
    K.i = s.rows.data();
    K.x = s.values.data();
    K.stype = -1;
    K.itype = CHOLMOD_INT;
    K.xtype = CHOLMOD_REAL;
    K.dtype = CHOLMOD_DOUBLE;
    K.sorted = K.packed = 1;
    cholmod_dense f{};
    f.nrow = f.d = f.nzmax = s.f.size();
    f.ncol = 1;
    f.x = s.f.data();
    f.xtype = CHOLMOD_REAL;
    f.dtype = CHOLMOD_DOUBLE;

    Reference n;
    femoop::Stopwatch watch;
    cholmod_factor* L = cholmod_analyze(&K, &common);
    n.analyse = watch.lap();
    cholmod_factorize(&K, L, &common);
    n.factor = watch.lap();
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, L, &f, &common);
    n.solve = watch.lap();
    n.sway = static_cast<const double*>(x->x)[s.top_left];
    cholmod_free_dense(&x, &common);
    cholmod_free_factor(&L, &common);
    cholmod_finish(&common);
    n.peak_mb = peak_megabytes();
    return n;
}

} // namespace

Reference cholmod_amd(FrameSize size)
{
    return in_child<Reference>([&] { return run(size, CHOLMOD_AMD); });
}

Reference cholmod_metis(FrameSize size)
{
    return in_child<Reference>([&] { return run(size, CHOLMOD_METIS); });
}

} // namespace bench
