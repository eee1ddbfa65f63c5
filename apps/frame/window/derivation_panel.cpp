#include "apps/frame/window/derivation_panel.h"

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "apps/drawing/sketch/scene.h"
#include "apps/frame/session/derivation_commands.h"
#include "apps/frame/view/derivation/derivation_picture.h"
#include "apps/frame/view/derivation/state_pictures.h"
#include "femoop/methods/influence/effect_name.h"
#include "ui/widgets/tooltip.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::Key;

namespace {

void run(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    if (const auto reason = ui::run(*commands.find(id), workspace)) workspace.notify(*reason);
}

void show_steps(Workspace& workspace, const CommandTable& commands)
{
    const ui::Catalogue tr = workspace.tr();
    if (ImGui::ArrowButton("###previous", ImGuiDir_Left)) run(workspace, commands, "derivation.previous");
    ImGui::SameLine();
    if (ImGui::ArrowButton("###next", ImGuiDir_Right)) run(workspace, commands, "derivation.next");
    ImGui::SameLine();
    DerivationShow& show = workspace.derivation;
    int step = static_cast<int>(show.step()) + 1;
    ImGui::SetNextItemWidth(10.0F * ImGui::GetFontSize());
    if (ImGui::SliderInt("###step", &step, 1, static_cast<int>(show.n_steps()), "", ImGuiSliderFlags_NoInput))
        show.go_to(static_cast<std::size_t>(step - 1));
    ImGui::SameLine();
}

// N, V, M at a section; fx, fy, ux at a node.
void show_numbers(Workspace& workspace)
{
    DerivationShow& show = workspace.derivation;
    const femoop::Model& model = workspace.session.model();
    const auto asked = show.asked(model);
    if (!asked) return;
    const std::string chosen = femoop::influence::component_name(model.analysis, *asked);
    ImGui::SetNextItemWidth(5.0F * ImGui::GetFontSize());
    if (ImGui::BeginCombo("###number", chosen.c_str())) {
        for (const femoop::MovingEffect& one : show.choices())
            if (ImGui::Selectable(femoop::influence::component_name(model.analysis, one).c_str(), one == asked))
                explain(workspace, show.beside(model, one));
        ImGui::EndCombo();
    }
    ImGui::SameLine();
}

void show_copying(Workspace& workspace, const CommandTable& commands)
{
    const ui::Catalogue tr = workspace.tr();
    if (ImGui::Button((tr("Copy") + "###copy text").c_str())) run(workspace, commands, "derivation.copy");
    ImGui::SameLine();
    if (ImGui::Button("LaTeX###copy latex")) run(workspace, commands, "derivation.copy_latex");
}

/// Whose number it is, where it is none of the model that is drawn.
void name_kept(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (!workspace.derivation.is_of_kept_model() || !session.reference) return;
    const std::string& name = session.reference->name;
    ImGui::SameLine();
    ImGui::TextDisabled("%s", name.empty() ? session.tr()("the results that were kept").c_str() : name.c_str());
}

/// At the right end of the bar.
void show_close_button(Workspace& workspace)
{
    const float side = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - side);
    if (ImGui::Button("×###close", {side, side})) close_derivation(workspace);
}

/// What is left of the current window, in logical pixels.
ui::Size room_left(const ui::ImGuiSession& gui)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    return {static_cast<double>(room.x) / gui.scale(), static_cast<double>(room.y) / gui.scale()};
}

/// \param width  0: all that is left
void show_picture(const Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts, float width)
{
    const Session& session = workspace.session;
    const femoop::derivation::Derivation& derivation = *workspace.derivation.derivation();
    const femoop::Model& model = workspace.derivation.model(session);
    DerivationLook look{.theme = ui::Theme(session.view.theme),
                        .tr = workspace.tr(),
                        .units = drawing::display_units(model, session.view),
                        .step = workspace.derivation.step()};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::BeginChild("###derivation", {width, 0.0F}, false, ImGuiWindowFlags_HorizontalScrollbar);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const double scale = gui.scale();
    if (const ui::Size seen = room_left(gui); seen.width >= 1.0 && seen.height >= 1.0) {
        look.seen_height = seen.height;
        const ui::Size sheet = sheet_for(derivation, model, look, seen, fonts);
        ui::Painter painter(sheet, fonts);
        draw_derivation(painter, derivation, model, look);
        gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
                 {static_cast<double>(corner.x), static_cast<double>(corner.y)});
        ImGui::Dummy({static_cast<float>(scale * sheet.width), static_cast<float>(scale * sheet.height)});
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

constexpr float states_share = 0.5F; // of the panel's width, for the states of the force method

// The states of the force method, each as a picture of its own.
void show_states(const Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    const Session& session = workspace.session;
    const auto& method = *workspace.derivation.force_method();
    const StateLook look{.view = session.view, .step = *workspace.derivation.shown_step()};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const auto show = [&](const ui::Box& box, const auto& draw, std::size_t state) {
        ui::Painter painter(box.size(), fonts);
        draw(painter, method, state, look);
        gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
                 {static_cast<double>(corner.x) + gui.scale() * box.min.x,
                  static_cast<double>(corner.y) + gui.scale() * box.min.y});
    };
    for (const StateCell& cell : state_cells(method, room_left(gui), look)) {
        show(cell.picture, draw_state, cell.state);
        show(cell.name, draw_state_name, cell.state);
    }
}

/// The picture of the step; beside it that of the states, where it is one of the force method.
void show_sheet(const Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    if (workspace.derivation.force_method() == nullptr) return show_picture(workspace, gui, fonts, 0.0F);
    show_picture(workspace, gui, fonts, (1.0F - states_share) * ImGui::GetContentRegionAvail().x);
    ImGui::SameLine();
    ImGui::BeginChild("###states", {0.0F, 0.0F});
    if (const ui::Size room = room_left(gui); room.width >= 1.0 && room.height >= 1.0)
        show_states(workspace, gui, fonts);
    ImGui::EndChild();
}

} // namespace

void derivation_panel(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    DerivationShow& show = workspace.derivation;
    show.follow(workspace.session);
    if (show.is_lost()) {
        workspace.notify(show.lost());
        return close_derivation(workspace);
    }
    if (show.n_steps() > 0) {
        show_steps(workspace, commands);
        show_numbers(workspace);
        show_copying(workspace, commands);
        name_kept(workspace);
    }
    show_close_button(workspace);
    if (!workspace.bottom.is_open) return;
    show.follow(workspace.session); // another number may have been chosen
    if (show.why_none()) ui::wrapped_text(workspace.tr()(*show.why_none()));
    else if (show.n_steps() > 0) show_sheet(workspace, gui, fonts);
}

bool handle_presenter_key(Workspace& workspace, const ui::Chord& chord)
{
    DerivationShow& show = workspace.derivation;
    show.follow(workspace.session);
    if (chord.modifiers != ui::no_modifiers) return false;
    const bool was_refused = std::exchange(workspace.refused_release, std::nullopt).has_value();
    if (was_refused && chord.key == Key::Escape) return true;
    switch (chord.key) {
    case Key::PageUp: show.go_back(); return true;
    case Key::PageDown: show.go_on(); return true;
    case Key::Escape: close_derivation(workspace); return true;
    default: return false;
    }
}

bool handle_derivation_key(Workspace& workspace, const ui::Chord& chord)
{
    DerivationShow& show = workspace.derivation;
    if (handle_presenter_key(workspace, chord)) return true;
    if (chord.modifiers != ui::no_modifiers) return false;
    switch (chord.key) {
    case Key::Left: show.go_back(); return true;
    case Key::Right: show.go_on(); return true;
    case Key::Home: show.go_to(0); return true;
    case Key::End: show.go_to(show.n_steps()); return true;
    case Key::Up: show.choose_previous(); return true;
    case Key::Down: show.choose_next(); return true;
    default: return false;
    }
}

} // namespace frame
