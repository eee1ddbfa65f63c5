#include "apps/cli/bench.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <sstream>
#include <string>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/bench_frame.h"
#include "apps/cli/bench_halfedge.h"
#include "apps/cli/bench_mesh.h"
#include "apps/cli/bench_regions.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/solver/blas.h"

namespace cli {

namespace {

class Bench : public Subcommand {
public:
    std::string_view name() const override { return "bench"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(CLI::App& app, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    ExitStatus frame(Console& console) const;
    std::string halfedge(const ui::Catalogue& tr) const;
    std::string regions(const ui::Catalogue& tr) const;
    std::string mesh(const ui::Catalogue& tr) const;

    std::string what_, bays_ = "19", storeys_ = "50", solver_ = "automatic", n_ = "1000", triangles_ = "100000";
    std::string segments_ = "1000", kind_ = "long", seed_ = "1";
    bool is_json_ = false, is_one_by_one_ = false;
};

HelpText Bench::help(const ui::Catalogue& tr) const
{
    return {
        tr("time the analysis of a large structure, or the making of a large solid, in memory"),
        tr("`bench frame` builds a plane frame (bays of 6 m, storeys of 3 m, fixed bases, 20 kN/m on every beam, "
           "10 kN to the right at every level), solves it, recovers N, V and M at 11 stations of every member, "
           "and prints how long each phase took, the peak of memory and the sway of the top left node.") +
            "\n\n" +
            tr("`bench halfedge` draws a grid of N by N quadrilaterals by the Euler operators MVFS, "
               "MEV and MEF, without and with the journal, undoes all of it and validates it.") +
            "\n\n" +
            tr("`bench mesh` fills the unit square with five round holes with about N triangles, no angle below 30 degrees, "
               "and prints how many triangles and vertices there are, the smallest angle, and the time of meshing.") +
            "\n\n" +
            tr("`bench regions` divides a square of 2^20 by random straight lines, which are inserted one after the "
               "other, and prints the vertices, edges, regions and components that they make."),
        {{"cremona bench frame --bays 249 --storeys 400", tr("300 000 degrees of freedom.")},
         {"cremona bench frame --bays 19 --storeys 50 --solver ldlt --json", tr("Another solver, for a program.")},
         {"cremona bench halfedge --n 1000", tr("2 002 001 Euler operators.")},
         {"cremona bench mesh --triangles 1000000 --json", tr("A million triangles.")},
         {"cremona bench regions --segments 1000 --kind long --seed 1 --json",
          tr("A thousand lines that cross everywhere.")}}};
}

void Bench::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_option("WHAT", what_, tr("what is built: frame, halfedge, mesh or regions"))->option_text(" ");
    app.add_option("--bays", bays_, tr("how many bays the frame has (default 19)"))->option_text("B");
    app.add_option("--storeys", storeys_, tr("how many storeys the frame has (default 50)"))->option_text("S");
    app.add_option("--solver", solver_,
                   tr("who solves K u = f: automatic (the fastest, default), skyline, multifrontal, ldlt or cholmod"))
        ->option_text("NAME");
    app.add_option("--n", n_, tr("how many quadrilaterals lie along each side of the grid (default 1000)"))
        ->option_text("N");
    app.add_option("--triangles", triangles_, tr("how many triangles fill the square, about (default 100000)"))
        ->option_text("N");
    app.add_option("--segments", segments_, tr("how many lines divide the square (default 1000)"))->option_text("N");
    app.add_option("--kind", kind_, tr("the lines are long (default), from anywhere to anywhere, or short"))
        ->option_text("KIND");
    app.add_option("--seed", seed_, tr("what the random numbers begin with (default 1)"))->option_text("S");
    app.add_flag("--one-by-one", is_one_by_one_, tr("ask for the number of regions after every line"));
    app.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
}

std::string json(const FrameBench& bench)
{
    femoop::JsonWriter json;
    json.begin_object()
        .member("dofs", bench.statistics.dofs)
        .member("assemble", bench.statistics.assemble)
        .member("order", bench.statistics.order)
        .member("factor", bench.statistics.factor)
        .member("solve", bench.statistics.solve)
        .member("recover", bench.recover)
        .member("total", bench.total)
        .member("peak_mb", bench.peak_mb)
        .member("nnz_factor", bench.statistics.factor_nonzeros)
        .member("sway", bench.sway)
        .end();
    return json.take();
}

std::string table(const FrameBench& bench, const ui::Catalogue& tr)
{
    std::ostringstream text;
    text << std::fixed;
    const auto line = [&](double value, int decimals, std::string_view unit, const std::string& what) {
        text << std::setw(16) << std::setprecision(decimals) << value << ' ' << std::left << std::setw(4) << unit
             << what << std::right << '\n';
    };
    line(static_cast<double>(bench.statistics.dofs), 0, "", tr("dofs"));
    line(bench.statistics.assemble, 6, "s", tr("assemble"));
    line(bench.statistics.order, 6, "s", tr("order"));
    line(bench.statistics.factor, 6, "s", tr("factor"));
    line(bench.statistics.solve, 6, "s", tr("solve"));
    line(bench.recover, 6, "s", tr("recover"));
    line(bench.total, 6, "s", tr("all, from the model in memory to the last station"));
    line(bench.resolve, 6, "s", tr("again with other loads"));
    line(bench.peak_mb, 1, "MB", tr("peak of memory"));
    line(static_cast<double>(bench.statistics.factor_nonzeros), 0, "", tr("nonzeros of the factor"));
    line(bench.sway, 9, "m", tr("ux of the top left node"));
    const femoop::Blas blas = femoop::blas();
    return text.str() +
           tr("solver {solver}; BLAS: {blas}; threads: {threads}",
              {{"solver", bench.statistics.solver}, {"blas", blas.name}, {"threads", std::to_string(blas.threads)}}) +
           "\n";
}

std::string json(const HalfEdgeBench& bench)
{
    femoop::JsonWriter json;
    json.begin_object()
        .member("operators", bench.operators)
        .member("build", bench.build)
        .member("build_journaled", bench.build_journaled)
        .member("undo", bench.undo)
        .member("validate", bench.validate)
        .member("bytes_per_edge", bench.bytes_per_edge)
        .end();
    return json.take();
}

std::string table(const HalfEdgeBench& bench, const ui::Catalogue& tr)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(6);
    text << std::setw(16) << bench.operators << ' ' << "    " << tr("operators") << '\n';
    const auto line = [&](double time, const std::string& what) {
        text << std::setw(16) << time << " s   " << what << '\n';
    };
    line(bench.build, tr("build"));
    line(bench.build_journaled, tr("build, with the journal written"));
    line(bench.undo, tr("undo all of it"));
    line(bench.validate, tr("validate"));
    text << std::setprecision(1) << std::setw(16) << bench.bytes_per_edge << " B   " << tr("an edge, points included")
         << '\n';
    return text.str();
}

std::string json(const RegionBench& bench)
{
    femoop::JsonWriter json;
    json.begin_object()
        .member("vertices", bench.counts.vertices)
        .member("edges", bench.counts.edges)
        .member("regions", bench.counts.regions)
        .member("components", bench.counts.components)
        .member("seconds", bench.seconds)
        .member("slowest_insertion", bench.slowest_insertion)
        .end();
    return json.take();
}

std::string table(const RegionBench& bench, const ui::Catalogue& tr)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(6);
    const auto count = [&](std::size_t n, const std::string& what) {
        text << std::setw(16) << n << "     " << what << '\n';
    };
    count(bench.counts.vertices, tr("vertices"));
    count(bench.counts.edges, tr("edges"));
    count(bench.counts.regions, tr("regions"));
    count(bench.counts.components, tr("components"));
    text << std::setw(16) << bench.seconds << " s   " << tr("all insertions") << '\n';
    text << std::setw(16) << bench.slowest_insertion << " s   " << tr("the slowest insertion") << '\n';
    return text.str();
}

std::string json(const MeshBench& bench)
{
    femoop::JsonWriter json;
    json.begin_object().member("triangles", bench.triangles).member("vertices", bench.vertices);
    json.member("min_angle", bench.min_angle).member("seconds", bench.seconds).end();
    return json.take();
}

std::string table(const MeshBench& bench, const ui::Catalogue& tr)
{
    std::ostringstream text;
    text << std::setw(16) << bench.triangles << "     " << tr("triangles") << '\n';
    text << std::setw(16) << bench.vertices << "     " << tr("vertices") << '\n';
    text << std::fixed << std::setprecision(3) << std::setw(16) << bench.min_angle << " °   " << tr("smallest angle")
         << '\n';
    text << std::setprecision(6) << std::setw(16) << bench.seconds << " s   " << tr("meshing") << '\n';
    return text.str();
}

ExitStatus Bench::frame(Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    constexpr WholeRange range{1, 5000};
    const FrameSize size{.bays = static_cast<std::size_t>(whole_number("--bays", bays_, range, tr)),
                         .storeys = static_cast<std::size_t>(whole_number("--storeys", storeys_, range, tr))};
    const femoop::AnalysisOptions options{.solver = solver_named(solver_, tr)};
    try {
        const FrameBench bench = bench_frame(size, options);
        console.print(is_json_ ? json(bench) : table(bench, tr));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, "cremona bench frame", console);
    }
    return ExitStatus::Done;
}

std::string Bench::halfedge(const ui::Catalogue& tr) const
{
    const long n = whole_number("--n", n_, {1, 10000}, tr);
    const HalfEdgeBench bench = bench_halfedge(static_cast<std::size_t>(n));
    return is_json_ ? json(bench) : table(bench, tr);
}

std::string Bench::regions(const ui::Catalogue& tr) const
{
    if (kind_ != "long" && kind_ != "short") throw unknown_choice("--kind", kind_, {"long", "short"}, tr);
    const RegionLines lines{.n = static_cast<std::size_t>(whole_number("--segments", segments_, {1, 100000}, tr)),
                            .is_long = kind_ == "long",
                            .seed = static_cast<std::uint64_t>(whole_number("--seed", seed_, {0, 1000000000}, tr))};
    const RegionBench bench = bench_regions(lines, is_one_by_one_);
    return is_json_ ? json(bench) : table(bench, tr);
}

std::string Bench::mesh(const ui::Catalogue& tr) const
{
    const long n = whole_number("--triangles", triangles_, {10, 5000000}, tr);
    const MeshBench bench = bench_mesh(static_cast<std::size_t>(n));
    return is_json_ ? json(bench) : table(bench, tr);
}

ExitStatus Bench::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (what_ == "frame") return frame(console);
    if (what_.empty()) throw UsageError(tr("nothing to build is given; add frame, halfedge, mesh or regions"));
    if (what_ == "halfedge") console.print(halfedge(tr));
    else if (what_ == "mesh") console.print(mesh(tr));
    else if (what_ == "regions") console.print(regions(tr));
    else throw unknown_choice("WHAT", what_, {"frame", "halfedge", "mesh", "regions"}, tr);
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> bench_command() { return std::make_unique<Bench>(); }

} // namespace cli
