// The speed of the whole way (model in memory -> last station) against what CHOLMOD needs for the same system by
// itself, measured in the same run: `ninja bench`. Every measurement runs in a process of its own; the best of several
// counts.

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "apps/cli/bench_frame.h"
#include "femoop/analysis/assembly.h"
#include "femoop/analysis/equations.h"
#include "femoop/io/model_file.h"
#include "femoop/model/check/check.h"
#include "femoop/result/curve_reader.h"
#include "femoop/solver/blas.h"
#include "tests/bench/cholmod_reference.h"
#include "tests/bench/in_child.h"

namespace {

using namespace femoop;

double seconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double best_of(int runs, const std::function<double()>& measure)
{
    double best = measure();
    for (int i = 1; i < runs; ++i) best = std::min(best, measure());
    return best;
}

struct Ours {
    double assemble, order, factor, solve, recover, total, resolve, peak_mb, nonzeros, sway;
};

Ours run_frame(cli::FrameSize size)
{
    return bench::in_child<Ours>([&] {
        const cli::FrameBench b = cli::bench_frame(size, {});
        return Ours{.assemble = b.statistics.assemble,
                    .order = b.statistics.order,
                    .factor = b.statistics.factor,
                    .solve = b.statistics.solve,
                    .recover = b.recover,
                    .total = b.total,
                    .resolve = b.resolve,
                    .peak_mb = b.peak_mb,
                    .nonzeros = static_cast<double>(b.statistics.factor_nonzeros),
                    .sway = b.sway};
    });
}

template <class Result, class Run> Result fastest(int runs, Run&& run, double (*total)(const Result&))
{
    Result best = run();
    for (int i = 1; i < runs; ++i)
        if (const Result other = run(); total(other) < total(best)) best = other;
    return best;
}

void bench_sizes(bool with_largest)
{
    struct Row {
        cli::FrameSize size;
        int runs;
    };
    std::vector<Row> rows{{{9, 10}, 9}, {{19, 50}, 9}, {{99, 100}, 5}, {{249, 400}, 3}};
    if (with_largest) rows.push_back({{499, 1000}, 2});
    std::printf("whole way [s], against CHOLMOD's analyse + factor + solve of the same matrix, best of AMD and METIS\n"
                "    dofs  assemble   order  factor   solve  recover    total |  CHOLMOD           |  ratio"
                "  re-solve  memory  (MB)\n");
    for (const Row& row : rows) {
        const Ours ours = fastest<Ours>(
            row.runs, [&] { return run_frame(row.size); }, +[](const Ours& o) { return o.total; });
        const auto reference = [&](bench::ReferenceOrdering ordering) {
            return fastest<bench::Reference>(
                row.runs, [&] { return bench::cholmod_reference(row.size.bays, row.size.storeys, ordering); },
                +[](const bench::Reference& r) { return r.total(); });
        };
        const bench::Reference amd = reference(bench::ReferenceOrdering::Amd);
        const bench::Reference metis = reference(bench::ReferenceOrdering::Metis);
        const bench::Reference& best = amd.total() < metis.total() ? amd : metis;
        std::printf("%8zu %9.4f %7.4f %7.4f %7.4f %8.4f %8.4f | %8.4f by %-5s | %6.2f %8.0f%% %7.2f  (%.0f)%s\n",
                    3 * (row.size.bays + 1) * row.size.storeys, ours.assemble, ours.order, ours.factor, ours.solve,
                    ours.recover, ours.total, best.total(), best.ordering.c_str(), ours.total / best.total(),
                    100.0 * ours.resolve / ours.total, ours.peak_mb / best.peak_mb, ours.peak_mb,
                    std::abs(ours.sway - best.sway) < 1e-6 * std::abs(best.sway) ? "" : "  SWAY DIFFERS");
        std::fflush(stdout);
    }
}

/// 30 members with diagrams, against Eigen's SimplicialLDLT for the same system.
void bench_small()
{
    const Model model = cli::plane_frame({.bays = 2, .storeys = 6});
    const Structure structure = structure_of(model);
    const Equations equations(structure, SolverKind::Skyline);
    const Assembly<AnalysisKind::Frame2d> assembly(structure, equations);
    SparseMatrix K = equations.pattern().matrix();
    assembly.add_stiffness(K);
    const Eigen::VectorXd f = Eigen::VectorXd::Ones(K.cols());
    constexpr int repeats = 200;
    double sum = 0.0;
    const double eigen = best_of(9, [&] {
        return seconds([&] {
            for (int i = 0; i < repeats; ++i) sum += Eigen::SimplicialLDLT<SparseMatrix>(K).solve(f).sum();
        });
    });
    const double ours = best_of(9, [&] {
        return seconds([&] {
            for (int i = 0; i < repeats; ++i) {
                const Results results = analyse(model);
                CurveReader reader(results[CaseId(0)]);
                for (std::size_t m = 0; m < model.members.size(); ++m) {
                    const Curve& curve = reader.read(MemberId(m));
                    for (int station = 0; station <= 10; ++station)
                        sum += curve.forces(0.1 * station * curve.length()).Mz;
                }
            }
        });
    });
    std::printf("%zu members: %.4f ms with diagrams; SimplicialLDLT %.4f ms; ratio %.2f (%g)\n", model.members.size(),
                1e3 * ours / repeats, 1e3 * eigen / repeats, ours / eigen, sum);
}

void bench_reading()
{
    const std::string text = write_model(cli::plane_frame({.bays = 199, .storeys = 250}));
    Model model;
    const double time = best_of(3, [&] {
        return seconds([&] {
            model = read_model(text);
            require_sound(model);
        });
    });
    std::printf("%zu members, %.1f MB of JSON: read and checked in %.3f s\n", model.members.size(),
                1e-6 * static_cast<double>(text.size()), time);
}

} // namespace

int main(int argc, char** argv)
{
    const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
    const Blas blas = femoop::blas();
    std::printf("BLAS: %s, %d threads\n", blas.name.c_str(), blas.threads);
    bench_small();
    bench_reading();
    bench_sizes(!is_quick);
}
