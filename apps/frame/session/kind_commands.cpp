#include "apps/frame/session/kind_commands.h"

#include <algorithm>
#include <vector>

#include "apps/frame/document/fault/place.h"
#include "apps/frame/session/new_commands.h"
#include "apps/frame/session/tabs.h"
#include "femoop/io/model_file.h"
#include "ui/workspace/standard_commands.h"

namespace frame {

using femoop::AnalysisKind;
using femoop::Fault;
using femoop::Model;
using ui::translatable;

namespace {

/// A model as its file would be read: what the kind has no place for is a fault there, or missing.
struct Reread {
    std::vector<Fault> faults;
    bool is_whole = false;
};

Reread reread(const Model& model)
{
    try {
        return {.faults = {}, .is_whole = femoop::read_model(femoop::write_model(model)) == model};
    } catch (const femoop::ModelError& error) {
        return {.faults = error.faults()};
    }
}

std::optional<Notice> why_not_into(const Model& now, const Model& next)
{
    const std::vector<Fault> before = reread(now).faults;
    Reread after = reread(next);
    const bool was_sound = after.faults.empty();
    std::erase_if(after.faults, [&](const Fault& fault) { return std::ranges::find(before, fault) != before.end(); });
    if (!after.faults.empty()) return refusal_of(named(std::move(after.faults), next));
    if (!was_sound || after.is_whole) return std::nullopt;
    return Notice{{{translatable("nothing was changed: {kind} has no place for a part of the model"),
                    {{"kind", ui::Message(label_of(next.analysis))}}}}};
}

} // namespace

void change_kind(Workspace& workspace, AnalysisKind kind)
{
    Session& session = workspace.session;
    const bool was_truss = femoop::is_truss(session.model().analysis), is_truss = femoop::is_truss(kind);
    Model next = session.model();
    next.analysis = kind;
    if (auto notice = why_not_into(session.model(), next)) {
        session.notice = std::move(notice);
        return;
    }
    session.change({{translatable("Change into: {kind}"), {{"kind", ui::Message(label_of(kind))}}},
                    [kind](Document& document) { document.model.analysis = kind; }});
    if (is_truss != was_truss) session.view.show = suited(session.view.show, is_truss);
}

void add_kind_commands(CommandTable& table)
{
    Menu menu(table, ui::standard::edit_menu);
    for (const KindEntry& entry : kinds())
        menu.choice(
                ui::Choice<AnalysisKind>{entry.kind, entry.change_id, entry.label},
                [](const Workspace& workspace) { return workspace.session.model().analysis; }, change_kind)
            .live_label = [label = entry.label](const Workspace&) -> ui::Message {
            return {translatable("Change into: {kind}"), {{"kind", ui::Message(label)}}};
        };
}

} // namespace frame
