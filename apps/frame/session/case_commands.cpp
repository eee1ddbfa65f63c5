#include "apps/frame/session/case_commands.h"

#include <algorithm>
#include <array>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/load_cases.h"

namespace frame {

using femoop::CaseId;
using femoop::Model;
using ui::Phrase;
using ui::Reason;
using ui::translatable;

namespace {

Phrase about_case(std::string_view sentence, const Session& session)
{
    return {sentence, {{"part", title(session.model(), part_of(session.model(), session.view.load_case))}}};
}

Reason needs_load_case(const Desk& desk)
{
    if (!desk.session.model().load_cases.empty()) return std::nullopt;
    return translatable("the model has no load case; add one first");
}

Reason needs_shown_case(const Desk& desk)
{
    if (const Reason reason = needs_load_case(desk)) return reason;
    if (!desk.session.view.is_envelope) return std::nullopt;
    return translatable("the envelope is shown; choose a load case or a combination first");
}

Reason why_not_weigh(const Desk& desk)
{
    if (const Reason reason = needs_shown_case(desk)) return reason;
    const Session& session = desk.session;
    if (session.view.load_case.index >= session.model().load_cases.size())
        return translatable("a combination has no loads of its own; choose a load case first");
    if (session.model().load_cases[session.view.load_case.index].self_weight != 0.0) return std::nullopt;
    for (const femoop::Member& member : session.model().members) {
        if (member.rigid || !member.material || session.model()[*member.material].density) continue;
        return Phrase(translatable("material {material} has no density; give it one first"),
                      {{"material", session.model()[*member.material].id}});
    }
    return std::nullopt;
}

// Adds a case and shows it.
void add(Session& session, const Phrase& label, const std::function<CaseId(Document&)>& command)
{
    CaseId added;
    if (session.change({label, [&](Document& document) { added = command(document); }})) return;
    show_case(session, added);
}

void weigh(Desk& desk, bool is_on)
{
    Session& session = desk.session;
    const LoadCasePlace place{session.view.load_case.index};
    session.change_soundly({about_case(translatable("Self-weight: {part}"), session),
                            [=](Document& document) { set_self_weight(document, place, is_on ? 1.0 : 0.0); }});
}

bool weighs(const Desk& desk)
{
    const auto& cases = desk.session.model().load_cases;
    const std::size_t shown = desk.session.view.load_case.index;
    return shown < cases.size() && cases[shown].self_weight != 0.0;
}

void new_case(Desk& desk)
{
    add(desk.session, translatable("New load case"), add_load_case);
    desk.requests.push_back(Request::RenameCase);
}

void new_combination(Desk& desk)
{
    add(desk.session, translatable("New combination"), add_combination);
    desk.session.selection = part_of(desk.session.model(), desk.session.view.load_case);
    desk.topic = Topic::Properties;
    desk.requests.push_back(Request::RenameCase);
}

void duplicate_case(Desk& desk)
{
    const CaseId shown = desk.session.view.load_case;
    add(desk.session, about_case(translatable("Duplicate: {part}"), desk.session),
        [=](Document& document) { return copy_case(document, shown); });
    desk.requests.push_back(Request::RenameCase);
}

void delete_case(Desk& desk)
{
    const Part part = part_of(desk.session.model(), desk.session.view.load_case);
    desk.session.change({about_case(translatable("Delete: {part}"), desk.session),
                         [=](Document& document) { remove(document, std::array{part}); }});
}

// What is done to the case that is shown: the label says which one that is.
void add_shown(Menu& menu, const ui::CommandName& name, std::string_view live_label, void (*run)(Desk&))
{
    menu.step(name, run, needs_shown_case).live_label = [live_label, label = name.label](const Desk& desk) -> Phrase {
        return needs_shown_case(desk) ? Phrase(label) : about_case(live_label, desk.session);
    };
}

} // namespace

void add_case_commands(CommandTable& table)
{
    Menu menu(table, translatable("Loads"));
    menu.step({"case.new", translatable("New load case")}, new_case);
    menu.step({"case.combination", translatable("New combination")}, new_combination, needs_load_case);
    add_shown(menu, {"case.rename", translatable("Rename the load case…")}, translatable("Rename: {part}"),
              [](Desk& desk) { desk.requests.push_back(Request::RenameCase); });
    add_shown(menu, {"case.copy", translatable("Duplicate the load case")}, translatable("Duplicate: {part}"),
              duplicate_case);
    add_shown(menu, {"case.delete", translatable("Delete the load case")}, translatable("Delete: {part}"), delete_case);
    menu.toggle({"case.self_weight", translatable("Self-weight in this load case")}, weighs, weigh, why_not_weigh);
}

void show_case(Session& session, CaseId id)
{
    session.view.load_case = id;
    session.view.is_envelope = false;
}

Reason rename(Session& session, CaseId id, const std::string& name)
{
    if (session.model().case_name(id) == name) return std::nullopt;
    if (auto reason = why_not_rename(session.model(), id, name)) return reason;
    session.change({{translatable("Rename: {part}"), {{"part", title(session.model(), part_of(session.model(), id))}}},
                    [&](Document& document) { rename(document, id, name); }});
    return std::nullopt;
}

} // namespace frame
