#include "ui/widgets/field_row.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <imgui.h>

TEST_SUITE_BEGIN("field row");

namespace {

struct Place {
    float begin = 0.0F; ///< [px]
    float below = 0.0F; ///< the row's name [px]
    bool holds_text = false;
};

/// Where the field of a row stands in a panel that is so many pixels wide.
Place place_of_field(float width, const char* name, const char* text)
{
    ui_test::WidgetStage stage{1.0};
    Place place;
    stage.frame({}, [&] {
        ImGui::BeginChild("panel", {width, 0.0F});
        const ImVec2 start = ImGui::GetCursorPos();
        ui::begin_field_row(name, text);
        const float room = ImGui::GetContentRegionAvail().x;
        place = {ImGui::GetCursorPosX(), ImGui::GetCursorPosY() - start.y, ImGui::CalcTextSize(text).x <= room};
        ImGui::EndChild();
    });
    return place;
}

} // namespace

TEST_CASE("A number stands whole in its field, however narrow the panel")
{
    if (!ui_test::has_renderer()) return;
    for (const float width : {280.0F, 200.0F, 160.0F, 125.0F})
        for (const char* name : {"σx", "σ1 [MPa]", "direction 1"})
            for (const char* text : {"50 MPa", "−1234.567 MPa"}) {
                CAPTURE(width);
                CAPTURE(name);
                CAPTURE(text);
                CHECK(place_of_field(width, name, text).holds_text);
            }
}

TEST_CASE("Fields begin in one column, whatever is shown, where it has room for them")
{
    if (!ui_test::has_renderer()) return;
    const Place first = place_of_field(280.0F, "σx", "50 MPa"), second = place_of_field(280.0F, "σ1 [MPa]", "−30");
    CHECK(first.begin == second.begin);
    CHECK(first.below == 0.0F);
    CHECK(place_of_field(125.0F, "direction 1", "−1234.567 MPa").below > 0.0F);
}
