#include "apps/cli/euler.h"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/euler_json.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_file.h"
#include "apps/cli/solid_file.h"
#include "femoop/tabular/plain_text.h"
#include "topology/embedding/ring_plane.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/tables/table_text.h"
#include "topology/text/line_error.h"

namespace cli {

namespace {

using topology::NamedSolid;
using topology::ScriptRunner;

class Euler : public Subcommand {
public:
    std::string_view name() const override { return "euler"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void require_sensible(const ui::Catalogue& tr) const;
    bool prints_tables() const { return has_tables_ && !is_json_; }
    std::string run_on(ScriptRunner& runner, const Console& console) const;
    void save(const std::vector<NamedSolid>& solids, const Console& console) const;

    std::string script_, step_, obj_, to_script_, from_;
    bool is_json_ = false, has_tables_ = false;
};

HelpText Euler::help(const ui::Catalogue& tr) const
{
    return {
        tr("run a script of Euler operators and print the solids that come out"),
        tr("A script (.eul) makes solids step by step: "
           "one operator a line, such as `mev s1 f1 v1 v2 1 0 0`. Printed are the numbers of vertices, edges, faces, "
           "loops and shells, the genus, and whether V - E + F - (L - F) - 2 (S - G) is 0 and the structure is sound. "
           "A step that cannot be done says why, with its line, and changes nothing."),
        {{"cremona euler examples/cube.eul", tr("A cube by MVFS, MEV and MEF.")},
         {"cremona euler examples/cube.eul --step 3 --tables",
          tr("The half-edge tables after each of the first steps.")},
         {"cremona euler --from part.obj --to-script part.eul", tr("A script that makes the solid of a mesh.")}}};
}

void Euler::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("SCRIPT", script_, tr("the script (.eul); - is standard input; with --from it may be left out"))
        .option_text(" ");
    options.add_flag("--tables", has_tables_, tr("print the tables of the half-edge structure after each step"));
    options.add_option("--step", step_, tr("run the first N lines that are operators")).option_text("N");
    options.add_flag("--json", is_json_, tr("print JSON instead of tables"));
    options.add_option("--obj", obj_, tr("also write the solids as a mesh of polygons")).option_text("OUT.obj");
    options.add_option("--to-script", to_script_, tr("also write a script that makes the solids from nothing"))
        .option_text("OUT.eul");
    options
        .add_option("--from", from_, tr("begin with the solids of this file (.obj, .off, .eul); a mesh's is named s1"))
        .option_text("FILE");
}

std::string counts_table(const std::vector<NamedSolid>& solids, std::size_t n_steps, const ui::Catalogue& tr)
{
    tabular::Table table({tr("solid"), "V", "E", "F", "L", "S", "G", "V-E+F-(L-F)-2(S-G)", tr("sound")});
    for (const NamedSolid& solid : solids) {
        const topology::EulerCounts n = topology::euler_counts(solid.solid);
        const auto breach = topology::why_not_valid(solid.solid);
        std::vector<tabular::Cell> row{solid.name};
        for (const std::size_t count : {n.V, n.E, n.F, n.L, n.S, n.G}) row.emplace_back(std::to_string(count));
        row.emplace_back(std::to_string(n.formula()));
        row.emplace_back(breach ? tr("no") : tr("yes"));
        table.add_row(std::move(row));
    }
    return tr("steps: {n}", {{"n", std::to_string(n_steps)}}) + "\n" + tabular::plain_text(table);
}

/// The tables of every living solid, as the lecture prints them.
void append_tables(std::string& text, const ScriptRunner& runner)
{
    for (std::size_t i = 0; i < runner.solids().size(); ++i)
        if (runner.solids()[i].is_alive())
            topology::append_table_text(text, runner.solids()[i].solid,
                                        topology::place_among_living(runner.solids(), i));
}

void Euler::require_sensible(const ui::Catalogue& tr) const
{
    if (script_.empty() && from_.empty())
        throw UsageError(tr("a script is needed, or --from; see {command}", {{"command", "cremona euler --help"}}));
    if (!from_.empty() && !is_solid_file(from_))
        throw UsageError(tr("{option}: {file} is no file of solids; give it the extension {kinds}",
                            {{"option", "--from"}, {"file", from_}, {"kinds", ".obj, .off, .eul"}}));
    for (const auto& [option, file, kind] : {std::tuple{"--obj", obj_, ".obj"}, {"--to-script", to_script_, ".eul"}}) {
        if (file.empty()) continue;
        if (!file.ends_with(kind))
            throw UsageError(tr("{option}: {file} is no file of solids; give it the extension {kinds}",
                                {{"option", option}, {"file", file}, {"kinds", kind}}));
        require_writable(file, tr);
    }
}

/// A ring that does not lie in the plane of its face is told, not refused.
void tell_rings_off_plane(const ScriptRunner& now, std::string_view line, const Console& console)
{
    if (now.n_steps() == 0 || line.starts_with("undo") || line.starts_with("redo")) return;
    const NamedSolid& in = now.solids()[now[now.n_steps() - 1].solid];
    const auto found = off_plane(in.solid, change(in.solid.tables(), in.journal[in.journal.n_done() - 1]));
    if (!found) return;
    const std::string sentence = console.tr()(
        "{vertex} lies outside the plane of face {face}: the links are right, but no flat face has such a ring.",
        {{"vertex", in.names.vertices.of(found->vertex)}, {"face", in.names.faces.of(found->face)}});
    console.message(std::string(line) + ": " + sentence);
}

/// \returns what `--tables` prints; JSON has no tables
std::string Euler::run_on(ScriptRunner& runner, const Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    topology::ScriptOptions options;
    if (!step_.empty())
        options.most_steps = static_cast<std::size_t>(
            whole_number("--step", step_, {0, std::numeric_limits<long>::max()}, tr));
    std::string printed;
    options.after = [&](const ScriptRunner& now, std::string_view line) {
        tell_rings_off_plane(now, line, console);
        if (!prints_tables()) return;
        printed.append(printed.empty() ? "" : "\n").append(line).append("\n");
        append_tables(printed, now);
    };
    try {
        if (!script_.empty()) run_script(runner, text_of(script_, tr), options);
    } catch (const topology::LineError& fault) {
        throw UsageError(display_name(script_, tr) + ": " + fault.sentence(tr));
    }
    if (prints_tables() && printed.empty()) append_tables(printed, runner); // no step was run: what it began with
    return printed;
}

void Euler::save(const std::vector<NamedSolid>& solids, const Console& console) const
{
    for (const std::string& file : {obj_, to_script_}) {
        if (file.empty()) continue;
        save_solids(file, solids, console.tr());
        console.message(console.tr()("written: {file}", {{"file", file}}));
    }
}

ExitStatus Euler::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    require_sensible(tr);
    ScriptRunner runner;
    if (!from_.empty())
        for (NamedSolid& solid : load_solids(from_, tr)) runner.add(std::move(solid));
    std::string printed = run_on(runner, console);
    const std::vector<NamedSolid> solids = living_solids(runner);
    save(solids, console);
    if (is_json_) console.print(euler_json(solids, runner.n_steps()));
    else console.print(prints_tables() ? std::move(printed) : counts_table(solids, runner.n_steps(), tr));
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> euler_command() { return std::make_unique<Euler>(); }

} // namespace cli
