// What the words of --show mean for plane models.
#include <doctest/doctest.h>

#include "apps/plane/view/plate_show.h"
#include "tests/apps/plane_view/plate_subject.h"

using namespace plane;
using femoop::plane::PlaneComponent;

TEST_CASE("Every word shows something, and no other word is understood")
{
    for (const std::string& word : all_plate_words()) {
        CAPTURE(word);
        CHECK(plate_shown(word).has_value());
    }
    for (const char* const word : {"", "moments", "bands", "bands:", "bands:fx", "contour:N", "bands:sr"})
        CHECK(!plate_shown(word));
}

TEST_CASE("Bands and lines stand beside each other; of two of one style the last one asked for is shown")
{
    const PlateShown all = *plate_shown("bands:sx") | *plate_shown("contour:s1") | *plate_shown("Bands:Mises");
    REQUIRE(all.fields.size() == 2);
    CHECK(all.fields[0] == FieldShow{PlaneComponent::Mises, FieldStyle::Bands});
    CHECK(all.fields[1] == FieldShow{PlaneComponent::s1, FieldStyle::Contours});
}

TEST_CASE("Geometry needs no mesh, a mesh no results, and stresses need both")
{
    CHECK(!plate_shown_by_default().needs_mesh());
    CHECK(plate_shown("mesh")->needs_mesh());
    CHECK(!plate_shown("mesh")->needs_results());
    for (const char* const word : {"deformed", "principal", "trajectories", "error", "bands:ux"}) {
        CHECK(plate_shown(word)->needs_results());
        CHECK(plate_shown(word)->needs_mesh());
    }
}

TEST_CASE("In a small window panels give way, so that the body keeps about half of it")
{
    PlateSubject plate = PlateSubject::example("hole");
    plate.mesh();
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
        for (const ui::Size sheet : {ui::Size{430.0, 520.0}, ui::Size{540.0, 500.0}, ui::Size{800.0, 700.0}}) {
            CAPTURE(sheet.width);
            PlateOptions options;
            options.theme = theme;
            options.show = options.show | *plate_shown("bands:mises");
            options.probes = {Eigen::Vector2d(120.0, 120.0)};
            options.circle = 0;
            options.cuts = {{.start = Eigen::Vector2d(40.0, -20.0), .end = Eigen::Vector2d(40.0, 260.0)}};
            const ui::Fonts fonts;
            ui::Painter painter(sheet, fonts);
            const ui::Box room = draw(painter, plate.input(), options);
            CHECK(room.width() >= 0.42 * sheet.width);
            CHECK(room.height() >= 0.45 * sheet.height);
        }
}

TEST_CASE("An empty face is named where the word has room in it: beside it the word would be its neighbour's")
{
    const auto n_strings = [](const char* radius) {
        const PlateSubject plate(R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "mm", "force": "N"},
            "materials": [{"id": "m", "E": 1000, "nu": 0.3}], "points": [],
            "curves": [{"id": "edge", "kind": "line", "points": [[0, 0], [70, 0], [70, 50], [0, 50]], "closed": true},
                       {"id": "round", "kind": "circle", "center": [31, 24], "radius": )" +
                                 std::string(radius) + R"(}],
            "regions": [{"id": "R", "at": [3, 3], "material": "m", "thickness": 1}], "load_cases": []})");
        PlateOptions options;
        options.show = options.show | *plate_shown("labels");
        const ui::Fonts fonts;
        ui::Painter painter({640.0, 480.0}, fonts);
        draw(painter, plate.input(), options);
        return painter.picture().text_boxes(fonts).size();
    };
    CHECK(n_strings("15") == n_strings("1.5") + 1);
}
