// Meshes and regions beside CGAL's, in the same run.
#include <cstdio>
#include <vector>

#include "apps/cli/bench_mesh.h"
#include "apps/cli/bench_regions.h"
#include "tests/bench/cgal_plane_reference.h"
#include "tests/bench/median.h"

namespace {

using bench::median;

constexpr int n_rounds = 3;

void compare_meshes()
{
    constexpr std::size_t n = 1'000'000;
    constexpr double longest = 1.5; // times the edge length: about as many triangles then
    const double size = cli::edge_length_of(n);
    const topology::MeshDomain domain = cli::square_with_five_holes(size);
    std::vector<double> ratios, seconds;
    cli::MeshBench ours;
    bench::CgalMesh cgal;
    for (int i = 0; i < n_rounds; ++i) {
        ours = cli::bench_mesh(n);
        cgal = bench::cgal_mesh(domain, longest * size, {{0.5, 0.5}, {0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}});
        ratios.push_back(ours.seconds / cgal.seconds);
        seconds.push_back(ours.seconds);
    }
    std::printf("mesh: %zu triangles in %.2f s, %.3f of CGAL's time (wanted 0.16), %.2f of its %zu triangles (1.1)\n",
                ours.triangles, median(seconds), median(ratios),
                static_cast<double>(ours.triangles) / static_cast<double>(cgal.triangles), cgal.triangles);
}

void compare_long_lines()
{
    const cli::RegionLines lines{.n = 1000};
    const std::vector<topology::Segment> segments = cli::segments_of(lines);
    std::vector<double> ratios;
    cli::RegionBench ours;
    bench::CgalRegions sweep;
    for (int i = 0; i < n_rounds; ++i) {
        ours = cli::bench_regions(lines, true);
        sweep = bench::cgal_sweep(segments);
        ratios.push_back(ours.seconds / sweep.seconds);
    }
    std::printf("1 000 long lines one by one: %.2f of CGAL's sweep (wanted 1); regions %zu, CGAL %zu\n", median(ratios),
                ours.counts.regions, sweep.regions);
}

void compare_short_lines()
{
    const cli::RegionLines lines{.n = 10'000, .is_long = false};
    const std::vector<topology::Segment> segments = cli::segments_of(lines);
    const double one_by_one = bench::cgal_one_by_one(segments).seconds; // once: it takes minutes
    std::vector<double> ratios, seconds, slowest;
    cli::RegionBench ours;
    bench::CgalRegions sweep;
    for (int i = 0; i < n_rounds; ++i) {
        ours = cli::bench_regions(lines, true);
        sweep = bench::cgal_sweep(segments);
        ratios.push_back(ours.seconds / sweep.seconds);
        seconds.push_back(ours.seconds);
        slowest.push_back(1e3 * ours.slowest_insertion);
    }
    std::printf(
        "10 000 short lines one by one: 1/%.0f of CGAL's (wanted 1/250), %.1f times its sweep (5), slowest %.1f ms "
        "(5); regions %zu, CGAL %zu\n",
        one_by_one / median(seconds), median(ratios), median(slowest), ours.counts.regions, sweep.regions);
}

} // namespace

int main()
{
    compare_meshes();
    compare_long_lines();
    compare_short_lines();
}
