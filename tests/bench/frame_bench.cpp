// The speed of the whole way (model in memory -> last station) against what CHOLMOD needs for the same system by
// itself, measured in turn in the same run: `ninja bench`. Every measurement runs in a process of its own.

#include <cblas.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "apps/cli/bench_frame.h"
#include "femoop/analysis/assembler.h"
#include "femoop/discretisation/equations.h"
#include "femoop/io/model_file.h"
#include "femoop/model/check/check.h"
#include "femoop/result/curve_reader.h"
#include "femoop/solver/blas.h"
#include "tests/bench/in_child.h"
#include "tests/bench/reference_system.h"

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
    double assemble, order, factor, solve, recover, total, resolve, peak_mb, operations, sway;
};

Ours run_frame(bench::FrameSize size)
{
    return bench::in_child<Ours>([&] {
        const cli::FrameBench b = cli::bench_frame({.bays = size.bays, .storeys = size.storeys},
                                                   {.solver = SolverKind::Multifrontal});
        return Ours{.assemble = b.statistics.assemble,
                    .order = b.statistics.order,
                    .factor = b.statistics.factor,
                    .solve = b.statistics.solve,
                    .recover = b.recover,
                    .total = b.total,
                    .resolve = b.resolve,
                    .peak_mb = b.peak_mb,
                    .operations = b.statistics.factor_operations,
                    .sway = b.sway};
    });
}

/// The run whose total is the median.
template <class Run, class Total> Run median(std::vector<Run> runs, Total total)
{
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::nth_element(runs.begin(), middle, runs.end(), [&](const Run& a, const Run& b) { return total(a) < total(b); });
    return *middle;
}

/// Operations a second of the BLAS's product of two square matrices, multiplications with additions.
double dgemm_rate()
{
    return bench::in_child<double>([] {
        constexpr int n = 2000;
        const std::vector<double> A(n * n, 1.0), B(n * n, 2.0);
        std::vector<double> C(n * n, 0.0);
        const double best = best_of(5, [&] {
            return seconds([&] {
                cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, n, n, n, 1.0, A.data(), n, B.data(), n, 0.0,
                            C.data(), n);
            });
        });
        return static_cast<double>(n) * n * n / best;
    });
}

/// A size of frame, with ours and all references in turn, and the median of each.
void bench_size(bench::FrameSize size, int n_runs, double dgemm)
{
    struct Known {
        const char* name;
        bench::Reference (*run)(bench::FrameSize);
        std::vector<bench::Reference> runs;
    };
    std::vector<Known> known{{"CHOLMOD, AMD", &bench::cholmod_amd, {}}, {"CHOLMOD, METIS", &bench::cholmod_metis, {}}};
#ifdef BENCH_HAS_MUMPS
    known.push_back({"MUMPS, METIS", &bench::mumps, {}});
#endif
    std::vector<Ours> runs;
    for (int i = 0; i < n_runs; ++i) {
        runs.push_back(run_frame(size));
        for (Known& each : known) each.runs.push_back(each.run(size));
    }
    const Ours ours = median(runs, [](const Ours& o) { return o.total; });
    const double rate = ours.operations / ours.factor;
    std::printf(
        "%zu unknowns, median of %d: %.4f s (assemble %.4f, order %.4f, factor %.4f, solve %.4f, recover %.4f)\n"
        "    symbolic %.0f %%, loads anew %.0f %%, factor %.2f G operations/s = %.0f %% of dgemm, %.0f MB\n",
        size.n_unknowns(), n_runs, ours.total, ours.assemble, ours.order, ours.factor, ours.solve, ours.recover,
        100.0 * ours.order / ours.total, 100.0 * ours.resolve / ours.total, 1e-9 * rate, 100.0 * rate / dgemm,
        ours.peak_mb);
    for (const Known& each : known) {
        const bench::Reference r = median(each.runs, [](const bench::Reference& one) { return one.total(); });
        std::printf("    %-15s %.4f s (%.4f, %.4f, %.4f): ratio %.2f, memory %.2f%s\n", each.name, r.total(), r.analyse,
                    r.factor, r.solve, ours.total / r.total(), ours.peak_mb / r.peak_mb,
                    std::abs(ours.sway - r.sway) < 1e-6 * std::abs(r.sway) ? "" : "  SWAY DIFFERS");
    }
    std::fflush(stdout);
}

void bench_sizes(bool with_largest)
{
    const double dgemm = dgemm_rate();
    std::printf("whole way from the model in memory to the last station, against what others need to analyse, factor "
                "and solve\nthe same matrix by themselves; dgemm %.2f G operations/s\n",
                1e-9 * dgemm);
    bench_size({19, 50}, 9, dgemm);
    bench_size({99, 100}, 7, dgemm);
    bench_size({249, 400}, 5, dgemm);
    if (with_largest) bench_size({499, 1000}, 3, dgemm);
}

/// 30 members with diagrams, against Eigen's SimplicialLDLT for the same system.
void bench_small()
{
    const Model model = cli::plane_frame({.bays = 2, .storeys = 6});
    const Discretisation structure = discretise(model);
    const Elements elements(structure);
    const Equations equations(structure, elements, SolverKind::Skyline);
    const Assembler assembler(structure, elements, equations);
    SparseMatrix K = equations.pattern().matrix();
    assembler.add_stiffness(K);
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
    bench_sizes(!is_quick); // first: a child that finds much memory of its parent copies what it writes to
    bench_small();
    bench_reading();
}
