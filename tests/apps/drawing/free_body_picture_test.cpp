// Free bodies beside the structure that they are lifted out of.
#include "apps/drawing/results/free_body_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "apps/drawing/draw.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"
#include "ui/paint/theme.h"

using namespace drawing;
using femoop::free_body::body_of;

namespace {

view_test::Marks drawn_body(const ui::Fonts& fonts, const femoop::Model& model, const femoop::free_body::Body& body)
{
    const femoop::Results results = femoop::analyse(model);
    const FreeBodyPicture picture{.lifted = femoop::free_body::lift_out(model, results, femoop::CaseId(0), body),
                                  .aside = {0.0, 12.0, 0.0}};
    ui::Painter painter({900.0, 800.0}, fonts);
    draw(painter, {.model = model, .results = &results, .free_body = &picture},
         {.show = {Show::Values, Show::NodeNames}});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

auto n_discs(const view_test::Marks& marks, ui::Role role)
{
    const ui::Color fill = ui::Theme(ui::ThemeName::Light).fill(role);
    return std::ranges::count(marks.discs, fill, &view_test::Marks::Disc::fill);
}

bool is_on(ui::Point place, const view_test::Marks::Line& line)
{
    const ui::Point a = line.points.front(), along = line.points.back() - a;
    const double t = std::clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0);
    return length(place - a - t * along) < 2.0;
}

/// Those whose arrows lie on no member.
std::size_t n_loads_off_members(const view_test::Marks& marks)
{
    const ui::Theme theme(ui::ThemeName::Light);
    const ui::Color load = theme.stroke(ui::Role::Load).color, member = theme.stroke(ui::Role::Member).color;
    std::size_t n_loads = 0;
    for (const auto& arrow : marks.lines) {
        if (arrow.stroke.color != load) continue;
        const ui::Point middle = 0.5 * (arrow.points.front() + arrow.points.back());
        if (std::ranges::none_of(marks.lines,
                                 [&](const auto& line) { return line.stroke.color == member && is_on(middle, line); }))
            ++n_loads;
    }
    return n_loads;
}

} // namespace

TEST_CASE("A hinge is lifted out as a hinge, and a rigid joint as a dot")
{
    const ui::Fonts fonts;
    const femoop::Model arch = view_test::example("three_hinged_arch");
    REQUIRE(arch[*arch.find_node("E")].hinge);
    const auto hinge = drawn_body(fonts, arch, body_of(*arch.find_node("E")));
    const auto joint = drawn_body(fonts, arch, body_of(*arch.find_node("D")));
    CHECK(n_discs(hinge, ui::Role::Hinge) == n_discs(joint, ui::Role::Hinge) + 1);
    CHECK(n_discs(hinge, ui::Role::Node) == n_discs(joint, ui::Role::Node) - 1);
}

TEST_CASE("An end that is released is lifted out with its hinge, a node by itself without those of others")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::example("portal");
    const auto n_hinges = [&](const char* node) {
        return n_discs(drawn_body(fonts, model, body_of(*model.find_node(node))), ui::Role::Hinge);
    };
    REQUIRE(n_hinges("B") == 0);
    model.members[model.find_member("BC")->index].start.release.insert(femoop::Dof::rz);
    CHECK(n_hinges("B") == n_hinges("C") + 1);
}

TEST_CASE("A load at a joint of a part of a truss hangs where no bar is")
{
    const ui::Fonts fonts;
    const femoop::Model truss = view_test::example("pratt_truss");
    const femoop::Discretisation structure = discretise(truss);
    std::vector<femoop::free_body::Cut> cuts;
    std::vector<femoop::NodeId> left;
    for (const char* bar : {"U2U3", "U2L3", "L2L3"}) {
        const femoop::MemberId id = *truss.find_member(bar);
        cuts.push_back({id, 0.5 * structure.geometry(id).length});
        left.push_back(truss[id].nodes[0]);
    }
    const auto marks = drawn_body(fonts, truss, body_of(structure, cuts, left));
    CHECK(n_loads_off_members(marks) == 2);
}

TEST_CASE("A load along a member is drawn beside it")
{
    const ui::Fonts fonts;
    const femoop::Model portal = view_test::example("portal");
    const std::vector<femoop::MemberId> column{*portal.find_member("CD")};
    CHECK(n_loads_off_members(drawn_body(fonts, portal, body_of(discretise(portal), column))) == 1); // its weight
}

TEST_CASE("At a corner the shear force of each cut is written beyond its own section, away from the other member")
{
    const ui::Fonts fonts;
    const femoop::Model portal = view_test::example("portal");
    const auto marks = drawn_body(fonts, portal, body_of(*portal.find_node("B")));
    const ui::Color shear = ui::Theme(ui::ThemeName::Light).stroke(ui::Role::ShearForce).color;
    const auto box_of = [&](std::string_view words) {
        const auto found = std::ranges::find(marks.texts, words, &view_test::Marks::Text::words);
        REQUIRE(found != marks.texts.end());
        return found->box;
    };
    std::size_t n_arrows = 0;
    for (const auto& arrow : marks.lines) {
        const ui::Point a = arrow.points.front(), b = arrow.points.back();
        const double x = 0.5 * (a.x + b.x), y = 0.5 * (a.y + b.y);
        if (arrow.stroke.color != shear) continue;
        if (std::abs(a.x - b.x) < 1.0 && y > box_of("N = 14.2 kN (C)").max.y) { // V of BC: down from its end
            if (x < box_of("N = 50.6 kN (C)").max.x) continue;
            CHECK(box_of("V = 50.6 kN").min.x > x);
            ++n_arrows;
        } else if (std::abs(a.y - b.y) < 1.0 && y > box_of("V = 50.6 kN").max.y) { // V of AB
            CHECK(box_of("V = 14.2 kN").min.y > y);
            ++n_arrows;
        }
    }
    CHECK(n_arrows == 2);
}

TEST_CASE("The forces of bars that are cut side by side have the bars' names, those of bars that part do not")
{
    const ui::Fonts fonts;
    femoop::Model truss = view_test::example("pratt_truss");
    const auto cut_near = [&](double share) { // of each bar, from its left node
        const femoop::Discretisation structure = discretise(truss);
        std::vector<femoop::free_body::Cut> cuts;
        std::vector<femoop::NodeId> left;
        for (const char* bar : {"U2U3", "U2L3", "L2L3"}) {
            const femoop::MemberId id = *truss.find_member(bar);
            cuts.push_back({id, share * structure.geometry(id).length});
            left.push_back(truss[id].nodes[0]);
        }
        return drawn_body(fonts, truss, body_of(structure, cuts, left));
    };
    const auto n_texts = [](const view_test::Marks& marks, std::string_view beginning) {
        return std::ranges::count_if(marks.texts, [&](const auto& text) { return text.words.starts_with(beginning); });
    };
    const auto apart = cut_near(0.5); // the diagonal goes down by 4 on 3
    CHECK(n_texts(apart, "N = ") == 3);
    CHECK(n_texts(apart, "N(") == 0);
    truss.nodes[truss.find_node("L3")->index].at[1] = femoop::Quantity(2.5); // now by 1.5 on 3
    const auto near = cut_near(0.05);
    CHECK(n_texts(near, "N(U2U3) = ") == 1);
    CHECK(n_texts(near, "N(U2L3) = ") == 1);
}

TEST_CASE("In space the forces have the names of their members where several are cut, and only there")
{
    const ui::Fonts fonts;
    const femoop::Model balcony = view_test::example("balcony");
    const auto n_named = [&](const femoop::free_body::Body& body) {
        const auto marks = drawn_body(fonts, balcony, body);
        return std::ranges::count_if(marks.texts, [](const auto& text) {
            return text.words.starts_with("T(AB) = ") || text.words.starts_with("Mz(AB) = ") ||
                   text.words.starts_with("Mz(BC) = ") || text.words.starts_with("Vy(AB) = ") ||
                   text.words.starts_with("Vy(BC) = ");
        });
    };
    CHECK(n_named(body_of(*balcony.find_node("B"))) == 4); // at B the one has no Mz, the other no T
    CHECK(n_named(body_of(*balcony.find_node("C"))) == 0);
}

TEST_CASE("A load and a reaction on one side of a node stand beside each other")
{
    const ui::Fonts fonts;
    femoop::Model truss = view_test::example("pratt_truss");
    const femoop::NodeId support = *truss.find_node("L0");
    truss.load_cases[0].nodes.push_back(
        {.node = support, .components = {{.dof = femoop::Dof::ux, .value = femoop::Quantity(7.0)}}});
    const auto marks = drawn_body(fonts, truss, body_of(support));
    const ui::Theme theme(ui::ThemeName::Light);
    std::vector<double> heights;
    for (const auto& line : marks.lines) {
        const ui::Point a = line.points.front(), b = line.points.back();
        const bool is_arrow = line.stroke.color == theme.stroke(ui::Role::Load).color ||
                              line.stroke.color == theme.stroke(ui::Role::Reaction).color;
        if (is_arrow && std::abs(a.y - b.y) < 0.5 && std::abs(a.x - b.x) > 20.0) heights.push_back(a.y);
    }
    REQUIRE(heights.size() == 2);
    CHECK(std::abs(heights[0] - heights[1]) > 6.0);
}

TEST_CASE("The value of a bar that is cut beside another stands on the far side of its arrow from that one")
{
    const ui::Fonts fonts;
    femoop::Model truss = view_test::example("pratt_truss");
    truss.nodes[truss.find_node("L3")->index].at[1] = femoop::Quantity(2.5);
    const femoop::Discretisation structure = discretise(truss);
    std::vector<femoop::free_body::Cut> cuts;
    std::vector<femoop::NodeId> left;
    for (const char* bar : {"U2U3", "U2L3", "L2L3"}) {
        const femoop::MemberId id = *truss.find_member(bar);
        cuts.push_back({id, 0.2 * structure.geometry(id).length});
        left.push_back(truss[id].nodes[0]);
    }
    const auto marks = drawn_body(fonts, truss, body_of(structure, cuts, left));
    const auto middle_of = [&](std::string_view beginning) {
        const auto found = std::ranges::find_if(marks.texts,
                                                [&](const auto& text) { return text.words.starts_with(beginning); });
        REQUIRE(found != marks.texts.end());
        return 0.5 * (found->box.min + found->box.max);
    };
    std::vector<double> heights; // of the arrows of the two bars, the upper one first
    for (const auto& line : marks.lines)
        if (line.stroke.color == ui::Theme(ui::ThemeName::Light).stroke(ui::Role::ShearForce).color)
            heights.push_back(0.5 * (line.points.front().y + line.points.back().y));
    std::ranges::sort(heights);
    REQUIRE(heights.size() >= 2);
    CHECK(middle_of("N(U2U3) = ").y < heights[0]);
    CHECK(middle_of("N(U2L3) = ").y > heights[1]);
}

TEST_CASE("The values of sections ask for a place before those of loads, and small ones last")
{
    const ui::Fonts fonts;
    const femoop::Model portal = view_test::example("portal");
    const std::vector<femoop::MemberId> beam{*portal.find_member("BC")};
    const auto marks = drawn_body(fonts, portal, body_of(discretise(portal), beam));
    const auto first = [&](std::string_view words) {
        const auto found = std::ranges::find_if(marks.texts,
                                                [&](const auto& text) { return text.words.starts_with(words); });
        REQUIRE(found != marks.texts.end());
        return found - marks.texts.begin();
    };
    CHECK(first("V = 50.6 kN") < first("101.2 kN"));
    CHECK(first("M = 42.68 kN·m") < first("101.2 kN"));
}
