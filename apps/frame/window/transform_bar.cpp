#include "apps/frame/window/transform_bar.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "apps/frame/session/edit_commands.h"
#include "apps/frame/window/number_row.h"

namespace frame {

using ui::Measure;
using TransformKind = Transform::Kind;

namespace {

class TransformBar {
public:
    TransformBar(Workspace& workspace, ui::NumberFields& fields)
        : workspace_(workspace), fields_(fields), transform_(*workspace.transform), tr_(workspace.session.view.tr)
    {}

    // True where a number was changed.
    bool show()
    {
        begins_ = std::exchange(transform_.begins, false);
        if (transform_.kind == TransformKind::Bend) return show_bend();
        const bool is_mirror = transform_.kind == TransformKind::Mirror && transform_.is_in_space;
        if (is_mirror) normal(tr_("plane"), {"yz", "xz", "xy"});
        for (std::size_t i = 0; i < (transform_.is_in_space ? 3 : 2); ++i)
            if (!is_mirror || i == static_cast<std::size_t>(transform_.normal)) coordinate(i);
        if (transform_.kind == TransformKind::Rotate && transform_.is_in_space) normal(tr_("axis"), axes);
        const bool turns = transform_.kind == TransformKind::Rotate || transform_.kind == TransformKind::Mirror;
        if (turns && !is_mirror) number(tr_("angle"), "angle", Measure::Angle, transform_.angle);
        if (transform_.kind == TransformKind::Scale) factor();
        if (transform_.kind == TransformKind::Copy) count(tr_("times"), "times", transform_.times, {1, 100});
        if (transform_.kind == TransformKind::Rotate || transform_.kind == TransformKind::Mirror) {
            is_changed_ |= ImGui::Checkbox((tr_("a copy") + "###copy").c_str(), &transform_.keeps_original);
            fields_.stops().add();
            ImGui::SameLine();
        }
        return is_changed_;
    }

private:
    bool show_bend()
    {
        const std::string arc = tr_("arc"), parabola = tr_("parabola");
        int curve = static_cast<int>(transform_.bend.curve);
        const std::array names{arc.c_str(), parabola.c_str()};
        ImGui::SetNextItemWidth(6.0F * ImGui::GetFontSize());
        is_changed_ |= ImGui::Combo("###curve", &curve, names.data(), static_cast<int>(names.size()));
        fields_.stops().add();
        transform_.bend.curve = static_cast<femoop::BendCurve>(curve);
        ImGui::SameLine();
        femoop::Quantity rise(transform_.bend.rise);
        number(tr_("rise"), "rise", Measure::Length, rise, [least = transform_.least_rise](double value) {
            return std::abs(value) < least ? std::optional(ui::Message(femoop::no_rise)) : std::nullopt;
        });
        transform_.bend.rise = rise;
        int parts = static_cast<int>(transform_.bend.n_parts);
        count(tr_("parts"), "parts", parts,
              {static_cast<int>(femoop::least_bend_parts), static_cast<int>(femoop::most_bend_parts)});
        transform_.bend.n_parts = static_cast<std::size_t>(parts);
        return is_changed_;
    }

    static constexpr std::array<const char*, 3> axes{"x", "y", "z"};

    void coordinate(std::size_t i)
    {
        const bool shifts = transform_.kind == TransformKind::Move || transform_.kind == TransformKind::Copy;
        number(std::string(shifts ? "Δ" : "") + axes.at(i), axes.at(i), Measure::Length, transform_.at.at(i));
    }
    // By the names of what is square to each axis, or of the axes.
    void normal(const std::string& label, const std::array<const char*, 3>& names)
    {
        name(label);
        int chosen = static_cast<int>(transform_.normal);
        ImGui::SetNextItemWidth(3.3F * ImGui::GetFontSize());
        is_changed_ |= ImGui::Combo("###normal", &chosen, names.data(), static_cast<int>(names.size()));
        fields_.stops().add();
        transform_.normal = static_cast<WorkingPlane::Normal>(chosen);
        ImGui::SameLine();
    }
    void name(const std::string& text)
    {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(text.c_str());
        ImGui::SameLine();
    }
    using WhyNot = std::function<std::optional<ui::Message>(double)>;

    void number(const std::string& label, const char* id, Measure measure, femoop::Quantity& value, WhyNot why_not = {})
    {
        name(workspace_.session.units().label(label, measure));
        is_changed_ |= edit_quantity(workspace_, fields_,
                                     {id, measure, 4.0F * ImGui::GetFontSize(), std::move(why_not), begins()}, value);
        ImGui::SameLine();
    }
    void factor()
    {
        femoop::Quantity value(transform_.factor);
        name(tr_("factor"));
        if (edit_quantity(workspace_, fields_, {"factor", Measure::Plain, 4.0F * ImGui::GetFontSize(), {}, begins()},
                          value) &&
            value > 0.0) {
            transform_.factor = value;
            is_changed_ = true;
        }
        ImGui::SameLine();
    }
    struct Limits {
        int least, most;
    };
    void count(const std::string& label, const char* id, int& value, Limits limits)
    {
        femoop::Quantity typed(value);
        name(label);
        const auto why_not = [limits](double number) -> std::optional<ui::Message> {
            const bool is_whole = std::trunc(number) == number;
            if (is_whole && number >= limits.least && number <= limits.most) return std::nullopt;
            return ui::Message{ui::translatable("wanted a whole number from {least} to {most}"),
                               {{"least", std::to_string(limits.least)}, {"most", std::to_string(limits.most)}}};
        };
        if (edit_quantity(workspace_, fields_, {id, Measure::Plain, 3.0F * ImGui::GetFontSize(), why_not}, typed)) {
            value = static_cast<int>(std::lround(static_cast<double>(typed)));
            is_changed_ = true;
        }
        ImGui::SameLine();
    }

    bool begins() { return std::exchange(begins_, false); }

    Workspace& workspace_;
    ui::NumberFields& fields_;
    Transform& transform_;
    const ui::Catalogue& tr_;
    bool begins_ = false; // the next number gets the keyboard
    bool is_changed_ = false;
};

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

} // namespace

void transform_bar(Workspace& workspace, ui::NumberFields& fields)
{
    const ui::Catalogue tr = workspace.session.view.tr;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.5F * ImGui::GetFontSize(), 0.0F});
    const Transform before = *workspace.transform;
    const bool was_untouched = fields.is_untouched();
    fields.stops().begin_window(); // what is typed here is no number of the panels
    if (TransformBar(workspace, fields).show() && change_transform(workspace)) workspace.transform = before;
    const bool is_left = was_untouched && !fields.is_typing();
    const bool accepts = ImGui::Button((tr("Accept") + "###accept").c_str());
    fields.stops().add();
    ImGui::SameLine();
    const bool cancels = ImGui::Button((tr("Cancel") + "###cancel").c_str());
    fields.stops().add();
    fields.stops().end_window();
    const bool is_accepted = accepts || (is_left && is_pressed(ImGuiKey_Enter));
    const bool is_cancelled = cancels || (is_left && is_pressed(ImGuiKey_Escape));
    ImGui::PopStyleVar();
    if (is_accepted) accept_transform(workspace);
    if (is_cancelled) cancel_transform(workspace);
}

} // namespace frame
