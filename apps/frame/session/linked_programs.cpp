#include "apps/frame/session/linked_programs.h"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "apps/cross/document/file.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/session/other_programs.h"
#include "apps/mohr/document/file.h"
#include "femoop/edit/excerpt.h"
#include "femoop/edit/moving_load_change.h"
#include "femoop/io/model_file.h"
#include "femoop/model/check/check.h"

namespace frame {

using ui::Message;
using ui::translatable;

namespace {

constexpr std::string_view circle = "mohr";

std::optional<mohr::Document> state_of(const std::string& text)
{
    const auto read = mohr::read_file_text(text);
    const auto* const document = std::get_if<mohr::Document>(&read);
    return document != nullptr ? std::optional(*document) : std::nullopt;
}

/// The section has changed here since the circle had the same.
bool has_other_section(const ui::LinkedCopy& copy)
{
    const auto now = state_of(copy.sent()), then = state_of(copy.shared());
    return now && then && now->section != then->section;
}

/// Nothing where the text is none of a structure.
std::optional<femoop::Model> model_of(const std::string& text)
{
    try {
        return cross::read_document(text).model;
    } catch (const femoop::ModelError&) {
        return std::nullopt;
    }
}

std::vector<femoop::MemberId> members_named(const femoop::Model& model, const std::vector<std::string>& names)
{
    std::vector<femoop::MemberId> members;
    for (std::size_t m = 0; m < model.members.size(); ++m)
        if (names.empty() || std::ranges::find(names, model.members[m].id) != names.end()) members.emplace_back(m);
    return members;
}

/// The case with what acts on parts that the other model has too, by their names.
femoop::LoadCase carried(femoop::LoadCase load_case, const femoop::Model& from, const femoop::Model& to)
{
    const auto find_node = [&](femoop::NodeId id) { return to.find_node(from[id].id); };
    const auto find_member = [&](femoop::MemberId id) { return to.find_member(from[id].id); };
    std::erase_if(load_case.nodes, [&](const auto& load) { return !find_node(load.node); });
    std::erase_if(load_case.settlements, [&](const auto& load) { return !find_node(load.node); });
    std::erase_if(load_case.members, [&](const auto& load) { return !find_member(load.member); });
    for (auto& load : load_case.nodes) load.node = *find_node(load.node);
    for (auto& settlement : load_case.settlements) settlement.node = *find_node(settlement.node);
    for (auto& load : load_case.members) load.member = *find_member(load.member);
    return load_case;
}

femoop::Combination carried(femoop::Combination combination, const femoop::Model& from, const femoop::Model& to)
{
    const auto find_case = [&](femoop::CaseId id) { return to.find_case(from.case_name(id)); };
    std::erase_if(combination.terms, [&](const auto& term) { return !find_case(term.of); });
    for (auto& term : combination.terms) term.of = *find_case(term.of);
    return combination;
}

/// The expected results of what the other model has too, by its names.
std::vector<femoop::Expected> carried(const std::vector<femoop::Expected>& expected, const femoop::Model& from,
                                      const femoop::Model& to)
{
    std::vector<femoop::Expected> found;
    for (femoop::Expected result : expected) {
        if (result.load_case && !(result.load_case = to.find_case(from.case_name(*result.load_case)))) continue;
        if (result.node && !(result.node = to.find_node(from[*result.node].id))) continue;
        if (result.member && !(result.member = to.find_member(from[*result.member].id))) continue;
        found.push_back(std::move(result));
    }
    return found;
}

/// What is expected where nothing of the kind is left, such as a reaction of a support that is gone.
void erase_what_lost_its_place(femoop::Model& model)
{
    std::set<std::size_t> lost;
    for (const femoop::Fault& fault : femoop::check(model)) {
        const std::optional<FaultPlace> place = place_of(fault);
        if (is_error(fault) && place && place->steps.front().key == "expected" && place->steps.front().index)
            lost.insert(*place->steps.front().index);
    }
    std::size_t i = 0;
    std::erase_if(model.expected, [&](const femoop::Expected&) { return lost.contains(i++); });
}

/// What was not handed over stays as it is here.
void keep_what_is_beside(femoop::Model& next, const femoop::Model& now)
{
    next.title = now.title;
    next.notes = now.notes;
    next.expected = carried(now.expected, now, next);
    next.moving_loads = femoop::carried_over(now, next);
    next.extra = now.extra;
    erase_what_lost_its_place(next);
}

/// Faulty cases were handed over empty, so they keep what they have.
void keep_blank_cases(femoop::Model& next, const Session& session)
{
    const femoop::Model& now = session.model();
    for (const BlankCase& blank : session.solution().blank) {
        const auto to = next.find_case(now.case_name(blank.id));
        const std::size_t n = now.load_cases.size(), n_next = next.load_cases.size();
        if (!to || (blank.id.index < n) != (to->index < n_next)) continue;
        if (to->index < n_next) next.load_cases[to->index] = carried(now.load_cases[blank.id.index], now, next);
        else next.combinations[to->index - n_next] = carried(now.combinations[blank.id.index - n], now, next);
    }
}

} // namespace

void LinkedPrograms::add(ui::Link link, const Session& session, const ui::ExportToApp& handed)
{
    const femoop::Model& model = session.model();
    Handed what{session.number(), handed.program, {}, 0.0, model.case_name(session.view.load_case)};
    if (handed.program == circle) {
        const auto cut = cut_for_circle(session);
        if (!cut) return;
        what.members = {model[cut->member].id};
        what.x = cut->x;
    } else if (const auto members = chosen_members(session); members.size() < model.members.size()) {
        for (const femoop::MemberId member : members) what.members.push_back(model[member].id);
    }
    all_.push_back(
        {std::move(what), ui::LinkedCopy(std::move(link), handed.document), session.generation(), handed.document});
}

std::string LinkedPrograms::text_now(const Linked& linked, const Session& session)
{
    const Handed& handed = linked.handed;
    const auto members = members_named(session.model(), handed.members);
    const auto load_case = session.model().find_case(handed.load_case);
    if (members.empty() || !load_case) return linked.text; // it has gone: what was handed over stays
    const auto& results = session.solution().results;
    const double x = results ? std::min(handed.x, results->geometry(members.front()).length) : handed.x;
    const Offer offer = handed.program == circle ? circle_at(session, {members.front(), x}, *load_case)
                                                 : moment_distribution(session, members, *load_case);
    const auto* const exported = std::get_if<ui::ExportToApp>(&offer);
    return exported != nullptr ? exported->document : linked.text;
}

bool LinkedPrograms::is_news(const Linked& linked, const Session& session, const std::string& other)
{
    if (linked.handed.program == circle) return section_from(session, linked.handed, other).has_value();
    const auto theirs = model_of(other), ours = model_of(linked.text);
    return theirs && ours &&
           femoop::write_model(femoop::structure_alone(*theirs)) != femoop::write_model(femoop::structure_alone(*ours));
}

// A section that was not taken over is not offered again because the circle has another force.
bool LinkedPrograms::is_declined(Linked& linked, const std::string& other)
{
    if (!linked.declined || linked.handed.program != circle) return false;
    const auto theirs = state_of(other), declined = state_of(*linked.declined);
    if (theirs && declined && theirs->section == declined->section) return true;
    linked.declined.reset();
    return false;
}

void LinkedPrograms::tick(double seconds, const Workspace& workspace)
{
    std::erase_if(all_, [](const Linked& linked) { return linked.copy.is_cut(); });
    for (Linked& linked : all_) {
        const Session& session = workspace.session;
        if (linked.handed.session != session.number() || session.history().is_dragging()) continue;
        if (linked.generation != session.generation()) {
            linked.text = text_now(linked, session);
            linked.generation = session.generation();
        }
        linked.copy.tick(seconds, {[&] { return linked.text; },
                                   [&](const std::string& other) {
                                       return !is_declined(linked, other) && is_news(linked, session, other);
                                   }});
    }
}

const LinkedPrograms::Linked* LinkedPrograms::offering_one(const Workspace& workspace) const
{
    const auto found = std::ranges::find_if(all_, [&](const Linked& linked) {
        return linked.handed.session == workspace.session.number() && linked.copy.offered();
    });
    return found == all_.end() ? nullptr : &*found;
}

std::string_view LinkedPrograms::offering(const Workspace& workspace) const
{
    const Linked* const linked = offering_one(workspace);
    if (linked == nullptr) return {};
    if (linked->handed.program == circle)
        return has_other_section(linked->copy)
                   ? translatable(
                         "Mohr's circle has changed the section, and so have you: taking over undoes what changed here")
                   : translatable("Mohr's circle has changed the section");
    if (linked->copy.would_undo_own_change())
        return translatable(
            "Moment distribution has changed the structure, and so have you: taking over undoes what changed here");
    return translatable("Moment distribution has changed the structure");
}

void LinkedPrograms::keep(const Workspace& workspace)
{
    const Linked* const from = offering_one(workspace);
    for (Linked& linked : all_) {
        if (&linked != from) continue;
        linked.declined = linked.copy.offered();
        linked.copy.keep();
    }
}

void LinkedPrograms::adopt(Workspace& workspace)
{
    const Linked* const from = offering_one(workspace);
    for (Linked& linked : all_) {
        if (&linked != from) continue;
        const std::string text = linked.copy.accept();
        if (linked.handed.program == circle) adopt_section(workspace.session, linked.handed, text);
        else adopt_structure(workspace.session, linked.handed, text);
        return;
    }
}

/// What the section of the circle would be in the frame, where that is another than it has.
std::optional<LinkedPrograms::NewSection> LinkedPrograms::section_from(const Session& session, const Handed& handed,
                                                                       const std::string& text)
{
    const auto members = members_named(session.model(), handed.members);
    const auto state = state_of(text);
    const auto id = members.empty() ? std::nullopt : session.model()[members.front()].section;
    if (!state || !id) return std::nullopt;
    const femoop::Section& now = session.model()[*id];
    const femoop::Units& units = session.model().units;
    const auto next = section_named(state->section, now, units);
    if (!next || section_text(*next, units) == section_text(now, units)) return std::nullopt;
    return NewSection{*id, *next};
}

void LinkedPrograms::adopt_section(Session& session, const Handed& handed, const std::string& text)
{
    const auto taken = section_from(session, handed, text);
    if (!taken) return;
    session.change_soundly(
        {{translatable("Section {name} from Mohr's circle"), {{"name", taken->section.id}}},
         [taken = *taken](Document& document) { document.model.sections[taken.id.index] = taken.section; }});
}

void LinkedPrograms::adopt_structure(Session& session, const Handed& handed, const std::string& text)
{
    auto model = model_of(text);
    if (!model) return;
    if (!handed.members.empty()) {
        session.notify(translatable("Moment distribution has a part of the structure alone, which is not taken back; "
                                    "hand over the whole structure instead"));
        return;
    }
    keep_blank_cases(*model, session);
    keep_what_is_beside(*model, session.model());
    session.change_soundly({translatable("Structure from moment distribution"),
                            [next = *std::move(model)](Document& document) { document.model = next; }});
}

} // namespace frame
