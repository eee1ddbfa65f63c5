// What `--show` understands, and how a sheet is divided.
#include <doctest/doctest.h>

#include "apps/drawing/sheet/panels.h"
#include "apps/drawing/sheet/subject.h"
#include "apps/drawing/show.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"

#include <string>
#include <utility>

using namespace drawing;

TEST_SUITE_BEGIN("frame");

TEST_CASE("A list of words shows each of them, in either case and with blanks around")
{
    CHECK(parse_show("loads, m ,Vy") == ShowSet{Show::Loads, Show::M, Show::Vy});
    CHECK(parse_show("") == ShowSet{});
}

TEST_CASE("labels stands for values, names, drawn dimension lines and the legend")
{
    CHECK(parse_show("labels") ==
          ShowSet{Show::Values, Show::NodeNames, Show::MemberNames, Show::DrawnDimensions, Show::Legend});
    CHECK(parse_show("loads,reactions,labels") == shown_by_default);
}

TEST_CASE("An unknown word is refused with the list of those that there are")
{
    try {
        parse_show("loads,momnet");
        FAIL("accepted");
    } catch (const ShowError& error) {
        const std::string words = error.what();
        CHECK(words.find("momnet") != std::string::npos);
        for (const ShowWord& known : show_text()) {
            CAPTURE(known.word);
            CHECK(words.find(known.word) != std::string::npos);
        }
    }
}

TEST_CASE("Loads and each result get a panel of their own")
{
    const ui::Box area{{0.0, 40.0}, {1200.0, 840.0}};
    const auto contents = panel_contents({.show = parse_show("loads,N,V,M"), .has_results = true});
    REQUIRE(contents.size() == 4);
    CHECK(contents[0].contains(Show::Loads));
    CHECK(!contents[0].contains(Show::M));
    CHECK(contents[3].contains(Show::M));
    CHECK(!contents[3].contains(Show::Loads));
    for (const std::size_t columns : {1U, 2U, 3U, 4U}) {
        const auto list = panels(contents, area, columns);
        for (std::size_t i = 0; i < list.size(); ++i) {
            CHECK(area.contains(list[i].box));
            for (std::size_t j = 0; j < i; ++j) CHECK(!list[i].box.overlaps(list[j].box));
        }
    }
}

TEST_CASE("The panels of a beam stand below one another, those of a tower side by side")
{
    const ui::Fonts fonts;
    DrawOptions options;
    options.show = parse_show("loads,V,M");
    const auto planned = [&](femoop::Model model) {
        const femoop::Results results = femoop::analyse(model);
        return Subject({model, &results}, options, {}).plan({1000.0, 900.0}, fonts).panels;
    };
    const auto beam = planned(view_test::simple_beam(7.0, 12.0));
    REQUIRE(beam.size() == 3);
    CHECK(beam[0].box.min.x == beam[2].box.min.x);
    CHECK(beam[2].box.min.y == doctest::Approx(600.0));
    femoop::Model tower = view_test::simple_beam(7.0, 12.0);
    std::swap(tower.nodes[1].at[0], tower.nodes[1].at[1]);
    tower.nodes[1].support = femoop::Support{.fixed = {femoop::Dof::ux}};
    const auto columns = planned(tower);
    REQUIRE(columns.size() == 3);
    CHECK(columns[0].box.min.y == columns[2].box.min.y);
}

TEST_CASE("Without results, or laid over one another, there is one panel")
{
    CHECK(panel_contents({.show = parse_show("loads,V,M"), .has_results = false}).size() == 1);
    CHECK(panel_contents({.show = parse_show("loads,V,M"), .layout = Layout::Overlay, .has_results = true}).size() ==
          1);
}

TEST_SUITE_END();
