// The label placement at work: a frame on which every member has a diagram, and every diagram three values.
#include "tests/golden/scene.h"
#include "ui/paint/label_placement.h"
#include "ui/paint/theme.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace {

using ui::Point;
using ui::Role;

std::string one_decimal(double value)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << value;
    return text.str();
}

class CrowdedFrame {
public:
    CrowdedFrame(ui::Painter& painter, const ui::Theme& theme)
        : painter_(painter), theme_(theme), placer_({.room = painter.sheet()})
    {
        for (int level = 0; level < n_storeys; ++level)
            for (int bay = 0; bay <= n_bays; ++bay) add_member(node(bay, level), node(bay, level + 1));
        for (int level = 1; level <= n_storeys; ++level)
            for (int bay = 0; bay < n_bays; ++bay) add_member(node(bay, level), node(bay + 1, level));
    }

    std::size_t draw_values()
    {
        const auto placement = placer_.place(labels_);
        const ui::LayerScope scope(painter_, ui::Layer::Labels);
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            if (!placement.labels[i]) continue;
            if (const auto& leader = placement.labels[i]->leader)
                painter_.line(leader->from, leader->to, theme_.stroke(Role::Leader));
            ui::draw_label(painter_, *placement.labels[i], texts_[i], theme_.text(Role::BendingMoment));
        }
        return placement.n_left_out;
    }

private:
    static constexpr int n_bays = 7;
    static constexpr int n_storeys = 4;

    static Point node(int bay, int level) { return {80.0 + 160.0 * bay, 740.0 - 160.0 * level}; }

    /// Moments at the ends and the sag between them [px], different for every member.
    std::array<double, 3> next_moments()
    {
        std::array<double, 3> moments{};
        for (double& moment : moments) moment = 45.0 * std::sin(12.9898 * ++n_moments_);
        return moments;
    }

    void add_member(Point a, Point b)
    {
        const std::array<double, 3> moments = next_moments();
        const double start = moments[0], end = moments[1], sag = moments[2];
        const Point side = ui::left_normal(ui::direction(b - a));
        const auto height = [&](double s) { return start * (1.0 - s) + end * s + 2.0 * sag * s * (1.0 - s); };
        const auto curve = [&](double s) { return a + s * (b - a) + height(s) * side; };
        std::vector<Point> outline{a};
        for (int k = 0; k <= 20; ++k) outline.push_back(curve(k / 20.0));
        outline.push_back(b);
        draw(outline, a, b);
        for (const double s : {0.0, 0.5, 1.0}) add_value(curve(s), height(s), side);
    }

    void draw(const std::vector<Point>& outline, Point a, Point b)
    {
        painter_.line(a, b, theme_.stroke(Role::Member));
        const ui::LayerScope scope(painter_, ui::Layer::Areas);
        painter_.polygon(outline, theme_.fill(Role::BendingMoment));
        painter_.polyline(outline, theme_.stroke(Role::BendingMoment));
        placer_.obstacles().add_segment(a, b, 3.0);
        placer_.obstacles().add_polyline(outline, 2.0);
        placer_.obstacles().add_polygon(outline, ui::Firmness::Soft);
    }

    /// Wants to stand beyond the curve.
    void add_value(Point at, double value, Point side)
    {
        texts_.push_back(one_decimal(value));
        const ui::Size size = ui::label_size(painter_.fonts(), texts_.back(), theme_.text(Role::BendingMoment));
        const double half = 0.5 * (std::abs(side.x) * size.width + std::abs(side.y) * size.height);
        const Point wish = at + std::copysign(half + 4.0, value) * side;
        labels_.push_back({.target = at, .size = size, .wishes = {wish}, .priority = std::abs(value)});
    }

    ui::Painter& painter_;
    const ui::Theme& theme_;
    ui::LabelPlacer placer_;
    std::vector<ui::Label> labels_;
    std::vector<std::string> texts_;
    int n_moments_ = 0;
};

} // namespace

TEST_SUITE_BEGIN("pictures");

TEST_CASE("On a crowded frame of 60 members all 180 values find a place")
{
    const ui::Theme theme(ui::ThemeName::Light);
    std::size_t n_left_out = 180;
    golden::check_scene("labels_crowded", {.size = {1280.0, 800.0}}, [&](ui::Painter& painter) {
        CrowdedFrame frame(painter, theme);
        n_left_out = frame.draw_values();
    });
    CHECK(n_left_out == 0);
}

TEST_SUITE_END();
