#include "apps/cross/window/player_bar.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "ui/widgets/tooltip.h"

namespace cross {

namespace {

/// A command as a button with a short word or sign; greyed where it cannot run, its tip says why.
void button(Workspace& workspace, const CommandTable& commands, std::string_view id, const std::string& word)
{
    const auto& command = *commands.find(id);
    const auto reason = why_not(command, workspace);
    ImGui::BeginDisabled(reason.has_value());
    if (ImGui::Button((word + "###" + std::string(id)).c_str())) run(command, workspace);
    ImGui::EndDisabled();
    const ui::Catalogue tr = workspace.tr();
    const std::string keys = command.shortcuts.empty() ? "" : " (" + text(command.shortcuts.front()) + ")";
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ui::show_tooltip(reason ? tr(*reason) : label(command, workspace, tr) + keys);
    ImGui::SameLine();
}

/// A slider that has nowhere to slide: its words alone.
void empty_bar(const std::string& words)
{
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    ImGui::Button((words + "###jump").c_str(), {-1.0F, 0.0F});
    ImGui::PopStyleColor();
}

/// Where a hand has moved the step to. One of real numbers: that of whole ones has a handle as broad as a step, which
/// covers the words where the steps are few.
int slider(int done, int all, const std::string& words)
{
    auto place = static_cast<float>(done);
    ImGui::SliderFloat("###jump", &place, 0.0F, static_cast<float>(all), words.c_str(), ImGuiSliderFlags_NoInput);
    return static_cast<int>(std::lround(place));
}

/// Numbers alone where there is little room.
std::string step_words(int done, int all, const ui::Catalogue& tr)
{
    const std::string n = std::to_string(done), total = std::to_string(all);
    std::string words = tr("step {n} of {total}", {{"n", n}, {"total", total}});
    const float room = ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetStyle().FramePadding.x;
    return ImGui::CalcTextSize(words.c_str()).x <= room ? words : n + " / " + total;
}

/// On the way that is gone: what is done, and what lies ahead.
void jump_bar(Workspace& workspace)
{
    Session& session = workspace.session;
    const TurnTree* const turn_tree = session.turn_tree();
    const int done = turn_tree != nullptr ? static_cast<int>(turn_tree->length()) : 0;
    const int all = turn_tree != nullptr ? done + static_cast<int>(turn_tree->n_ahead()) : 0;
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::BeginDisabled(all == 0);
    const std::string words = step_words(done, all, workspace.tr());
    if (all == 0) empty_bar(words);
    else if (const int place = slider(done, all, words); place != done) session.jump(static_cast<std::size_t>(place));
    ImGui::EndDisabled();
}

} // namespace

void player_bar(Workspace& workspace, const CommandTable& commands)
{
    const ui::Catalogue tr = workspace.tr();
    button(workspace, commands, "work.restart", tr("Start"));
    button(workspace, commands, "work.back", tr("Back"));
    button(workspace, commands, "work.play", workspace.session.is_playing ? tr("Pause") : tr("Play"));
    button(workspace, commands, "work.step", tr("Step"));
    button(workspace, commands, "work.finish", tr("To the end"));
    jump_bar(workspace);
}

} // namespace cross
