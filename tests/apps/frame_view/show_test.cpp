// What `--show` understands, and how a sheet is divided.
#include <doctest/doctest.h>

#include "apps/frame/view/sheet/panels.h"
#include "apps/frame/view/show.h"

#include <string>

using namespace frame;

TEST_SUITE_BEGIN("frame");

TEST_CASE("A list of words shows each of them, in either case and with blanks around")
{
    CHECK(parse_show("loads, m ,Vy") == ShowSet{Show::Loads, Show::M, Show::Vy});
    CHECK(parse_show("") == ShowSet{});
}

TEST_CASE("labels stands for values, names and the legend")
{
    CHECK(parse_show("labels") == ShowSet{Show::Values, Show::NodeNames, Show::MemberNames, Show::Legend});
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
        for (const ShowWord& known : show_words()) {
            CAPTURE(known.word);
            CHECK(words.find(known.word) != std::string::npos);
        }
    }
}

TEST_CASE("Loads and each result get a panel of their own")
{
    const ui::Box area{{0.0, 40.0}, {1200.0, 840.0}};
    const auto list = panels({.show = parse_show("loads,N,V,M"), .has_results = true, .area = area, .aspect = 1.4});
    REQUIRE(list.size() == 4);
    CHECK(list[0].show.contains(Show::Loads));
    CHECK(!list[0].show.contains(Show::M));
    CHECK(list[3].show.contains(Show::M));
    CHECK(!list[3].show.contains(Show::Loads));
    for (std::size_t i = 0; i < list.size(); ++i) {
        CHECK(area.contains(list[i].box));
        for (std::size_t j = 0; j < i; ++j) CHECK(!list[i].box.overlaps(list[j].box));
    }
}

TEST_CASE("The panels of a beam stand below one another")
{
    const auto list = panels({.show = parse_show("loads,V,M"),
                              .has_results = true,
                              .area = {{0.0, 0.0}, {1000.0, 900.0}},
                              .aspect = 1000.0});
    REQUIRE(list.size() == 3);
    CHECK(list[0].box.min.x == list[2].box.min.x);
    CHECK(list[2].box.min.y == doctest::Approx(600.0));
}

TEST_CASE("Without results, or laid over one another, there is one panel")
{
    const ui::Box area{{0.0, 0.0}, {800.0, 600.0}};
    CHECK(panels({.show = parse_show("loads,V,M"), .has_results = false, .area = area}).size() == 1);
    CHECK(panels({.show = parse_show("loads,V,M"), .layout = Layout::Overlay, .has_results = true, .area = area})
              .size() == 1);
}

TEST_SUITE_END();
