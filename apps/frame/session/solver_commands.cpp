#include "apps/frame/session/solver_commands.h"

#include <array>
#include <functional>

namespace frame {

using femoop::Ordering;
using ui::Key;
using ui::translatable;

namespace {

bool shows_solver(const Workspace& workspace) { return workspace.bottom.shows(BottomContent::Solver); }

std::optional<ui::Message> why_not_step(const Workspace& workspace)
{
    if (!shows_solver(workspace)) return translatable("the solver is not shown; Ctrl+F4 shows it");
    if (workspace.solver.n_steps() == 0) return translatable("there is no front that walks");
    return std::nullopt;
}

void show_solver(Workspace& workspace, bool is_on)
{
    workspace.bottom = {is_on, workspace.bottom.table, BottomContent::Solver};
    workspace.solver.follow(workspace.session);
}

// Goes to a front, and rests there. \param wanted  of a show that is at its step
std::function<void(Workspace&)> go(std::size_t (*wanted)(const SolverShow&))
{
    return [wanted](Workspace& workspace) {
        workspace.solver.rest();
        workspace.solver.go_to(wanted(workspace.solver));
    };
}

using OrderEntry = ui::Choice<Ordering>;
constexpr std::array orders{
    OrderEntry{Ordering::Natural, "solver.natural", translatable("Eliminate in natural order")},
    OrderEntry{Ordering::CuthillMcKee, "solver.cuthill_mckee",
               translatable("Eliminate in reverse Cuthill-McKee order")},
    OrderEntry{Ordering::MinimumDegree, "solver.minimum_degree", translatable("Eliminate by minimum degree")},
    OrderEntry{Ordering::NestedDissection, "solver.nested_dissection", translatable("Eliminate by nested dissection")},
};

std::optional<Ordering> shown_order(const Workspace& workspace)
{
    return shows_solver(workspace) ? std::optional(workspace.solver.ordering()) : std::nullopt;
}

} // namespace

void add_solver_commands(CommandTable& table)
{
    Menu(table, translatable("Tables"))
        .toggle({"view.solver", translatable("The solver at work"), {{Key::F4, ui::ctrl}}}, shows_solver, show_solver);
    Menu unlisted(table, {});
    unlisted.step({"solver.first", translatable("First front")}, go([](const SolverShow&) -> std::size_t { return 0; }),
                  why_not_step);
    unlisted.step({"solver.previous", translatable("Previous front")},
                  go([](const SolverShow& show) { return show.step() == 0 ? 0 : show.step() - 1; }), why_not_step);
    unlisted.step({"solver.next", translatable("Next front")},
                  go([](const SolverShow& show) { return show.step() + 1; }), why_not_step);
    unlisted.step({"solver.last", translatable("Last front")},
                  go([](const SolverShow& show) { return show.n_steps(); }), why_not_step);
    unlisted.toggle(
        {"solver.play", translatable("Let the front walk")},
        [](const Workspace& workspace) { return workspace.solver.is_playing(); },
        [](Workspace& workspace, bool is_on) { is_on ? workspace.solver.play() : workspace.solver.rest(); },
        why_not_step);
    unlisted.choices(
        orders, shown_order, [](Workspace& workspace, Ordering order) { workspace.solver.choose(order); },
        why_not_step);
}

} // namespace frame
