#include "ui/paint/label_placement.h"

#include "ui/paint/label/full_cells.h"
#include "ui/paint/label/obstacle_map.h"

#include <doctest/doctest.h>

#include <chrono>
#include <numbers>
#include <random>

namespace {

constexpr ui::Box room{{0.0, 0.0}, {900.0, 600.0}};

ui::OrientedBox box_of(const ui::Label& label, const ui::PlacedLabel& place)
{
    return {place.center, label.size, place.rotation};
}

ui::Point anywhere(std::mt19937& random)
{
    std::uniform_real_distribution<double> x(room.min.x, room.max.x), y(room.min.y, room.max.y);
    const double at_x = x(random);
    return {at_x, y(random)};
}

/// Labels of the size of "-12.5 kN", some of them slanted.
std::vector<ui::Label> crowd(std::mt19937& random, std::size_t n)
{
    std::uniform_real_distribution<double> width(20.0, 70.0), angle(-1.2, 1.2);
    std::vector<ui::Label> labels(n);
    for (std::size_t i = 0; i < n; ++i) {
        labels[i] = {.target = anywhere(random), .size = {width(random), 13.0}};
        labels[i].priority = static_cast<double>(i % 5);
        if (i % 3 == 0) labels[i].rotation = angle(random);
        if (i % 2 == 0) labels[i].wishes = {labels[i].target + ui::Point{0.0, -14.0}};
    }
    return labels;
}

struct Segment {
    ui::Point a;
    ui::Point b;
};

} // namespace

TEST_SUITE_BEGIN("label placement");

TEST_CASE("A label alone gets its first wish")
{
    const ui::LabelPlacer placer({.room = room});
    const std::vector<ui::Label> labels = {
        {.target = {300.0, 200.0}, .size = {40.0, 13.0}, .wishes = {{321.5, 187.25}, {270.0, 187.0}}}};
    const auto placement = placer.place(labels);
    REQUIRE(placement.labels[0]);
    CHECK(placement.labels[0]->center == ui::Point{321.5, 187.25});
    CHECK_FALSE(placement.labels[0]->leader);
}

TEST_CASE("A label whose first wish lies on a line gets its second one")
{
    ui::LabelPlacer placer({.room = room});
    placer.obstacles().add_segment({0.0, 187.0}, {900.0, 190.0}, 3.0);
    const std::vector<ui::Label> labels = {
        {.target = {300.0, 200.0}, .size = {40.0, 13.0}, .wishes = {{321.5, 187.25}, {330.0, 215.0}}}};
    REQUIRE(placer.place(labels).labels[0]);
    CHECK(placer.place(labels).labels[0]->center == ui::Point{330.0, 215.0});
}

TEST_CASE("A label that means something on one side only stands there, or farther off with a leader, or nowhere")
{
    ui::LabelPlacer placer({.room = room});
    placer.obstacles().add_box({{250.0, 150.0}, {350.0, 199.0}});
    ui::Label label{.target = {300.0, 200.0}, .size = {40.0, 13.0}, .wishes = {{300.0, 188.0}, {300.0, 212.0}}};
    REQUIRE(placer.place(std::vector{label}).labels[0]);
    CHECK(placer.place(std::vector{label}).labels[0]->center.y > 200.0);
    label.side = ui::HalfPlane{{0.0, 202.0}, {0.0, -1.0}};
    REQUIRE(placer.place(std::vector{label}).labels[0]);
    CHECK(placer.place(std::vector{label}).labels[0]->center.y <= 202.0);
    label.reach = 20.0;
    placer.obstacles().add_box({{200.0, 100.0}, {400.0, 215.0}});
    CHECK_FALSE(placer.place(std::vector{label}).labels[0]);
}

TEST_CASE("Of two labels that want one place the one of higher priority has it")
{
    const ui::LabelPlacer placer({.room = room});
    const ui::Label humble{.target = {300.0, 200.0}, .size = {40.0, 13.0}, .wishes = {{320.0, 190.0}}, .priority = 1.0};
    ui::Label proud = humble;
    proud.priority = 2.0;
    const auto placement = placer.place(std::vector{humble, proud});
    REQUIRE(placement.labels[0]);
    REQUIRE(placement.labels[1]);
    CHECK(placement.labels[1]->center == ui::Point{320.0, 190.0});
    CHECK(placement.labels[0]->center != ui::Point{320.0, 190.0});
}

TEST_CASE("An area without its outline is soft ground within, where a label lies in it as a whole, and free beside it")
{
    ui::LabelObstacles obstacles({{0.0, 0.0}, {200.0, 200.0}});
    const std::vector<ui::Point> square = {{40.0, 40.0}, {160.0, 40.0}, {160.0, 160.0}, {40.0, 160.0}};
    obstacles.add_inside(square, ui::Firmness::Soft);
    CHECK(obstacles.ground_of({{100.0, 100.0}, {20.0, 10.0}}) == ui::Ground::Soft);
    CHECK(obstacles.ground_of({{20.0, 20.0}, {20.0, 10.0}}) == ui::Ground::Free);
}

TEST_CASE("In random crowds no label covers another, an obstacle or a leader, and none leaves the room")
{
    for (unsigned seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const auto labels = crowd(random, 20 + 12 * seed);
        ui::LabelPlacer placer({.room = room});
        std::vector<Segment> segments;
        for (int i = 0; i < 40; ++i) {
            const ui::Point a = anywhere(random), far = anywhere(random);
            segments.push_back({a, a + 0.3 * (far - a)});
            placer.obstacles().add_segment(segments.back().a, segments.back().b, 3.0);
        }
        const ui::Point corner = anywhere(random);
        const std::vector<ui::Point> triangle = {corner, corner + ui::Point{90.0, 20.0},
                                                 corner + ui::Point{30.0, 120.0}};
        placer.obstacles().add_polygon(triangle);

        const auto placement = placer.place(labels);
        REQUIRE(placement.labels.size() == labels.size());
        std::vector<ui::OrientedBox> boxes;
        std::vector<ui::Leader> leaders;
        std::vector<std::size_t> owner, leader_owner;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (!placement.labels[i]) continue;
            boxes.push_back(box_of(labels[i], *placement.labels[i]));
            owner.push_back(i);
            if (placement.labels[i]->leader) {
                leaders.push_back(*placement.labels[i]->leader);
                leader_owner.push_back(i);
            }
        }
        int n_faults = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            n_faults += room.contains(boxes[i].bounds()) ? 0 : 1;
            for (std::size_t j = 0; j < i; ++j) n_faults += boxes[i].overlaps(boxes[j]) ? 1 : 0;
            for (const Segment& s : segments) n_faults += boxes[i].meets_segment(s.a, s.b) ? 1 : 0;
            for (std::size_t k = 0; k < 3; ++k)
                n_faults += boxes[i].meets_segment(triangle[k], triangle[(k + 1) % 3]) ? 1 : 0;
            for (std::size_t k = 0; k < leaders.size(); ++k)
                if (leader_owner[k] != owner[i])
                    n_faults += boxes[i].meets_segment(leaders[k].from, leaders[k].to) ? 1 : 0;
        }
        CHECK(n_faults == 0);
        CHECK(boxes.size() + placement.n_left_out == labels.size());
    }
}

TEST_CASE("A hundred and sixty labels, a fifth of the sheet, are all placed")
{
    std::mt19937 random(7);
    const auto labels = crowd(random, 160);
    const ui::LabelPlacer placer({.room = room});
    CHECK(placer.place(labels).n_left_out == 0);
}

TEST_CASE("The same labels are placed in the same way every time")
{
    std::mt19937 random(11);
    const auto labels = crowd(random, 200);
    const ui::LabelPlacer placer({.room = room});
    const auto first = placer.place(labels), second = placer.place(labels);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        REQUIRE(first.labels[i].has_value() == second.labels[i].has_value());
        if (first.labels[i]) CHECK(first.labels[i]->center == second.labels[i]->center);
    }
}

TEST_CASE("A label that must go far gets a leader from its border to its target")
{
    ui::LabelPlacer placer({.room = room});
    const ui::Point target{450.0, 300.0};
    placer.obstacles().add_disc(target, 60.0);
    const std::vector<ui::Label> labels = {{.target = target, .size = {40.0, 13.0}}};
    const auto placement = placer.place(labels);
    REQUIRE(placement.labels[0]);
    REQUIRE(placement.labels[0]->leader);
    CHECK(placement.labels[0]->leader->to == target);
    CHECK(ui::distance(placement.labels[0]->leader->from, target) >= 60.0);
}

TEST_CASE("A label that needs sight of its target has a leader behind a line, however near it stands")
{
    // A load of 12 px below a beam: all places above it are beyond the beam.
    ui::LabelPlacer placer({.room = {{0.0, 0.0}, {300.0, 112.0}}});
    placer.obstacles().add_segment({0.0, 90.0}, {300.0, 90.0}, 4.0);
    ui::Label label{.target = {150.0, 98.0}, .size = {40.0, 10.0}, .wishes = {{150.0, 80.0}}};
    const auto place_of = [&] { return placer.place(std::vector{label}).labels[0]; };
    REQUIRE(place_of());
    CHECK_FALSE(place_of()->leader);
    CHECK(place_of()->center == label.wishes[0]);

    label.needs_sight = true;
    REQUIRE(place_of());
    CHECK(place_of()->leader);

    const std::vector other{ui::Point{150.0, 86.0}}; // on this side
    label.others = other;
    CHECK(place_of()->center == label.wishes[0]);
    CHECK_FALSE(place_of()->leader);
}

TEST_CASE("A label that needs sight has a leader where its middle is nearer to what another of its kind speaks of")
{
    std::vector<ui::Label> labels(2);
    labels[0] = {.target = {150.0, 150.0}, .size = {40.0, 12.0}, .wishes = {{160.0, 140.0}}, .needs_sight = true};
    labels[1] = {.target = {176.0, 150.0}, .size = {40.0, 12.0}, .wishes = {{200.0, 300.0}}, .needs_sight = true};
    const auto first = [&] { return ui::LabelPlacer({.room = {{0.0, 0.0}, {400.0, 400.0}}}).place(labels).labels[0]; };
    CHECK(first()->center == labels[0].wishes[0]);

    labels[0].wishes[0].x = 166.0;
    REQUIRE(first());
    CHECK(first()->center != labels[0].wishes[0]);
    labels[1].needs_sight = false;
    CHECK(first()->center == labels[0].wishes[0]);

    labels[1].needs_sight = true;
    const std::vector along{ui::Point{130.0, 150.0}};
    labels[0].others = along; // as of a load along a member
    CHECK(first()->center == labels[0].wishes[0]);
}

TEST_CASE("A leader never begins at the middle of its text's height, where it would read as a minus sign")
{
    const ui::Point target{450.0, 300.0};
    for (int i = 0; i < 72; ++i) {
        const double angle = 5.0 * i * std::numbers::pi / 180.0;
        const ui::Point wish = target + 70.0 * ui::Point{std::cos(angle), std::sin(angle)};
        const double most = 40.0; // only the place around `wish` is free
        ui::LabelPlacer placer({.room = {wish - ui::Point{most, 14.0}, wish + ui::Point{most, 14.0}}});
        const std::vector<ui::Label> labels = {{.target = target, .size = {40.0, 13.0}}};
        const auto placement = placer.place(labels);
        if (!placement.labels[0] || !placement.labels[0]->leader) continue;
        const ui::Point from = placement.labels[0]->leader->from;
        CAPTURE(angle);
        CHECK(std::abs(from.y - placement.labels[0]->center.y) == doctest::Approx(6.5));
    }
}

TEST_CASE("A leader keeps farther from the sides of other texts than from their top")
{
    // The leader of the first would pass 3 pixels before the second one's text.
    const std::vector<ui::Label> labels = {
        {.target = {100.0, 100.0}, .size = {40.0, 13.0}, .wishes = {}, .priority = 1.0, .clearance = 40.0},
        {.target = {300.0, 80.0}, .size = {40.0, 13.0}, .wishes = {{}}, .priority = 2.0, .reach = 0.0}};
    const ui::LabelPlacer placer({.room = room});
    const auto alone = placer.place(std::span(labels).first(1));
    REQUIRE(alone.labels[0]);
    REQUIRE(alone.labels[0]->leader);
    const ui::Point middle = 0.5 * (alone.labels[0]->leader->from + alone.labels[0]->leader->to);
    std::vector<ui::Label> both = labels;
    both[1].wishes = {middle + ui::Point{23.0, 0.0}};
    const auto placement = placer.place(both);
    REQUIRE(placement.labels[0]);
    CHECK(placement.labels[0]->center != alone.labels[0]->center);
}

TEST_CASE("A label is turned only where it finds no level place that it wishes")
{
    constexpr double upright = std::numbers::pi / 2.0;
    const std::vector<ui::Label> labels = {{.target = {300.0, 200.0},
                                            .size = {60.0, 13.0},
                                            .wishes = {{335.0, 200.0}},
                                            .turned = {{310.0, 200.0}},
                                            .turn = upright}};
    ui::LabelPlacer placer({.room = room});
    const auto level = placer.place(labels).labels[0];
    REQUIRE(level);
    CHECK(level->rotation == 0.0);
    placer.obstacles().add_segment({325.0, 100.0}, {325.0, 300.0}, 2.0); // leaves a strip of 24 pixels
    const auto turned = placer.place(labels).labels[0];
    REQUIRE(turned);
    CHECK(turned->center == ui::Point{310.0, 200.0});
    CHECK(turned->rotation == upright);
    CHECK_FALSE(turned->leader);
}

TEST_CASE("A label covers a soft obstacle only where all else is full, and a hard one never")
{
    ui::LabelPlacer soft({.room = room}), hard({.room = room});
    soft.obstacles().add_box(room, ui::Firmness::Soft);
    hard.obstacles().add_box(room, ui::Firmness::Hard);
    const std::vector<ui::Label> labels = {{.target = {450.0, 300.0}, .size = {40.0, 13.0}}};
    CHECK(soft.place(labels).n_left_out == 0);
    CHECK(soft.place(labels).labels[0]->is_over_soft);
    CHECK(!ui::LabelPlacer({.room = room}).place(labels).labels[0]->is_over_soft);
    CHECK(hard.place(labels).n_left_out == 1);
    soft.obstacles().add_box({{0.0, 0.0}, {450.0, 600.0}}, ui::Firmness::Hard);
    REQUIRE(soft.place(labels).labels[0]);
    CHECK(soft.place(labels).labels[0]->center.x - 20.0 > 450.0);
}

TEST_CASE("What is left out has the lowest priority")
{
    const ui::Box slot{{0.0, 0.0}, {100.0, 20.0}}; // room for two
    const ui::LabelPlacer placer({.room = slot});
    std::vector<ui::Label> labels;
    for (const double priority : {1.0, 3.0, 0.5, 2.0})
        labels.push_back({.target = {50.0, 10.0},
                          .size = {44.0, 13.0},
                          .wishes = {{23.0, 10.0}, {77.0, 10.0}},
                          .priority = priority});
    const auto placement = placer.place(labels);
    CHECK(placement.n_left_out == 2);
    CHECK(placement.labels[1]);
    CHECK(placement.labels[3]);
}

TEST_CASE("A label moves aside for another that has no choice")
{
    const ui::LabelPlacer placer({.room = {{0.0, 0.0}, {300.0, 20.0}}});
    const std::vector<ui::Label> labels = {
        {.target = {50.0, 10.0},
         .size = {44.0, 13.0},
         .wishes = {{50.0, 10.0}, {150.0, 10.0}},
         .priority = 2.0,
         .reach = 0.0},
        {.target = {50.0, 10.0}, .size = {44.0, 13.0}, .wishes = {{50.0, 10.0}}, .priority = 1.0, .reach = 0.0}};
    const auto placement = placer.place(labels);
    CHECK(placement.n_left_out == 0);
    REQUIRE(placement.labels[0]);
    CHECK(placement.labels[0]->center.x == 150.0);
}

TEST_CASE("A label of higher priority goes far from its target only where the other would be left out")
{
    ui::LabelPlacer placer({.room = {{0.0, 0.0}, {300.0, 100.0}}, .leader_after = 0.0});
    placer.obstacles().add_box({{170.0, 40.0}, {230.0, 60.0}}, ui::Firmness::Soft);
    std::vector<ui::Label> labels = {
        {.target = {50.0, 80.0}, .size = {44.0, 13.0}, .wishes = {{50.0, 50.0}}, .priority = 2.0},
        {.target = {50.0, 50.0},
         .size = {44.0, 13.0},
         .wishes = {{50.0, 50.0}, {200.0, 50.0}},
         .priority = 1.0,
         .reach = 0.0}};
    auto placement = placer.place(labels);
    REQUIRE(placement.n_left_out == 0);
    CHECK_FALSE(placement.labels[0]->leader);
    CHECK(placement.labels[1]->is_over_soft);

    labels[1].wishes.pop_back();
    placement = placer.place(labels);
    REQUIRE(placement.n_left_out == 0);
    CHECK(placement.labels[0]->leader);
    CHECK(placement.labels[1]->center == labels[1].wishes[0]);
}

TEST_CASE("Where four labels found no room a fifth one need not look, unless it is smaller or elsewhere")
{
    ui::FullCells full(room);
    const ui::Point here{410.0, 310.0};
    for (const double width : {62.0, 48.0, 55.0, 71.0}) {
        CHECK(!full.has_no_room(here, {40.0, 13.0}));
        CHECK(!full.has_no_room(here, {90.0, 13.0}));
        full.found_no_room(here, {width, 13.0});
    }
    CHECK(full.has_no_room(here + ui::Point{3.0, -2.0}, {48.0, 13.0}));
    CHECK(!full.has_no_room(here, {47.0, 13.0}));
    CHECK(!full.has_no_room({130.0, 310.0}, {48.0, 13.0}));
}

TEST_CASE("A label with a target that is not finite is left out and harms nobody")
{
    const ui::LabelPlacer placer({.room = room});
    const std::vector<ui::Label> labels = {{.target = {std::nan(""), 10.0}, .size = {44.0, 13.0}},
                                           {.target = {50.0, 50.0}, .size = {44.0, 13.0}}};
    const auto placement = placer.place(labels);
    CHECK(placement.n_left_out == 1);
    CHECK(placement.labels[1]);
}

TEST_CASE("The map of obstacles answers for every box as the obstacles themselves do")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> width(0.0, 9.0), side(3.0, 80.0), angle(-1.5, 1.5);
    ui::LabelObstacles obstacles(room);
    for (int i = 0; i < 60; ++i) {
        const ui::Point a = anywhere(random), far = anywhere(random);
        const auto firmness = i % 3 == 0 ? ui::Firmness::Soft : ui::Firmness::Hard;
        obstacles.add_segment(a, a + 0.2 * (far - a), width(random), firmness);
        if (i % 10 == 0) obstacles.add_box({a, a + ui::Point{70.0, 50.0}}, firmness);
    }
    const ui::ObstacleMap map(obstacles);
    int n_free = 0, n_other = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double w = side(random);
        const ui::OrientedBox box(anywhere(random), {w, side(random)}, i % 4 == 0 ? angle(random) : 0.0);
        const ui::Ground exact = obstacles.ground_of(box);
        n_free += exact == ui::Ground::Free ? 1 : 0;
        n_other += map.ground_of(box) != exact ? 1 : 0;
    }
    CHECK(n_other == 0);
    CHECK(n_free > 2000); // both answers occur
    CHECK(n_free < 18'000);
}

TEST_SUITE_END();
