#include "apps/frame/window/solver_panel.h"

#include <imgui.h>

#include <string>

#include "apps/frame/view/solver/solver_picture.h"
#include "femoop/io/results/solver_trace_text.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::Key;

namespace {

void go_by_hand(SolverShow& show, std::size_t step)
{
    show.rest();
    show.go_to(step);
}

void play_or_rest(SolverShow& show)
{
    if (show.is_playing()) show.rest();
    else show.play();
}

std::size_t before(const SolverShow& show) { return show.step() == 0 ? 0 : show.step() - 1; }

void show_buttons(SolverShow& show, const ui::Catalogue& tr)
{
    const auto button = [&](const std::string& words, const char* id) {
        const bool is_clicked = ImGui::Button((words + id).c_str());
        ImGui::SameLine();
        return is_clicked;
    };
    if (button(tr("First"), "###first")) go_by_hand(show, 0);
    if (ImGui::ArrowButton("###previous", ImGuiDir_Left)) go_by_hand(show, before(show));
    ImGui::SameLine();
    if (button(show.is_playing() ? tr("Stop") : tr("Walk"), "###play")) play_or_rest(show);
    if (ImGui::ArrowButton("###next", ImGuiDir_Right)) go_by_hand(show, show.step() + 1);
    ImGui::SameLine();
    if (button(tr("Last"), "###last")) go_by_hand(show, show.n_steps());
}

void show_slider(SolverShow& show)
{
    int step = static_cast<int>(show.step()) + 1;
    ImGui::SetNextItemWidth(14.0F * ImGui::GetFontSize());
    if (ImGui::SliderInt("###step", &step, 1, static_cast<int>(show.n_steps()), "%d", ImGuiSliderFlags_NoInput))
        go_by_hand(show, static_cast<std::size_t>(step - 1));
    ImGui::SameLine(0.0F, ImGui::GetFontSize());
}

/// Of all orders as buttons beside one another.
float width_of_orders(const ui::Catalogue& tr)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = 0.0F;
    for (const femoop::Ordering ordering : femoop::all_orderings)
        width += ImGui::CalcTextSize(femoop::ordering_text(ordering, tr).c_str()).x + ImGui::GetFrameHeight() +
                 style.ItemInnerSpacing.x + style.ItemSpacing.x;
    return width;
}

void show_orders(SolverShow& show, const ui::Catalogue& tr)
{
    const auto label = [&](femoop::Ordering ordering) {
        return femoop::ordering_text(ordering, tr) + "###" + std::string(name(ordering));
    };
    if (width_of_orders(tr) < ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight()) {
        for (const femoop::Ordering ordering : femoop::all_orderings) {
            if (ImGui::RadioButton(label(ordering).c_str(), show.ordering() == ordering)) show.choose(ordering);
            ImGui::SameLine();
        }
        return;
    }
    ImGui::SetNextItemWidth(15.0F * ImGui::GetFontSize());
    if (!ImGui::BeginCombo("###order", femoop::ordering_text(show.ordering(), tr).c_str())) return;
    for (const femoop::Ordering ordering : femoop::all_orderings)
        if (ImGui::Selectable(label(ordering).c_str(), show.ordering() == ordering)) show.choose(ordering);
    ImGui::EndCombo();
}

/// At the right end of the bar.
void show_closing(Workspace& workspace)
{
    const float side = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - side);
    if (ImGui::Button("×###close", {side, side})) workspace.bottom.is_open = false;
}

void show_picture(const Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    const ImVec2 room = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
    const ui::Size sheet{static_cast<double>(room.x) / gui.scale(), static_cast<double>(room.y) / gui.scale()};
    if (sheet.width < 1.0 || sheet.height < 1.0) return;
    ui::Painter painter(sheet, fonts);
    draw_solver(painter, *workspace.solver.trace(),
                {.theme = ui::Theme(workspace.session.view.theme),
                 .tr = workspace.tr(),
                 .ordering = workspace.solver.ordering(),
                 .step = workspace.solver.step()});
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    ImGui::Dummy(room);
}

} // namespace

void solver_panel(Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    SolverShow& show = workspace.solver;
    show.follow(workspace.session);
    if (show.n_steps() > 0) {
        show_buttons(show, workspace.tr());
        show_slider(show);
        show_orders(show, workspace.tr());
    }
    show_closing(workspace);
    if (show.why_none()) {
        ui::wrapped_text(workspace.tr()(*show.why_none()));
        return;
    }
    show_picture(workspace, gui, fonts);
}

bool handle_solver_key(Workspace& workspace, const ui::Chord& chord)
{
    SolverShow& show = workspace.solver;
    show.follow(workspace.session);
    if (chord.modifiers != ui::Modifiers{}) return false;
    const auto turn_order = [&](std::size_t by) {
        const std::size_t n = femoop::all_orderings.size();
        show.choose(femoop::all_orderings[(static_cast<std::size_t>(show.ordering()) + by) % n]);
    };
    switch (chord.key) {
    case Key::Left: go_by_hand(show, before(show)); return true;
    case Key::Right: go_by_hand(show, show.step() + 1); return true;
    case Key::Home: go_by_hand(show, 0); return true;
    case Key::End: go_by_hand(show, show.n_steps()); return true;
    case Key::Space: play_or_rest(show); return true;
    case Key::Up: turn_order(3); return true;
    case Key::Down: turn_order(1); return true;
    case Key::Escape: return true;
    default: return false;
    }
}

} // namespace frame
