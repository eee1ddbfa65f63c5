#include "apps/cli/bench.h"

#include <iomanip>
#include <sstream>
#include <string>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/bench_frame.h"
#include "apps/cli/bench_halfedge.h"
#include "apps/cli/bench_mesh.h"
#include "apps/cli/bench_plane.h"
#include "apps/cli/bench_regions.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/solver/blas.h"

namespace cli {

namespace {

class Bench : public Subcommand {
public:
    std::string_view name() const override { return "bench"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    ExitStatus frame(Console& console) const;
    ExitStatus plane(Console& console) const;
    std::string halfedge(const ui::Catalogue& tr) const;
    std::string regions(const ui::Catalogue& tr) const;
    std::string mesh(const ui::Catalogue& tr) const;

    std::string what_, bays_ = "19", storeys_ = "50", solver_ = "automatic", n_, triangles_ = "100000", element_ = "Q4";
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
            tr("`bench plane` fills the unit square with N by N elements in plane stress, its left side fixed, its right side "
               "loaded upwards, and prints how long each phase took, from the mesh to the stresses at 4 points of each "
               "element, and uy in the middle of the right side.") +
            "\n\n" +
            tr("`bench regions` divides a square of 2^20 by random straight lines, which are inserted one after the "
               "other, and prints the vertices, edges, regions and components that they make."),
        {{"cremona bench frame --bays 249 --storeys 400", tr("300 000 degrees of freedom.")},
         {"cremona bench frame --bays 19 --storeys 50 --solver ldlt --json", tr("Another solver, for a program.")},
         {"cremona bench halfedge --n 1000", tr("2 002 001 Euler operators.")},
         {"cremona bench mesh --triangles 1000000 --json", tr("A million triangles.")},
         {"cremona bench plane --n 500 --element Q4 --json", tr("Half a million displacements.")},
         {"cremona bench regions --segments 1000 --kind long --seed 1 --json",
          tr("A thousand lines that cross everywhere.")}}};
}

void Bench::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("WHAT", what_, tr("what is built: frame, halfedge, mesh, plane or regions")).option_text(" ");
    options.add_option("--bays", bays_, tr("how many bays the frame has (default 19)")).option_text("B");
    options.add_option("--storeys", storeys_, tr("how many storeys the frame has (default 50)")).option_text("S");
    options
        .add_option("--solver", solver_,
                    tr("who solves K u = f: automatic (the fastest, default), skyline, multifrontal, ldlt or cholmod"))
        .option_text("NAME");
    options
        .add_option("--n", n_,
                    tr("how many quadrilaterals or elements lie along each side (default 1000; 100 of `plane`)"))
        .option_text("N");
    options.add_option("--element", element_, tr("of `plane`: T3, T6, Q4 (default), Q8 or Q9")).option_text("KIND");
    options.add_option("--triangles", triangles_, tr("how many triangles fill the square, about (default 100000)"))
        .option_text("N");
    options.add_option("--segments", segments_, tr("how many lines divide the square (default 1000)")).option_text("N");
    options.add_option("--kind", kind_, tr("the lines are long (default), from anywhere to anywhere, or short"))
        .option_text("KIND");
    options.add_option("--seed", seed_, tr("what the random numbers begin with (default 1)")).option_text("S");
    options.add_flag("--one-by-one", is_one_by_one_, tr("ask for the number of regions after every line"));
    options.add_flag("--json", is_json_, tr("print JSON with every digit instead of tables"));
}

/// The shapes of plane elements, by their names.
std::optional<femoop::ShapeKind> element_named(std::string_view name)
{
    for (const femoop::ShapeKind kind : femoop::shape_kinds())
        if (femoop::name(kind) == name && !name.starts_with("Line")) return kind;
    return std::nullopt;
}

/// Of a frame or a plate.
template <class Bench> void write_phases(femoop::JsonWriter& json, const Bench& bench)
{
    const femoop::AnalysisStatistics& statistics = bench.statistics;
    json.member("dofs", statistics.dofs)
        .member("assemble", statistics.assemble)
        .member("order", statistics.order)
        .member("factor", statistics.factor)
        .member("solve", statistics.solve)
        .member("recover", bench.recover)
        .member("total", bench.total)
        .member("peak_mb", bench.peak_mb)
        .member("nnz_factor", statistics.factor_nonzeros);
}

std::string json(const FrameBench& bench)
{
    femoop::JsonWriter json;
    json.begin_object();
    write_phases(json, bench);
    json.member("sway", bench.sway).end();
    return json.take();
}

std::string json(const PlaneBench& bench)
{
    femoop::JsonWriter json;
    json.begin_object();
    write_phases(json, bench);
    json.member("tip", bench.tip).end();
    return json.take();
}

/// Lines of a number, its unit and what it is.
class BenchTable {
public:
    explicit BenchTable(const ui::Catalogue& tr) : tr_(tr) { text_ << std::fixed; }

    void line(double value, int decimals, std::string_view unit, const std::string& what)
    {
        text_ << std::setw(16) << std::setprecision(decimals) << value << ' ' << std::left << std::setw(4) << unit
              << what << std::right << '\n';
    }
    void phases(const femoop::AnalysisStatistics& statistics, double recover)
    {
        line(static_cast<double>(statistics.dofs), 0, "", tr_("dofs"));
        line(statistics.assemble, 6, "s", tr_("assemble"));
        line(statistics.order, 6, "s", tr_("order"));
        line(statistics.factor, 6, "s", tr_("factor"));
        line(statistics.solve, 6, "s", tr_("solve"));
        line(recover, 6, "s", tr_("recover"));
    }
    void size(const femoop::AnalysisStatistics& statistics, double peak_mb)
    {
        line(peak_mb, 1, "MB", tr_("peak of memory"));
        line(static_cast<double>(statistics.factor_nonzeros), 0, "", tr_("nonzeros of the factor"));
    }
    std::string text(const femoop::AnalysisStatistics& statistics) const
    {
        const femoop::Blas blas = femoop::blas();
        return text_.str() +
               tr_("solver {solver}; BLAS: {blas}; threads: {threads}",
                   {{"solver", statistics.solver}, {"blas", blas.name}, {"threads", std::to_string(blas.threads)}}) +
               "\n";
    }

private:
    const ui::Catalogue& tr_;
    std::ostringstream text_;
};

std::string table(const FrameBench& bench, const ui::Catalogue& tr)
{
    BenchTable table(tr);
    table.phases(bench.statistics, bench.recover);
    table.line(bench.total, 6, "s", tr("all, from the model in memory to the last station"));
    table.line(bench.resolve, 6, "s", tr("again with other loads"));
    table.size(bench.statistics, bench.peak_mb);
    table.line(bench.sway, 9, "m", tr("ux of the top left node"));
    return table.text(bench.statistics);
}

std::string table(const PlaneBench& bench, const ui::Catalogue& tr)
{
    BenchTable table(tr);
    table.phases(bench.statistics, bench.recover);
    table.line(bench.total, 6, "s", tr("all, from the mesh in memory to the last stress"));
    table.size(bench.statistics, bench.peak_mb);
    table.line(bench.tip, 9, "", tr("uy in the middle of the right side"));
    return table.text(bench.statistics);
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

ExitStatus Bench::plane(Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const auto element = element_named(element_);
    if (!element) throw unknown_choice("--element", element_, {"T3", "T6", "Q4", "Q8", "Q9"}, tr);
    const long n = whole_number("--n", n_.empty() ? "100" : n_, {1, 1500}, tr);
    const femoop::AnalysisOptions options{.solver = solver_named(solver_, tr)};
    try {
        const PlaneBench bench = bench_plane(unit_square(static_cast<std::size_t>(n), *element), options);
        console.print(is_json_ ? json(bench) : table(bench, tr));
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, "cremona bench plane", console);
    }
    return ExitStatus::Done;
}

std::string Bench::halfedge(const ui::Catalogue& tr) const
{
    const long n = whole_number("--n", n_.empty() ? "1000" : n_, {1, 10000}, tr);
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
    if (what_ == "plane") return plane(console);
    if (what_.empty())
        throw UsageError(tr("nothing to build is given; add `frame`, `halfedge`, `mesh`, `plane` or `regions`"));
    if (what_ == "halfedge") console.print(halfedge(tr));
    else if (what_ == "mesh") console.print(mesh(tr));
    else if (what_ == "regions") console.print(regions(tr));
    else throw unknown_choice("WHAT", what_, {"frame", "halfedge", "mesh", "plane", "regions"}, tr);
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> bench_command() { return std::make_unique<Bench>(); }

} // namespace cli
