// Numbers without the last digits that only calculating made.
#include <doctest/doctest.h>

#include <utility>

#include "femoop/edit/draw.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/merge.h"
#include "femoop/edit/place.h"
#include "femoop/edit/short_number.h"
#include "femoop/edit/split.h"

using namespace femoop;

namespace {

Model with_line(Eigen::Vector3d start, Eigen::Vector3d end)
{
    Model model;
    model.add(Material{.id = "steel", .E = 210e6});
    model.add(Section{.id = "s", .A = 0.01, .Iz = 1e-4});
    draw_member(model, start, end, Member{.material = MaterialId(0), .section = SectionId(0)});
    return model;
}

} // namespace

TEST_SUITE("edit: short numbers")
{
    TEST_CASE("What a few roundings left goes, and nothing else")
    {
        CHECK(short_number(3.0000000000000018, 3.0) == 3.0);
        CHECK(short_number(49.99999999999998, 100.0) == 50.0);
        CHECK(short_number(-0.1 - 0.2, 1.0) == -0.3);
        CHECK(short_number(4e-17, 7.0) == 0.0);
        CHECK(short_number(4e-17, 0.0) == 4e-17);
        CHECK(short_number(1.0 / 3.0, 1.0) == 1.0 / 3.0);
        CHECK(short_number(3.00000001, 3.0) == 3.00000001);
        CHECK(short_number(std::sqrt(2.0), 2.0) == std::sqrt(2.0));
    }

    TEST_CASE("Places of loads are short in the parts of a member that was cut, and in the whole again")
    {
        Model model = with_line({0.1, 0, 0}, {6.4, 0, 0}); // 6.3 long, but for rounding
        const auto at = [](Position place) {
            return PointLoad{.at = std::move(place), .components = {{Dof::uy, -7}}, .axes = {}};
        };
        model.add(LoadCase{.id = "P", .members = {{MemberId(0), at(Percent{70})}, {MemberId(0), at(Quantity(4.9))}}});
        const SplitMember cut = split_member(model, MemberId(0), 0.7 * 3);
        const auto place = [&](std::size_t load) {
            return std::get<PointLoad>(model.load_cases[0].members[load].load).at;
        };
        CHECK(model[cut.node].at[0].value() == 2.2);
        CHECK(std::get<Percent>(place(0)).value == 55.0);
        CHECK(std::get<Quantity>(place(1)).value() == 2.8);
        merge_members_at(model, cut.node);
        CHECK(std::get<Percent>(place(0)).value == 70.0);
        CHECK(std::get<Quantity>(place(1)).value() == 4.9);
    }

    TEST_CASE("Crossings, moved nodes and turned ones have short coordinates")
    {
        Model model = with_line({0, 0, 0}, {6, 4.2, 0});
        draw_member(model, {0, 4.2, 0}, {6, 0, 0}, Member{.material = MaterialId(0), .section = SectionId(0)});
        CHECK(position_of(model, NodeId(4)) == Eigen::Vector3d(3, 2.1, 0));
        place_nodes(model, std::vector{NodeId(4)}, moved_by({0.3, -1.4, 0}));
        CHECK(position_of(model, NodeId(4)) == Eigen::Vector3d(3.3, 0.7, 0));
        const double sixty = std::acos(0.5);
        place_nodes(model, std::vector{NodeId(2)}, turned({0, 0, 0}, 0.5 * sixty));
        CHECK(model.nodes[2].at[0].value() == -2.1);
    }
}
