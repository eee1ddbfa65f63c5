#include "apps/frame/window/factor_slider.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace frame {

using Kind = ui::NumberFieldEvent::Kind;

namespace {

constexpr int exact_digits = 15;

enum class Gesture : std::uint8_t { None, Reset, Type };

struct SliderCorners {
    ImVec2 name, number, slider, end; ///< corners; `name` and `slider` begin at the left
};

// Its name with the number at the end of the line.
SliderCorners write_name(const std::string& name, const std::string& number)
{
    SliderCorners rows;
    rows.name = ImGui::GetCursorScreenPos();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(number.c_str()).x);
    rows.number = ImGui::GetCursorScreenPos();
    ImGui::TextDisabled("%s", number.c_str());
    rows.slider = ImGui::GetCursorScreenPos();
    rows.end = {rows.slider.x + ImGui::GetContentRegionAvail().x, rows.slider.y + ImGui::GetFrameHeight()};
    return rows;
}

bool is_over(const ImVec2& least, const ImVec2& most)
{
    return ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(least, most);
}

bool is_double_click() { return ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left); }

Gesture gesture(const SliderCorners& rows)
{
    if (!is_over(rows.name, rows.end) || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return Gesture::None;
    if (is_double_click()) return Gesture::Reset;
    const bool is_on_number = is_over(rows.number, {rows.end.x, rows.slider.y});
    const bool is_on_slider = is_over(rows.slider, rows.end);
    return is_on_number || (is_on_slider && ImGui::GetIO().KeyCtrl) ? Gesture::Type : Gesture::None;
}

// A press that meant something else moves nothing.
bool drag(const FactorSlider& slider, double& factor, Gesture pressed)
{
    float power = static_cast<float>(std::log10(factor));
    const float least = static_cast<float>(std::log10(slider.least)),
                most = static_cast<float>(std::log10(slider.most));
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, 1.0F);
    ImGui::BeginDisabled(pressed != Gesture::None);
    const bool has_moved = ImGui::SliderFloat(slider.id, &power, least, most, "", ImGuiSliderFlags_NoInput);
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
    if (has_moved) factor = std::pow(10.0, static_cast<double>(power));
    return has_moved;
}

// "× 2" is typed as it is shown, too.
std::optional<double> factor_typed(std::string_view text)
{
    constexpr std::string_view times = "×";
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (text.starts_with(times)) text.remove_prefix(times.size());
    return ui::number_typed(text);
}

std::string refusal(std::string_view text, const FactorSlider& slider, const FactorLook& look)
{
    const auto number = [&](double x) { return ui::number_text(x, {exact_digits, look.format.mark}); };
    const std::string least = number(slider.least_typed), most = number(slider.most_typed);
    if (text.find_first_not_of(' ') == std::string_view::npos)
        return look.tr("wanted a factor above zero, from {least} to {most}", {{"least", least}, {"most", most}});
    return look.tr("found {text}, wanted a factor above zero, from {least} to {most}",
                   {{"text", std::string(text)}, {"least", least}, {"most", most}});
}

void type(const FactorSlider& slider, const FactorLook& look, double& factor)
{
    const ui::NumberFieldEvent event = look.fields.show(slider.id,
                                                        {.text = "", .exact_text = "", .value = factor, .width = 0.0F});
    if (event.kind != Kind::Typed) return;
    const auto typed = factor_typed(event.text);
    if (typed && *typed >= slider.least_typed && *typed <= slider.most_typed) factor = *typed;
    else look.fields.reject(event, refusal(event.text, slider, look));
}

} // namespace

bool show(const FactorSlider& slider, const FactorLook& look, double& factor)
{
    const SliderCorners rows = write_name(slider.name, "× " + ui::number_text(factor, look.format));
    if (look.fields.is_open(slider.id)) {
        type(slider, look, factor);
        // The first click on the number has opened the field.
        if (is_double_click() && is_over(rows.name, {rows.end.x, rows.slider.y})) factor = slider.usual;
        return false;
    }
    const Gesture pressed = gesture(rows);
    if (pressed == Gesture::Reset) factor = slider.usual;
    if (pressed == Gesture::Type)
        look.fields.open(slider.id, ui::number_text(factor, {exact_digits, look.format.mark}));
    return drag(slider, factor, pressed) && pressed == Gesture::None;
}

} // namespace frame
