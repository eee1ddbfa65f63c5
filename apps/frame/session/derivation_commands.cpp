#include "apps/frame/session/derivation_commands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "apps/drawing/structure/members.h"
#include "apps/frame/session/train_commands.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

bool shows_derivation(const Workspace& workspace) { return workspace.bottom.shows(BottomContent::Derivation); }

// From the palette, where the pointer is on no number.
std::optional<femoop::MovingEffect> pinned_number(const Session& session)
{
    return session.pin ? foremost_effect(session.model(), *session.pin) : std::nullopt;
}

const std::optional<PointedNumber>& under_pointer(const Workspace& workspace)
{
    return workspace.menu_number ? workspace.menu_number : workspace.pointed_number;
}

std::optional<femoop::MovingEffect> meant_number(const Workspace& workspace)
{
    if (const auto& number = under_pointer(workspace)) return number->effect;
    // The panel that opened may have pushed the picture away from under the pointer.
    if (workspace.asked_number)
        if (auto asked = effect_in(workspace.session.model(), *workspace.asked_number)) return asked;
    return pinned_number(workspace.session);
}

/// The number is of an influence line, of what stands on it or will: nothing else is pointed at.
bool is_on_line(const Workspace& workspace)
{
    const auto& number = under_pointer(workspace);
    return workspace.session.shown_line() != nullptr && (!number || number->under);
}

/// The number is one of an envelope of trains: it is of a train that stands somewhere.
bool is_of_trains(const Workspace& workspace)
{
    const auto& number = under_pointer(workspace);
    return workspace.session.shows_train_envelope() && !(number && number->of) &&
           !workspace.session.influence.is_on(workspace.session.model());
}

bool has_train_number(const Workspace& workspace)
{
    const Session& session = workspace.session;
    const bool has_values = session.train_envelope.picture(session.model(), session.generation(),
                                                           session.results_view()) != nullptr;
    return has_values && under_pointer(workspace);
}

void open_player(Workspace& workspace)
{
    auto& notice = workspace.session.notice; // such as that no number is pointed at
    if (notice && notice->seconds_left) notice.reset();
    const BottomView& now = workspace.bottom;
    const bool is_derivation = now.shows(BottomContent::Derivation);
    std::optional<BottomContent> under = is_derivation ? now.under : std::nullopt;
    if (now.is_open && is_table_or_member(now.content)) under = now.content;
    workspace.bottom = {.is_open = true,
                        .table = now.table,
                        .content = BottomContent::Derivation,
                        .asks_for_keyboard = true,
                        .under = under};
}

/// Under the load that stands on the line, or is put at the ordinate that is pointed at.
void explain_on_line(Workspace& workspace)
{
    AskedLine& line = workspace.session.influence;
    if (const auto& number = under_pointer(workspace)) {
        if (number->under->is_unit_load) line.put_unit_load(number->under->place.position);
        else line.put_train(number->under->place);
    }
    workspace.refused_release.reset();
    workspace.asked_number.reset();
    workspace.derivation.ask_standing(workspace.session);
    open_player(workspace);
}

/// Of an envelope of trains the train that governs is stood on the influence line, with the sum of its forces times the
/// ordinates.
void explain_meant(Workspace& workspace)
{
    if (is_on_line(workspace)) return explain_on_line(workspace);
    const std::optional<PointedNumber> number = under_pointer(workspace);
    if (is_of_trains(workspace)) return ask_governing(workspace, number->effect, number->extreme);
    explain(workspace, number.value_or(PointedNumber{*meant_number(workspace)}));
}

Reason why_not_explain(const Workspace& workspace)
{
    if (const auto reason = workspace.session.why_no_results()) return reason;
    if (is_on_line(workspace)) {
        if (under_pointer(workspace) || workspace.session.influence.standing() != nullptr) return std::nullopt;
        return translatable("point at an ordinate of the line, or put a load on it (U, R)");
    }
    if (is_of_trains(workspace) && has_train_number(workspace)) return std::nullopt;
    if (is_of_trains(workspace))
        return translatable("an envelope of trains has section forces and reactions; point at one of them first");
    if (meant_number(workspace)) return std::nullopt;
    return translatable("point at a number of the picture or of a table of results first");
}

Reason why_not_derive(const Workspace& workspace)
{
    if (!shows_derivation(workspace)) return translatable("no number is explained; point at one and press W");
    return workspace.derivation.n_steps() > 0 ? std::nullopt : workspace.derivation.why_none();
}

Reason why_no_force_method(const Workspace& workspace)
{
    if (const auto reason = workspace.session.why_no_results()) return reason;
    if (!workspace.session.view.is_envelope) return std::nullopt;
    return translatable("an envelope has the numbers of several cases; choose one of them first");
}

Reason why_not_release_force(const Workspace& workspace)
{
    if (auto reason = why_no_force_method(workspace)) return reason;
    const auto meant = meant_number(workspace);
    if (!meant) return translatable("point at a support, or at a section of a diagram first");
    if (is_force(*meant)) return std::nullopt;
    return translatable("a displacement is no force; point at a support, or at a section of a diagram");
}

constexpr double same_section = 0.025; ///< of the member's length: sections that are nearer are one to the hand

double place_along(const femoop::Model& model, const femoop::MovingEffect& section)
{
    const double length = femoop::geometry_of(model, model[*section.member]).length;
    return femoop::along(*section.at, length) / length;
}

bool is_same_force(const femoop::Model& model, const femoop::MovingEffect& a, const femoop::MovingEffect& b)
{
    if (a.member != b.member || a.node != b.node || a.component != b.component || a.dof != b.dof) return false;
    return !a.at || !b.at || std::abs(place_along(model, a) - place_along(model, b)) <= same_section;
}

/// Of both components of a slanting support, which are one force.
femoop::MovingEffect larger_component(const Session& session, femoop::MovingEffect resultant)
{
    using femoop::Dof;
    const auto reaction = (*session.solution().results)[session.view.load_case].reaction(*resultant.node);
    const double fx = std::abs(reaction[femoop::index(Dof::ux)]), fy = std::abs(reaction[femoop::index(Dof::uy)]);
    resultant.dof = fx > fy ? Dof::ux : Dof::uy;
    return resultant;
}

/// Of a member's largest force that force at the section where it stands; of a resultant its larger component.
femoop::MovingEffect released_force(const Workspace& workspace, const femoop::MovingEffect& force)
{
    if (is_resultant(force)) return larger_component(workspace.session, force);
    if (force.quantity != femoop::ExpectedQuantity::Extreme) return force;
    const Session& session = workspace.session;
    const auto& number = under_pointer(workspace);
    const femoop::CaseId load_case = number && number->of ? *number->of : session.view.load_case;
    const femoop::Model model = solved_model(session.model(), session.solution());
    return femoop::derivation::derive(model, *session.solution().results, load_case, force).effect;
}

/// A bar is cut at its first end wherever it is pointed at: within, its parts could turn.
femoop::MovingEffect where_it_is_cut(const femoop::Model& model, femoop::MovingEffect force)
{
    if (force.member && drawing::is_bar(model, *force.member)) force.at = femoop::Position(femoop::Quantity(0.0));
    return force;
}

/// Redundants are released one by one; one that is released already is held again.
void release_or_hold(Workspace& workspace)
{
    const femoop::MovingEffect force = where_it_is_cut(workspace.session.model(),
                                                       released_force(workspace, *meant_number(workspace)));
    workspace.asked_number = NamedEffect(workspace.session.model(), force);
    std::vector<femoop::MovingEffect> redundants;
    if (shows_derivation(workspace)) redundants = workspace.derivation.redundants();
    const auto released = std::ranges::find_if(redundants, [&](const femoop::MovingEffect& one) {
        return is_same_force(workspace.session.model(), one, force);
    });
    if (released == redundants.end()) redundants.push_back(force);
    else redundants.erase(released);
    if (redundants.empty()) return close_derivation(workspace);
    workspace.refused_release = refused_release(workspace.session, redundants);
    if (const auto& refused = workspace.refused_release) {
        if (!refused->moves(workspace.session)) workspace.notify(refused->reason); // else it stands below the motion
        return;
    }
    explain_force_method(workspace, redundants);
}

std::function<void(Workspace&)> on_show(void (*move)(DerivationShow&))
{
    return [move](Workspace& workspace) {
        move(workspace.derivation);
        workspace.derivation.follow(workspace.session);
    };
}

std::function<void(Workspace&)> asks_for(Request request)
{
    return [request](Workspace& workspace) { workspace.requests.push_back(request); };
}

} // namespace

void explain(Workspace& workspace, const PointedNumber& number)
{
    workspace.refused_release.reset();
    workspace.asked_number = NamedEffect(workspace.session.model(), number.effect);
    workspace.derivation.ask(workspace.session, number);
    open_player(workspace);
}

void explain_force_method(Workspace& workspace, std::span<const femoop::MovingEffect> redundants)
{
    workspace.refused_release.reset();
    workspace.derivation.ask_force_method(workspace.session, redundants);
    open_player(workspace);
}

void close_derivation(Workspace& workspace)
{
    if (!shows_derivation(workspace)) return;
    workspace.bottom.is_open = workspace.bottom.under.has_value();
    workspace.bottom.content = workspace.bottom.under.value_or(BottomContent::Table);
    workspace.bottom.under.reset();
    workspace.derivation.clear();
}

void add_derivation_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step({"view.why", translatable("Why this number?"), {{Key::W, {}}}}, explain_meant, why_not_explain);
    menu.step({"view.release", translatable("Release this force, or hold it again"), {{Key::W, ui::shift}}},
              release_or_hold, why_not_release_force);
    menu.step(
        {"view.force_method", translatable("Force method")},
        [](Workspace& workspace) { explain_force_method(workspace, {}); }, why_no_force_method);
    Menu unlisted(table, {});
    unlisted.step({"derivation.first", translatable("First step of the derivation")},
                  on_show([](DerivationShow& show) { show.go_to(0); }), why_not_derive);
    unlisted.step({"derivation.previous", translatable("Previous step of the derivation")},
                  on_show([](DerivationShow& show) { show.go_back(); }), why_not_derive);
    unlisted.step({"derivation.next", translatable("Next step of the derivation")},
                  on_show([](DerivationShow& show) { show.go_on(); }), why_not_derive);
    unlisted.step({"derivation.last", translatable("Last step of the derivation")},
                  on_show([](DerivationShow& show) { show.go_to(show.n_steps()); }), why_not_derive);
    unlisted.step({"derivation.next_number", translatable("The next number of the same place")},
                  on_show([](DerivationShow& show) { show.choose_next(); }), why_not_derive);
    unlisted.step({"derivation.previous_number", translatable("The previous number of the same place")},
                  on_show([](DerivationShow& show) { show.choose_previous(); }), why_not_derive);
    unlisted.step({"derivation.copy", translatable("Copy the derivation as text")}, asks_for(Request::CopyDerivation),
                  why_not_derive);
    unlisted.step({"derivation.copy_latex", translatable("Copy the derivation as LaTeX")},
                  asks_for(Request::CopyDerivationAsLatex), why_not_derive);
    unlisted.step({"derivation.close", translatable("Close the derivation")}, close_derivation, why_not_derive);
}

} // namespace frame
