#include <dmumps_c.h>

#include <stdexcept>
#include <string>

#include "femoop/analysis/stopwatch.h"
#include "tests/bench/in_child.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/reference_system.h"

namespace bench {

namespace {

class Mumps {
public:
    Mumps()
    {
        id_.job = -1;
        id_.par = 1;
        id_.sym = 1; // positive definite
        id_.comm_fortran = -987654;
        dmumps_c(&id_);
        for (const int unit : {1, 2, 3, 4}) control(unit) = unit == 4 ? 0 : -1; // nothing is printed
        control(7) = 5;                                                         // METIS
        control(14) = 50; // per cent of memory beyond what was estimated
    }
    ~Mumps() { call(-2); }
    Mumps(const Mumps&) = delete;
    Mumps& operator=(const Mumps&) = delete;

    int& control(int i) { return id_.icntl[i - 1]; }
    DMUMPS_STRUC_C& id() { return id_; }
    void call(int job)
    {
        id_.job = job;
        dmumps_c(&id_);
        if (id_.infog[0] < 0) throw std::runtime_error("MUMPS failed with " + std::to_string(id_.infog[0]));
    }

private:
    DMUMPS_STRUC_C id_{};
};

Reference run(FrameSize size)
{
    System s = plane_frame_system(size);
    std::vector<int> rows, columns; // from 1
    for (std::size_t column = 0; column + 1 < s.start.size(); ++column)
        for (int k = s.start[column]; k < s.start[column + 1]; ++k) {
            rows.push_back(s.rows[static_cast<std::size_t>(k)] + 1);
            columns.push_back(static_cast<int>(column) + 1);
        }
    Mumps mumps;
    mumps.id().n = static_cast<int>(s.f.size());
    mumps.id().nnz = static_cast<MUMPS_INT8>(rows.size());
    mumps.id().irn = rows.data();
    mumps.id().jcn = columns.data();
    mumps.id().a = s.values.data();
    mumps.id().rhs = s.f.data();
    Reference n;
    femoop::Stopwatch watch;
    mumps.call(1);
    n.analyse = watch.lap();
    mumps.call(2);
    n.factor = watch.lap();
    mumps.call(3);
    n.solve = watch.lap();
    n.sway = s.f[s.top_left];
    n.peak_mb = peak_megabytes();
    return n;
}

} // namespace

Reference mumps(FrameSize size)
{
    return in_child<Reference>([&] { return run(size); });
}

} // namespace bench
