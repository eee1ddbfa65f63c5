#include "apps/euler/window/step_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace euler {

using topology::EulerCounts;
using ui::translatable;

namespace {

struct CountEntry {
    const char* letter;
    std::size_t EulerCounts::*count;
    std::string_view words;
};
constexpr std::array counts_shown{
    CountEntry{"V", &EulerCounts::V, translatable("vertices")},
    CountEntry{"E", &EulerCounts::E, translatable("edges")},
    CountEntry{"F", &EulerCounts::F, translatable("faces")},
    CountEntry{"L", &EulerCounts::L, translatable("loops")},
    CountEntry{"S", &EulerCounts::S, translatable("shells")},
    CountEntry{"G", &EulerCounts::G, translatable("genus: handles")},
};

std::string with_sign(long difference)
{
    if (difference == 0) return "0";
    return (difference > 0 ? "+" : "−") + std::to_string(std::abs(difference));
}

void faint(const std::string& text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ui::wrapped_text(text);
    ImGui::PopStyleColor();
}

using Cells = std::array<std::string, counts_shown.size()>;

Cells changes(const StepReport& step)
{
    Cells cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t was = step.before.*counts_shown[i].count, is = step.after.*counts_shown[i].count;
        cells[i] = with_sign(static_cast<long>(is) - static_cast<long>(was));
    }
    return cells;
}

void count_row(const std::string& name, const Cells& cells)
{
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    for (const std::string& cell : cells) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(cell.c_str());
    }
}

void headings(const ui::Catalogue& tr)
{
    ImGui::TableNextColumn();
    for (const CountEntry& entry : counts_shown) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", entry.letter);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr(entry.words).c_str());
    }
}

// Before, the operator's own row, after: the middle one is what defines an operator.
void count_table(const StepReport& step, const ui::ImGuiSession& gui, const ui::Catalogue& tr)
{
    Cells before, after;
    for (std::size_t i = 0; i < counts_shown.size(); ++i) {
        before[i] = std::to_string(step.before.*counts_shown[i].count);
        after[i] = std::to_string(step.after.*counts_shown[i].count);
    }
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX |
                                      ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV;
    if (!ImGui::BeginTable("counts", 1 + static_cast<int>(counts_shown.size()), flags)) return;
    ImGui::TableSetupColumn(""); // all as wide as what stands in them
    for (const CountEntry& entry : counts_shown) ImGui::TableSetupColumn(entry.letter);
    headings(tr);
    count_row(tr("before"), before);
    ImGui::PushFont(gui.bold());
    count_row(step.name, changes(step));
    ImGui::PopFont();
    count_row(tr("after"), after);
    ImGui::EndTable();
}

// No line of it ends within brackets, nor beside their factor 2.
std::string with_whole_brackets(const std::string& formula)
{
    constexpr std::string_view no_break_space = "\u00a0";
    std::string text;
    bool is_within = false;
    for (std::size_t i = 0; i < formula.size(); ++i) {
        if (formula[i] == '(' || formula[i] == ')') is_within = formula[i] == '(';
        const bool is_beside_factor = formula.substr(0, i).ends_with(" 2") || formula.substr(i + 1).starts_with("2 (");
        if (formula[i] == ' ' && (is_within || is_beside_factor)) text += no_break_space;
        else text += formula[i];
    }
    return text;
}

void show_formula(const EulerCounts& counts)
{
    ui::wrapped_text(with_whole_brackets("V − E + F − (L − F) − 2 (S − G)"));
    ui::wrapped_text(with_whole_brackets("= " + formula_text(counts)));
}

const OperatorForm* form_of(const StepReport& step)
{
    const auto forms = operator_forms();
    const std::string word = step.line.substr(0, step.line.find(' '));
    const auto found = std::ranges::find(forms, word, &OperatorForm::word);
    return found == forms.end() ? nullptr : &*found;
}

void show_inverse(const StepReport& step, const ui::Catalogue& tr)
{
    faint(tr("Taken back by {operator}:", {{"operator", step.inverse_name}}));
    for (std::size_t i = 0; i < std::min<std::size_t>(step.inverse.size(), 4); ++i) ui::wrapped_text(step.inverse[i]);
    if (step.inverse.size() > 4)
        ui::wrapped_text(tr("… and {count} more", {{"count", std::to_string(step.inverse.size() - 4)}}));
}

void before_the_first(const Session& session)
{
    if (session.is_exhibiting()) return; // no script has made what is seen
    const ui::Catalogue& tr = session.tr();
    if (const std::string heading = tr(session.stepper().heading()); !heading.empty()) return ui::wrapped_text(heading);
    faint(session.n_steps() == 0 ? tr("The script is empty. MVFS makes the first vertex, with a face and a shell.")
                                 : tr("Nothing is done yet."));
}

} // namespace

std::string code(const StepSummary& step)
{
    const std::string line = step.line.substr(0, step.line.find(" #"));
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

std::string formula_text(const EulerCounts& n)
{
    const auto s = [](std::size_t count) { return std::to_string(count); };
    const long sum = n.formula();
    return s(n.V) + " − " + s(n.E) + " + " + s(n.F) + " − (" + s(n.L) + " − " + s(n.F) + ") − 2 (" + s(n.S) + " − " +
           s(n.G) + ") = " + (sum < 0 ? "−" + std::to_string(-sum) : std::to_string(sum));
}

namespace {

// In the present type.
float count_width() { return ImGui::CalcTextSize("+00").x; }

// The six letters, and below them what the step changes.
void caption_table(const StepReport& step, const ui::ImGuiSession& gui)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX |
                                      ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("changes", 1 + static_cast<int>(counts_shown.size()), flags)) return;
    ImGui::PushFont(gui.large());
    const float width = count_width();
    ImGui::TableSetupColumn("", 0, ImGui::CalcTextSize(step.name.c_str()).x + width);
    for (const CountEntry& entry : counts_shown) ImGui::TableSetupColumn(entry.letter, 0, width);
    ImGui::TableNextColumn();
    for (const CountEntry& entry : counts_shown) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", entry.letter);
    }
    count_row(step.name, changes(step));
    ImGui::PopFont();
    ImGui::EndTable();
}

float table_width(const StepReport& step, const ui::ImGuiSession& gui)
{
    ImGui::PushFont(gui.large());
    const auto n = static_cast<float>(counts_shown.size());
    const float width = ImGui::CalcTextSize(step.name.c_str()).x + (n + 1.0F) * count_width();
    ImGui::PopFont();
    return width + 2.0F * (n + 1.0F) * ImGui::GetStyle().CellPadding.x;
}

float gap_beside_table() { return 2.0F * ImGui::GetFontSize(); }

bool fits_large(const std::string& words, const ui::ImGuiSession& gui, float room)
{
    ImGui::PushFont(gui.large());
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    ImGui::PopFont();
    return width <= room;
}

// Where there is little room in the usual size, and in lines.
void large_text(const std::string& words, const ui::ImGuiSession& gui)
{
    if (!fits_large(words, gui, ImGui::GetContentRegionAvail().x)) return ui::wrapped_text(words);
    ImGui::PushFont(gui.large());
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopFont();
}

// What the script says of the step, or of itself before the first.
std::string caption_comment(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    const StepReport* const step = session.report();
    if (step == nullptr) return tr(session.stepper().heading());
    const std::string odd = tr(step->warning), why = tr(step->explanation);
    return odd + (odd.empty() || why.empty() ? "" : " ") + why;
}

float height_in_lines(const std::string& words, float room)
{
    return words.empty() ? 0.0F : ImGui::CalcTextSize(words.c_str(), nullptr, false, room).y;
}

// What stands in the caption, and how high it is.
struct Caption {
    std::string meaning, comment;
    bool is_meaning_beside = true; // of the six letters; else below them, where it has the whole width
    float height = 0.0F;
};

float height_of_table(const ui::ImGuiSession& gui)
{
    return 2.0F * (gui.large()->FontSize + 2.0F * ImGui::GetStyle().CellPadding.y);
}

// Of the formula beside the six letters, in a room so broad.
float height_of_formula(const StepReport& step, const ui::ImGuiSession& gui, float room)
{
    const std::string formula = with_whole_brackets(formula_text(step.after));
    return fits_large(formula, gui, room) ? gui.large()->FontSize : height_in_lines(formula, room);
}

// As high from step to step, so that the picture rests; a long comment makes it higher, and a small window.
Caption caption_of(const Session& session, const ui::ImGuiSession& gui)
{
    constexpr float usual_lines = 2.0F;
    const ImGuiStyle& style = ImGui::GetStyle();
    const StepReport* const step = session.report();
    const float room = ImGui::GetContentRegionAvail().x - 2.0F * style.WindowPadding.x;
    Caption caption{.meaning = {}, .comment = caption_comment(session)};
    float top = height_of_table(gui), below = height_in_lines(caption.comment, room);
    if (step != nullptr) {
        caption.meaning = session.tr()(step->meaning);
        const float beside = room - table_width(*step, gui) - gap_beside_table();
        const float formula = height_of_formula(*step, gui, beside);
        const float with_meaning = formula + style.ItemSpacing.y + height_in_lines(caption.meaning, beside);
        caption.is_meaning_beside = with_meaning <= top;
        top = std::max(top, formula);
        if (!caption.is_meaning_beside) below += height_in_lines(caption.meaning, room) + style.ItemSpacing.y;
    }
    caption.height = top + 2.0F * style.WindowPadding.y + std::max(usual_lines * ImGui::GetTextLineHeight(), below);
    return caption;
}

} // namespace

void step_caption(const Session& session, const ui::ImGuiSession& gui)
{
    const StepReport* const step = session.report();
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.7F * em, 0.4F * em});
    const Caption caption = caption_of(session, gui);
    ImGui::BeginChild("###caption", {0.0F, caption.height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    if (step != nullptr) {
        caption_table(*step, gui);
        ImGui::SameLine(0.0F, gap_beside_table());
        ImGui::BeginGroup();
        large_text(with_whole_brackets(formula_text(step->after)), gui);
        if (caption.is_meaning_beside) ui::wrapped_text(caption.meaning);
        ImGui::EndGroup();
        if (!caption.is_meaning_beside) ui::wrapped_text(caption.meaning);
    }
    if (!caption.comment.empty()) ui::wrapped_text(caption.comment);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void step_panel(Workspace& workspace, const CommandTable& commands, const ui::ImGuiSession& gui)
{
    const Session& session = workspace.session;
    const StepReport* const step = session.report();
    if (step == nullptr) return before_the_first(session);
    const ui::Catalogue& tr = session.tr();
    ImGui::PushFont(gui.large());
    ImGui::TextUnformatted(step->name.c_str());
    ImGui::PopFont();
    if (const OperatorForm* const form = form_of(*step)) {
        ImGui::SameLine();
        faint(tr(form->meaning));
    }
    ui::wrapped_text(code(*step));
    ImGui::Spacing();
    ui::wrapped_text(tr(step->meaning));
    if (const std::string odd = tr(step->warning); !odd.empty()) ui::wrapped_text(odd);
    if (const std::string why = tr(step->explanation); !why.empty()) faint(why);
    ImGui::Spacing();
    count_table(*step, gui, tr);
    ImGui::Spacing();
    show_formula(step->after);
    ImGui::Spacing();
    show_inverse(*step, tr);
    ImGui::Spacing();
    if (session.stepper().is_sweep(session.step())) ui::command_button(workspace, commands, "step.open_sweep");
}

} // namespace euler
