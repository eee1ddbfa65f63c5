#include "apps/frame/session/solver_commands.h"

#include <array>
#include <functional>

namespace frame {

using femoop::Ordering;
using ui::Key;
using ui::translatable;

namespace {

bool shows_solver(const Desk& desk) { return desk.bottom.shows(BottomContent::Solver); }

std::optional<ui::Phrase> why_not_step(const Desk& desk)
{
    if (!shows_solver(desk)) return translatable("the solver is not shown; Ctrl+F4 shows it");
    if (desk.solver.n_steps() == 0) return translatable("there is no front that walks");
    return std::nullopt;
}

void show_solver(Desk& desk, bool is_on)
{
    desk.bottom = {is_on, desk.bottom.table, BottomContent::Solver};
    desk.solver.follow(desk.session);
}

// Goes to a front, and rests there. \param wanted  of a show that is at its step
std::function<void(Desk&)> go(std::size_t (*wanted)(const SolverShow&))
{
    return [wanted](Desk& desk) {
        desk.solver.rest();
        desk.solver.go_to(wanted(desk.solver));
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

std::optional<Ordering> shown_order(const Desk& desk)
{
    return shows_solver(desk) ? std::optional(desk.solver.ordering()) : std::nullopt;
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
        {"solver.play", translatable("Let the front walk")}, [](const Desk& desk) { return desk.solver.is_playing(); },
        [](Desk& desk, bool is_on) { is_on ? desk.solver.play() : desk.solver.rest(); }, why_not_step);
    unlisted.choices(
        orders, shown_order, [](Desk& desk, Ordering order) { desk.solver.choose(order); }, why_not_step);
}

} // namespace frame
