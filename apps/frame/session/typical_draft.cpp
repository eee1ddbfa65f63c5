#include "apps/frame/session/typical_draft.h"

#include <algorithm>
#include <utility>

#include "femoop/model/quantity/quantity_parser.h"
#include "ui/text/number_format.h"

namespace frame {

using ui::translatable;

namespace {

/// A truss has normal forces to look at, a frame moments.
void exchange_forces(ShowSet& show, bool is_truss)
{
    show.insert(is_truss ? Show::N : Show::M);
    show.erase(is_truss ? Show::M : Show::N);
}

} // namespace

void TypicalDraft::open(Session& session)
{
    if (is_open_) return;
    session.settle();
    if (numbers_.empty())
        for (const TypicalStructure& structure : typical_structures()) numbers_.push_back(first_numbers(structure));
    is_open_ = true;
    show_before_ = session.view.show;
    session.selection.clear();
    choose_of_kind(session.model().analysis);
    show(session);
}

void TypicalDraft::choose_of_kind(femoop::AnalysisKind kind)
{
    const auto is_of_kind = [&](const TypicalStructure& s) { return s.model(first_numbers(s)).analysis == kind; };
    const auto all = typical_structures();
    const auto first = std::ranges::find_if(all, is_of_kind);
    if (!is_of_kind(structure()) && first != all.end()) chosen_ = static_cast<std::size_t>(first - all.begin());
}

void TypicalDraft::choose(Session& session, std::size_t structure)
{
    chosen_ = structure;
    show(session);
}

void TypicalDraft::set(Session& session, std::size_t place, double value)
{
    numbers_[chosen_][place] = value;
    show(session);
}

void TypicalDraft::set_distance(Session& session, double metres)
{
    const double before = std::exchange(distance_, metres);
    if (show(session)) distance_ = before;
}

void TypicalDraft::set_setting(Session& session, Setting setting)
{
    setting_ = setting;
    show(session);
}

void TypicalDraft::insert(Session& session)
{
    session.settle();
    is_open_ = false;
}

void TypicalDraft::cancel(Session& session)
{
    session.cancel();
    session.view.show = show_before_;
    is_open_ = false;
}

std::optional<ui::Message> TypicalDraft::show(Session& session)
{
    femoop::Model made = structure().model(numbers());
    made.title = session.view.tr(made.title);
    const femoop::Model& there = session.history().settled().model; // until the change
    const bool was_truss = femoop::is_truss(there.analysis), is_truss = femoop::is_truss(made.analysis);
    can_stand_beside_ = !there.nodes.empty() && there.analysis == made.analysis;
    const double gap = femoop::converted(distance_, femoop::dimension::length, {}, there.units);
    const auto command = [&](Document& document) {
        if (setting() == Setting::Beside) insert_beside(document, made, {gap, session.view.load_case});
        else put_in_place(document, made);
    };
    auto objection = session.change(
        {{translatable("Insert: {structure}"), {{"structure", ui::Message(structure().label)}}}, command, Step::Drag});
    session.draw_state.locked_scale.reset(); // another structure has another scale
    session.view.show = show_before_;
    if (is_truss != was_truss) exchange_forces(session.view.show, is_truss);
    return objection;
}

std::optional<std::string> TypicalDraft::run_command(Session& session, std::string_view verb, std::string_view argument)
{
    if (!is_open_) return "no typical structure is being chosen; begin with edit.template";
    if (verb == "choose") return choose_named(session, argument);
    if (verb == "set") return set_named(session, argument);
    if (verb == "replace") set_setting(session, Setting::InPlace);
    else if (verb == "insert") insert(session);
    else if (verb == "cancel") cancel(session);
    else return "cannot \"" + std::string(verb) + "\" it; known are choose, set, replace, insert, cancel";
    return std::nullopt;
}

std::optional<std::string> TypicalDraft::choose_named(Session& session, std::string_view id)
{
    const auto all = typical_structures();
    const auto found = std::ranges::find(all, id, &TypicalStructure::id);
    if (found == all.end()) return "no typical structure \"" + std::string(id) + "\"";
    choose(session, static_cast<std::size_t>(found - all.begin()));
    return std::nullopt;
}

std::optional<std::string> TypicalDraft::set_named(Session& session, std::string_view argument)
{
    const std::size_t blank = std::min(argument.find(' '), argument.size());
    const std::string_view id = argument.substr(0, blank);
    const auto value = ui::number_typed(argument.substr(blank));
    if (!value) return "no number in \"" + std::string(argument) + "\"";
    if (id == "distance") {
        set_distance(session, *value);
        return std::nullopt;
    }
    const auto found = std::ranges::find(structure().numbers, id, &TypicalNumber::id);
    if (found == structure().numbers.end()) return "no number \"" + std::string(id) + "\"";
    if (const auto reason = why_not(*found, *value)) return ui::Catalogue()(*reason);
    set(session, static_cast<std::size_t>(found - structure().numbers.begin()), *value);
    return std::nullopt;
}

} // namespace frame
