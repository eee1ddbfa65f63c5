#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

namespace cross {

enum class Signs : std::uint8_t {
    JointRotation, ///< moments on the member ends, counter-clockwise positive
    TensionSide    ///< section moments, positive where they stretch the lower side
};

/// What part of the structure the pictures show, all of them the same.
struct Zoom {
    double factor = 1.0;                     ///< 1: the whole structure fits each picture
    std::optional<Eigen::Vector2d> middle{}; ///< the place where the structure's own middle would be; absent: that
    bool is_of_sheet = false;                ///< of the calculation sheet alone: the other pictures show the whole

    static constexpr double least = 0.2, most = 200.0;
};
/// So many times as large, a place staying where it is; as far as it goes.
Zoom zoomed(const Zoom& zoom, Eigen::Vector2d own_middle, Eigen::Vector2d at, double factor);
/// The structure moved along with a hand.
Zoom moved(const Zoom& zoom, Eigen::Vector2d own_middle, Eigen::Vector2d by);

/// How a document is drawn.
struct Look {
    Signs signs = Signs::JointRotation;
    bool fractions = false; ///< numbers that are simple fractions are written as such
    bool shears = false;    ///< and reactions, in place of the moment diagram
    ui::ThemeName theme = ui::ThemeName::Light;
    Zoom zoom{};
    double size = 1.0; ///< > 0, of type, lines and symbols; 1 is the theme's own
    ui::Catalogue tr;

    ui::Theme full_theme() const { return ui::Theme(theme).scaled(size); }
};

} // namespace cross
