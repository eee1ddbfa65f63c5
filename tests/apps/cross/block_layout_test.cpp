// Where the columns of numbers stand beside the member ends of a frame.
#include <doctest/doctest.h>

#include "apps/cross/view/block_layout.h"

using namespace cross;

namespace {

constexpr double left = 209.0, right = 736.0;

/// Two storeys: the ends at the joints of the left column, of the right one, then their feet, beside which there is no
/// room left but behind other columns of numbers.
BlockRequest two_storeys()
{
    constexpr double roof = 243.0, floor = 425.0, ground = 637.0;
    BlockRequest request{.places = {}, .obstacles = {}, .room = {{0.0, 50.0}, {920.0, 720.0}}};
    request.middle = {0.5 * (left + right), 0.5 * (roof + ground)};
    request.largest_type = 19.0;
    request.n_rows = 3;
    request.width_of = [](double type) { return 5.2 * type; };
    const ui::Point up{0.0, -1.0}, down{0.0, 1.0};
    const auto add_end = [&](ui::Point joint, ui::Point along, double length) {
        request.places.push_back({femoop::cross::EndId(request.places.size()), joint, along, length});
    };
    for (const double x : {left, right}) {
        const ui::Point inward{x == left ? 1.0 : -1.0, 0.0};
        add_end({x, floor}, down, ground - floor);
        add_end({x, floor}, up, floor - roof);
        add_end({x, floor}, inward, right - left);
        add_end({x, roof}, down, floor - roof);
        add_end({x, roof}, inward, right - left);
    }
    for (const double x : {left, right}) {
        add_end({x, ground}, up, ground - floor);
        request.walls.push_back(ui::Box{{x, roof}, {x, ground}}.grown(2.0));
        request.obstacles.push_back({{x - 24.0, ground - 8.0}, {x + 24.0, ground + 40.0}}); // a support
    }
    for (const double y : {roof, floor}) request.walls.push_back(ui::Box{{left, y}, {right, y}}.grown(2.0));
    request.obstacles.insert(request.obstacles.end(), request.walls.begin(), request.walls.end());
    return request;
}

} // namespace

TEST_CASE("Columns of a frame's feet stand outside, in smaller type, rather than behind those of the beam above")
{
    const BlockRequest request = two_storeys();
    const BlockLayout layout = laid_out(request);
    REQUIRE(layout.boxes.size() == 12);
    for (const auto& box : layout.boxes) REQUIRE(box);
    CHECK(layout.boxes[10]->max.x < left);
    CHECK(layout.boxes[11]->min.x > right);
    CHECK(layout.type >= 0.7 * request.largest_type);
}
