#include "apps/cross/window/player_bar.h"

#include <imgui.h>

#include <cmath>
#include <string>

namespace cross {

namespace {

/// A command as a button with a short word or sign; greyed where it cannot run, its tip says why.
void button(Desk& desk, const CommandTable& commands, std::string_view id, const std::string& word)
{
    const auto& command = *commands.find(id);
    const auto reason = why_not(command, desk);
    ImGui::BeginDisabled(reason.has_value());
    if (ImGui::Button((word + "###" + std::string(id)).c_str())) run(command, desk);
    ImGui::EndDisabled();
    const ui::Catalogue tr = desk.tr();
    const std::string keys = command.shortcuts.empty() ? "" : " (" + text(command.shortcuts.front()) + ")";
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", reason ? tr(*reason).c_str() : (label(command, desk, tr) + keys).c_str());
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

/// On the way that is gone: what is done, and what lies ahead.
void jump_bar(Desk& desk)
{
    Session& session = desk.session;
    const Play* const play = session.play();
    const int done = play != nullptr ? static_cast<int>(play->length()) : 0;
    const int all = play != nullptr ? done + static_cast<int>(play->n_ahead()) : 0;
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::BeginDisabled(all == 0);
    const std::string words = desk.tr()("step {n} of {total}",
                                        {{"n", std::to_string(done)}, {"total", std::to_string(all)}});
    if (all == 0) empty_bar(words);
    else if (const int place = slider(done, all, words); place != done) session.jump(static_cast<std::size_t>(place));
    ImGui::EndDisabled();
}

} // namespace

void player_bar(Desk& desk, const CommandTable& commands)
{
    const ui::Catalogue tr = desk.tr();
    button(desk, commands, "work.restart", tr("Start"));
    button(desk, commands, "work.back", tr("Back"));
    button(desk, commands, "work.play", desk.session.is_playing ? tr("Pause") : tr("Play"));
    button(desk, commands, "work.step", tr("Step"));
    button(desk, commands, "work.finish", tr("To the end"));
    jump_bar(desk);
}

} // namespace cross
