#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/paint/surface.h"
#include "ui/paint/text_measure.h"

/// Where each string stands.
class Strings : public ui::Surface {
public:
    explicit Strings(const ui::Fonts& fonts) : fonts_(fonts) {}

    struct String {
        std::string words;
        ui::Box box;
    };

    void clip(const ui::Box& /*box*/) override {}
    void stroke(const ui::Path& /*path*/, const ui::Stroke& /*stroke*/) override {}
    void fill(std::span<const ui::Point> /*polygon*/, ui::Color /*color*/) override {}
    void stroke_arc(const ui::Arc& /*arc*/, const ui::Stroke& /*stroke*/) override {}
    void fill_disc(ui::Point /*center*/, double /*radius*/, ui::Color /*color*/) override {}
    void text(ui::Point at, std::string_view utf8, const ui::TextStyle& style) override
    {
        all.push_back({std::string(utf8), ui::text_box(fonts_, at, utf8, style)});
    }

    std::vector<String> all;

private:
    const ui::Fonts& fonts_;
};
