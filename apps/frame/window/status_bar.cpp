#include "apps/frame/window/status_bar.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/window/no_results.h"
#include "femoop/result/structure_words.h"
#include "ui/text/shortened.h"
#include "ui/widgets/panel.h"

namespace frame {

namespace {

std::string degree_text(const femoop::Indeterminacy& degree, const ui::Catalogue& tr)
{
    if (degree.has_foundation) return tr("on an elastic foundation");
    const std::string total = std::to_string(degree.total());
    if (degree.internal < 0)
        return tr("degree of indeterminacy {total}", {{"total", total}}); // hinges take from the whole
    return tr("degree of indeterminacy {total} = {external} external + {internal} internal",
              {{"total", total},
               {"external", std::to_string(degree.external)},
               {"internal", std::to_string(degree.internal)}});
}

// While members are drawn the picture does not say it, since the structure is not complete yet.
ui::Message unsolved(const Workspace& workspace)
{
    constexpr std::size_t most_letters = 90;
    const femoop::Fault* const error = why_not_solved(workspace.session);
    if (!workspace.tool_controller.can_type() || error == nullptr) return ui::translatable("not solved");
    return {ui::translatable("not solved: {reason}"),
            {{"reason", ui::shortened(sentence(*error, workspace.tr()), most_letters)}}};
}

// Who walks through views sees here which one it is: in the picture the words would cover what it shows.
std::vector<std::string> parts_of(const Workspace& workspace)
{
    constexpr std::size_t most_letters = 40;
    const Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const std::vector<NamedView>& views = session.document().companion.views;
    std::vector<std::string> parts;
    if (session.shown_view && *session.shown_view < views.size())
        parts.push_back(ui::shortened(views[*session.shown_view].name, most_letters));
    parts.push_back(femoop::size_text(session.model(), tr));
    const auto& results = session.solution().results;
    if (!results) parts.push_back(tr(unsolved(workspace)));
    else if (!session.model().members.empty()) parts.push_back(degree_text(results->indeterminacy(), tr));
    std::string blank;
    for (const BlankCase& one : session.solution().blank)
        blank += (blank.empty() ? "" : ", ") + session.model().case_name(one.id);
    if (results && !blank.empty())
        parts.push_back(tr("no results of {cases}", {{"cases", ui::shortened(blank, most_letters)}}));
    return parts;
}

/// The first parts, as many as there is room for, the last of them shortened.
std::string first_of(const std::vector<std::string>& parts, float room)
{
    constexpr std::size_t least_letters = 20;
    std::string text;
    for (const std::string& part : parts) {
        const std::string before = text.empty() ? "" : text + "   ·   ";
        const auto fits = [&](const std::string& begun) {
            return ImGui::CalcTextSize((before + begun).c_str()).x <= room;
        };
        const std::string begun = ui::shortened_to_fit(part, least_letters, fits);
        if (begun.empty()) break;
        text = before + begun;
        if (begun != part) break;
    }
    return text;
}

} // namespace

void status_bar(const Workspace& workspace)
{
    ui::begin_status_bar();
    const ui::DisplayUnits units = workspace.session.units();
    const std::string right = units.summary() + ", " + units.unit(ui::Measure::Displacement).name;
    const float at = ImGui::GetWindowWidth() - ImGui::CalcTextSize(right.c_str()).x - ImGui::GetFontSize();
    ImGui::TextUnformatted(first_of(parts_of(workspace), at - 2.0F * ImGui::GetFontSize()).c_str());
    ImGui::SameLine(at);
    ImGui::TextDisabled("%s", right.c_str());
    ui::end_status_bar();
}

} // namespace frame
