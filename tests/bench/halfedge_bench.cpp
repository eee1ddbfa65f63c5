// The half-edge kernel beside CGAL's HalfedgeDS in vectors, which draws the same grid in the same run.
#include <cstdio>
#include <vector>

#include "apps/cli/bench_halfedge.h"
#include "tests/bench/cgal_reference.h"
#include "tests/bench/median.h"

using bench::median;

int main()
{
    constexpr std::size_t n = 1000, n_rounds = 9;
    std::vector<double> build, journaled, undo, validate, cgal;
    cli::HalfEdgeBench ours;
    for (std::size_t i = 0; i < n_rounds; ++i) {
        const double reference = bench::cgal_grid(n);
        ours = cli::bench_halfedge(n);
        cgal.push_back(reference);
        build.push_back(reference / ours.build);
        journaled.push_back(reference / ours.build_journaled);
        undo.push_back(reference / ours.undo);
        validate.push_back(ours.validate);
    }
    const double operators = static_cast<double>(ours.operators);
    std::printf("%zu operators; CGAL %.1f M/s; of that rate, as the median of %zu rounds:\n", ours.operators,
                1e-6 * operators / median(cgal), n_rounds);
    std::printf("  without journal %.2f (wanted 0.7), with it %.2f (0.45), undo %.2f (2.5)\n", median(build),
                median(journaled), median(undo));
    std::printf("  validate %.3f s (0.1), %.1f bytes per edge (100)\n", median(validate), ours.bytes_per_edge);
}
