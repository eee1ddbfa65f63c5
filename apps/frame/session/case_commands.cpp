#include "apps/frame/session/case_commands.h"

#include <algorithm>
#include <array>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/load_cases.h"

namespace frame {

using femoop::CaseId;
using femoop::Model;
using ui::Message;
using ui::Reason;
using ui::translatable;

namespace {

Message about_case(std::string_view sentence, const Session& session)
{
    return {sentence, {{"part", title(session.model(), part_of(session.model(), session.view.load_case))}}};
}

Reason needs_load_case(const Workspace& workspace)
{
    if (!workspace.session.model().load_cases.empty()) return std::nullopt;
    return translatable("the model has no load case; add one first");
}

Reason needs_shown_case(const Workspace& workspace)
{
    if (const Reason reason = needs_load_case(workspace)) return reason;
    if (!workspace.session.view.is_envelope) return std::nullopt;
    return translatable("the envelope is shown; choose a load case or a combination first");
}

Reason why_not_weigh(const Workspace& workspace)
{
    if (const Reason reason = needs_shown_case(workspace)) return reason;
    const Session& session = workspace.session;
    if (session.view.load_case.index >= session.model().load_cases.size())
        return translatable("a combination has no loads of its own; choose a load case first");
    if (session.model().load_cases[session.view.load_case.index].self_weight != 0.0) return std::nullopt;
    for (const femoop::Member& member : session.model().members) {
        if (member.rigid || !member.material || session.model()[*member.material].density) continue;
        return Message(translatable("material {material} has no density; give it one first"),
                       {{"material", session.model()[*member.material].id}});
    }
    return std::nullopt;
}

// Adds a case and shows it.
void add(Session& session, const Message& label, const std::function<CaseId(Document&)>& command)
{
    CaseId added;
    if (session.change({label, [&](Document& document) { added = command(document); }})) return;
    show_case(session, added);
}

void weigh(Workspace& workspace, bool is_on)
{
    Session& session = workspace.session;
    const LoadCasePlace place{session.view.load_case.index};
    session.change_soundly({about_case(translatable("Self-weight: {part}"), session),
                            [=](Document& document) { set_self_weight(document, place, is_on ? 1.0 : 0.0); }});
}

bool weighs(const Workspace& workspace)
{
    const auto& cases = workspace.session.model().load_cases;
    const std::size_t shown = workspace.session.view.load_case.index;
    return shown < cases.size() && cases[shown].self_weight != 0.0;
}

void new_case(Workspace& workspace)
{
    add(workspace.session, translatable("New load case"), add_load_case);
    workspace.requests.push_back(Request::RenameCase);
}

void new_combination(Workspace& workspace)
{
    add(workspace.session, translatable("New combination"), add_combination);
    workspace.session.selection = part_of(workspace.session.model(), workspace.session.view.load_case);
    workspace.topic = Topic::Properties;
    workspace.requests.push_back(Request::RenameCase);
}

void duplicate_case(Workspace& workspace)
{
    const CaseId shown = workspace.session.view.load_case;
    add(workspace.session, about_case(translatable("Duplicate: {part}"), workspace.session),
        [=](Document& document) { return copy_case(document, shown); });
    workspace.requests.push_back(Request::RenameCase);
}

void delete_case(Workspace& workspace)
{
    const Part part = part_of(workspace.session.model(), workspace.session.view.load_case);
    workspace.session.change({about_case(translatable("Delete: {part}"), workspace.session),
                              [=](Document& document) { remove(document, std::array{part}); }});
}

// What is done to the case that is shown: the label says which one that is.
void add_shown(Menu& menu, const ui::CommandName& name, std::string_view live_label, void (*run)(Workspace&))
{
    menu.step(name, run, needs_shown_case).live_label = [live_label,
                                                         label = name.label](const Workspace& workspace) -> Message {
        return needs_shown_case(workspace) ? Message(label) : about_case(live_label, workspace.session);
    };
}

} // namespace

void add_case_commands(CommandTable& table)
{
    Menu menu(table, translatable("Loads"));
    menu.step({"case.new", translatable("New load case")}, new_case);
    menu.step({"case.combination", translatable("New combination")}, new_combination, needs_load_case);
    menu.step(
        {"case.code", translatable("Combinations of a code…")},
        [](Workspace& workspace) { workspace.design.open(workspace.session); }, needs_load_case);
    add_shown(menu, {"case.rename", translatable("Rename the load case…")}, translatable("Rename: {part}"),
              [](Workspace& workspace) { workspace.requests.push_back(Request::RenameCase); });
    add_shown(menu, {"case.copy", translatable("Duplicate the load case")}, translatable("Duplicate: {part}"),
              duplicate_case);
    add_shown(menu, {"case.delete", translatable("Delete the load case")}, translatable("Delete: {part}"), delete_case);
    menu.toggle({"case.self_weight", translatable("Self-weight in this load case")}, weighs, weigh, why_not_weigh);
}

void show_case(Session& session, CaseId id)
{
    session.view.load_case = id;
    session.view.is_envelope = false;
    const std::optional<Part> part = session.selection.only();
    if (part && case_id_of(session.model(), *part)) session.selection = part_of(session.model(), id);
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
