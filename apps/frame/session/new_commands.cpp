#include "apps/frame/session/new_commands.h"

#include <algorithm>
#include <array>

#include "apps/frame/session/tabs.h"
#include "ui/workspace/standard_commands.h"

namespace frame {

using femoop::AnalysisKind;
using ui::translatable;

namespace {

constexpr std::array kind_entries{
    KindEntry{AnalysisKind::Truss2d, "file.new_truss2d", translatable("Plane truss"), "edit.kind_truss2d"},
    KindEntry{AnalysisKind::Frame2d, "file.new_frame2d", translatable("Plane frame"), "edit.kind_frame2d"},
    KindEntry{AnalysisKind::Grillage, "file.new_grillage", translatable("Grillage"), "edit.kind_grillage"},
    KindEntry{AnalysisKind::Truss3d, "file.new_truss3d", translatable("Space truss"), "edit.kind_truss3d"},
    KindEntry{AnalysisKind::Frame3d, "file.new_frame3d", translatable("Space frame"), "edit.kind_frame3d"},
};

} // namespace

std::span<const KindEntry> kinds() { return kind_entries; }

std::string_view label_of(AnalysisKind kind) { return std::ranges::find(kind_entries, kind, &KindEntry::kind)->label; }

void add_new_commands(CommandTable& table)
{
    ui::standard::add_new<Workspace>(table, [](Workspace& workspace) {
        new_document(workspace, AnalysisKind::Frame2d);
        workspace.requests.push_back(Request::AskKind);
    });
    Menu menu(table, ui::standard::file_menu);
    for (const KindEntry& entry : kind_entries)
        menu.step({entry.id, entry.label}, [kind = entry.kind](Workspace& workspace) { new_document(workspace, kind); })
            .live_label = [label = entry.label](const Workspace&) -> ui::Message {
            return {translatable("New: {kind}"), {{"kind", ui::Message(label)}}};
        };
}

} // namespace frame
