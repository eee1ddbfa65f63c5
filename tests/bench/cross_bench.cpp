// The speed of moment distribution beside the analysis of the same structure: `ninja bench`. The best of several runs.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "apps/cli/bench_frame.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/superposition.h"

namespace {

using namespace femoop;
using namespace femoop::cross;

double best_of(int runs, const std::function<void()>& work)
{
    double best = 1e9;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return 1e3 * best;
}

Model beam_of(int spans)
{
    Model model;
    model.add(Material{.id = "steel", .E = 2.1e8});
    model.add(Section{.id = "s", .A = 0.01, .Iz = 1e-4});
    for (int i = 0; i <= spans; ++i) {
        Node node{.id = "N" + std::to_string(i),
                  .support = Support{.kind = i == 0 ? SupportKind::Pin : SupportKind::Roller}};
        node.at = {6.0 * i + 0.7 * (i % 3), 0.0, 0.0};
        model.add(std::move(node));
    }
    LoadCase load_case{.id = "q"};
    for (int i = 0; i < spans; ++i) {
        const MemberId member = model.add(
            Member{.id = "M" + std::to_string(i),
                   .nodes = {NodeId(static_cast<std::size_t>(i)), NodeId(static_cast<std::size_t>(i + 1))},
                   .material = MaterialId(0),
                   .section = SectionId(0)});
        const double q = -10.0 - i % 7;
        load_case.members.push_back(
            {.member = member, .load = DistributedLoad{.values = {{.dof = Dof::uy, .start = q}}}});
    }
    model.add(std::move(load_case));
    return model;
}

void bench_beam()
{
    const Model model = beam_of(50);
    const Problem problem = problem_of(model, CaseId(0));
    std::printf("beam of 50 spans to 1e-10 [ms]: analysis %.3f, problem %.3f, distribution",
                best_of(50, [&] { static_cast<void>(analyse(model)); }),
                best_of(50, [&] { static_cast<void>(problem_of(model, CaseId(0))); }));
    for (const auto& [name, order] : {std::pair{"largest", Order::Largest},
                                      {"left-to-right", Order::LeftToRight},
                                      {"all-at-once", Order::AllAtOnce}}) {
        const Procedure procedure{.order = order, .joints = {}, .tolerance = 1e-10, .balances = {}};
        std::size_t steps = 0;
        const double time = best_of(
            200, [&] { steps = distribute(model, problem, problem.loading, procedure).steps.size(); });
        std::printf(" %s %.3f (%zu steps)", name, time, steps);
    }
    std::printf("\n");
}

void bench_sways()
{
    const Model model = cli::plane_frame({.bays = 5, .storeys = 20});
    const Problem problem = problem_of(model, CaseId(0));
    std::printf("frame of 20 storeys and 5 bays [ms]: analysis %.1f, problem %.1f (%zu sways), sheets and equations",
                best_of(5, [&] { static_cast<void>(analyse(model)); }),
                best_of(5, [&] { static_cast<void>(problem_of(model, CaseId(0))); }), problem.sways.size());
    for (const auto& [name, order] : {std::pair{"largest", Order::Largest}, {"all-at-once", Order::AllAtOnce}}) {
        const Procedure procedure{.order = order, .joints = {}, .tolerance = {}, .balances = {}};
        std::printf(" %s %.1f", name, best_of(5, [&] { static_cast<void>(superpose(model, problem, procedure)); }));
    }
    std::printf("\n");
}

} // namespace

int main()
{
    bench_beam();
    bench_sways();
    return 0;
}
