#pragma once

#include "femoop/model/model.h"
#include "ui/paint/painter.h"
#include "ui/paint/surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace view_test {

/// A model of examples/ or tests/apps/drawing/models/.
femoop::Model example(std::string_view name);
femoop::Model model(std::string_view name);

/// A beam on two supports under a uniform load q [kN/m] down.
femoop::Model simple_beam(double length, double q);

/// What a picture is made of, for tests that look at it.
class Marks final : public ui::Surface {
public:
    explicit Marks(const ui::Fonts& fonts) : fonts_(fonts) {}

    struct Text {
        std::string words;
        ui::Box box;
    };
    struct Line {
        std::vector<ui::Point> points;
        ui::Stroke stroke;
    };
    struct Area {
        std::vector<ui::Point> points;
        ui::Color fill;
    };

    struct Disc {
        ui::Point center;
        double radius = 0.0;
        ui::Color fill;
    };

    void clip(const ui::Box&) override {}
    void stroke(const ui::Path& path, const ui::Stroke& stroke) override;
    void fill(std::span<const ui::Point> polygon, ui::Color color) override;
    void stroke_arc(const ui::Arc&, const ui::Stroke&) override {}
    void fill_disc(ui::Point center, double radius, ui::Color color) override
    {
        discs.push_back({center, radius, color});
    }
    void text(ui::Point at, std::string_view utf8, const ui::TextStyle& style) override;

    bool has_text(std::string_view words) const;

    std::vector<Text> texts;
    std::vector<Line> lines;
    std::vector<Area> areas;
    std::vector<Disc> discs;

private:
    const ui::Fonts& fonts_;
};

} // namespace view_test
