#include "apps/cli/bench_frame.h"

#include <sys/resource.h>

#include <future>
#include <string>
#include <utility>

#include "femoop/analysis/stopwatch.h"
#include "femoop/result/curve_reader.h"

namespace cli {

using namespace femoop;

namespace {

/// Adds nodes, members and loads to a frame, level by level.
class FrameBuilder {
public:
    FrameBuilder(FrameSize size, Model& model) : size_(size), model_(model)
    {
        const MaterialId steel = model.add(Material{.id = "steel", .E = 210e6});
        Section column{.id = "column"}, beam{.id = "beam"};
        column.A = 0.01;
        column.Iz = 1e-4;
        beam.A = 0.008;
        beam.Iz = 2e-4;
        column_ = {.material = steel, .section = model.add(column)};
        beam_ = {.material = steel, .section = model.add(beam)};
        model.nodes.reserve((size.bays + 1) * (size.storeys + 1));
        model.members.reserve((2 * size.bays + 1) * size.storeys);
        load_case_.id = "all";
        load_case_.members.reserve(size.bays * size.storeys);
    }

    void add_level(std::size_t level)
    {
        for (std::size_t axis = 0; axis <= size_.bays; ++axis) {
            Node node{.id = name(axis, level),
                      .at = {6.0 * static_cast<double>(axis), 3.0 * static_cast<double>(level)}};
            if (level == 0) node.support = Support{.kind = SupportKind::Fixed};
            model_.add(std::move(node));
        }
        if (level == 0) return;
        for (std::size_t axis = 0; axis <= size_.bays; ++axis)
            add_member("c" + name(axis, level), column_, {at(axis, level - 1), at(axis, level)});
        for (std::size_t axis = 0; axis < size_.bays; ++axis) {
            const MemberId beam = add_member("b" + name(axis, level), beam_, {at(axis, level), at(axis + 1, level)});
            load_case_.members.push_back(
                {.member = beam, .load = DistributedLoad{.values = {{.dof = Dof::uy, .start = -20.0}}}});
        }
        load_case_.nodes.push_back({.node = at(0, level), .components = {{.dof = Dof::ux, .value = 10.0}}});
    }

    void finish() { model_.add(std::move(load_case_)); }

private:
    struct Kind {
        MaterialId material;
        SectionId section;
    };

    static std::string name(std::size_t axis, std::size_t level)
    {
        return std::to_string(level) + "/" + std::to_string(axis);
    }
    NodeId at(std::size_t axis, std::size_t level) const { return NodeId(level * (size_.bays + 1) + axis); }
    MemberId add_member(std::string id, Kind kind, std::array<NodeId, 2> nodes)
    {
        return model_.add(
            Member{.id = std::move(id), .nodes = nodes, .material = kind.material, .section = kind.section});
    }

    FrameSize size_;
    Model& model_;
    Kind column_, beam_;
    LoadCase load_case_;
};

/// N, V and M at 11 stations of the members from `first` up to `last`, summed so that none is left out.
double sum_of_stations(const CaseResult& result, std::size_t first, std::size_t last)
{
    CurveReader reader(result);
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        const Curve& curve = reader.read(MemberId(i));
        const double step = curve.length() / 10.0;
        for (int station = 0; station <= 10; ++station) {
            const SectionForces forces = curve.forces(step * station, station < 10 ? Side::After : Side::Before);
            sum += forces.N + forces.Vy + forces.Mz;
        }
    }
    return sum;
}

/// Two halves at the same time: readers of one case share nothing that changes.
double sum_of_stations(const CaseResult& result, std::size_t n_members)
{
    const std::size_t half = n_members / 2;
    auto first = std::async(std::launch::async, [&] { return sum_of_stations(result, 0, half); });
    const double second = sum_of_stations(result, half, n_members);
    return first.get() + second;
}

} // namespace

double peak_megabytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

Model plane_frame(FrameSize size)
{
    Model model;
    model.title = "Plane frame";
    model.analysis = AnalysisKind::Frame2d;
    FrameBuilder builder(size, model);
    for (std::size_t level = 0; level <= size.storeys; ++level) builder.add_level(level);
    builder.finish();
    return model;
}

FrameBench bench_frame(FrameSize size, const AnalysisOptions& options)
{
    Model model = plane_frame(size);
    FrameBench bench;
    Stopwatch watch;
    LinearStatic analysis(model, options);
    const Results results = analysis.solve(model);
    const double solved = watch.lap();
    bench.sum = sum_of_stations(results[CaseId(0)], model.members.size());
    bench.recover = watch.lap();
    bench.total = solved + bench.recover;
    bench.statistics = analysis.statistics();
    bench.peak_mb = peak_megabytes();
    const NodeId top_left((size.bays + 1) * size.storeys);
    bench.sway = results[CaseId(0)].displacement(top_left)[index(Dof::ux)];

    for (NodeLoad& load : model.load_cases[0].nodes) load.components[0].value = 12.5;
    watch.lap();
    const Results other = analysis.solve(model);
    bench.resolve = watch.lap();
    return bench;
}

} // namespace cli
