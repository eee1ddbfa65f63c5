#include "ui/paint/theme.h"

#include <algorithm>
#include <utility>

namespace ui {

namespace {

// Okabe and Ito's hues.
constexpr Color orange = rgb(0xE69F00), sky_blue = rgb(0x56B4E9), bluish_green = rgb(0x009E73), yellow = rgb(0xF0E442),
                blue = rgb(0x0072B2), vermillion = rgb(0xD55E00), reddish_purple = rgb(0xCC79A7);

/// What the themes differ in; the roles follow from it.
struct Palette {
    Color background;
    Color ink;
    Color faint; ///< ink of what stands back: grid labels, the undeformed structure
    Color grid;
    double line_contrast; ///< least contrast of a coloured line
    double text_contrast; ///< least contrast of words
    double line_scale;
    double fill_opacity;
    bool is_gray;
};

Palette palette(ThemeName name)
{
    switch (name) {
    case ThemeName::Dark:
        return {.background = rgb(0x1B1F24),
                .ink = rgb(0xEDEFF2),
                .faint = rgb(0x99A2AD),
                .grid = rgb(0x2B3138),
                .line_contrast = 4.5,
                .text_contrast = 6.5,
                .line_scale = 1.0,
                .fill_opacity = 0.25,
                .is_gray = false};
    case ThemeName::Print:
        return {.background = rgb(0xFFFFFF),
                .ink = rgb(0x000000),
                .faint = rgb(0x5A5A5A),
                .grid = rgb(0xDDDDDD),
                .line_contrast = 7.0,
                .text_contrast = 7.0,
                .line_scale = 0.8,
                .fill_opacity = 0.13,
                .is_gray = true};
    case ThemeName::Projector:
        return {.background = rgb(0xFFFFFF),
                .ink = rgb(0x000000),
                .faint = rgb(0x4A4A4A),
                .grid = rgb(0xD8D8D8),
                .line_contrast = 4.5,
                .text_contrast = 7.0,
                .line_scale = 1.8,
                .fill_opacity = 0.22,
                .is_gray = false};
    case ThemeName::Light: break;
    }
    return {.background = rgb(0xFFFFFF),
            .ink = rgb(0x1E2329),
            .faint = rgb(0x69727D),
            .grid = rgb(0xE7EAEE),
            .line_contrast = 3.0,
            .text_contrast = 4.5,
            .line_scale = 1.0,
            .fill_opacity = 0.16,
            .is_gray = false};
}

/// The hue, moved towards the ink until it stands out enough from the background.
Color standing_out(Color hue, const Palette& p, double contrast)
{
    constexpr int steps = 50;
    for (int i = 0; i <= steps; ++i) {
        const Color color = mixed(hue, p.ink, static_cast<double>(i) / steps);
        if (contrast_ratio(color, p.background) >= contrast) return color;
    }
    return p.ink;
}

struct LineLook {
    double width;
    DashPattern dash{};
    Cap cap = Cap::Butt;
    Join join = Join::Round;
};

RoleStyle role_style(const Palette& p, Color hue, const LineLook& look)
{
    const Color base = p.is_gray ? p.ink : hue;
    const Color line = standing_out(base, p, p.line_contrast);
    return {.stroke = {.color = line,
                       .width = look.width * p.line_scale,
                       .dash = look.dash.scaled(p.line_scale),
                       .cap = look.cap,
                       .join = look.join},
            .fill = with_opacity(line, p.fill_opacity),
            .text = standing_out(base, p, p.text_contrast)};
}

/// A role that keeps its very colour: the ink or one of its shades.
RoleStyle plain_style(const Palette& p, Color color, const LineLook& look)
{
    RoleStyle style = role_style(p, p.ink, look);
    style.stroke.color = color;
    style.fill = with_opacity(color, p.fill_opacity);
    style.text = color;
    return style;
}

using Roles = std::array<RoleStyle, n_roles>;

RoleStyle& at(Roles& roles, Role role) { return roles[static_cast<std::size_t>(role)]; }

void add_structure(Roles& roles, const Palette& p)
{
    at(roles, Role::Grid) = plain_style(p, p.grid, {.width = 1.0 / p.line_scale});
    at(roles, Role::GridAxis) = plain_style(p, mixed(p.grid, p.faint, 0.4), {.width = 1.0 / p.line_scale});
    at(roles, Role::Grid).text = at(roles, Role::GridAxis).text = p.faint;
    at(roles, Role::Member) = plain_style(p, p.ink, {.width = 3.0, .cap = Cap::Round});
    at(roles, Role::Bar) = plain_style(p, p.ink, {.width = 2.0, .cap = Cap::Round});
    at(roles, Role::RigidPart) = plain_style(p, p.ink, {.width = 6.0});
    at(roles, Role::Node) = plain_style(p, p.ink, {.width = 1.5});
    at(roles, Role::Node).fill = p.ink;
    at(roles, Role::Hinge) = plain_style(p, p.ink, {.width = 1.6});
    at(roles, Role::Hinge).fill = p.background;
    const Color ground = mixed(p.background, p.ink, 0.72);
    at(roles, Role::Support) = plain_style(p, ground, {.width = 1.5});
    at(roles, Role::Support).fill = mixed(p.background, p.ink, 0.12);
    at(roles, Role::Spring) = plain_style(p, ground, {.width = 1.5, .join = Join::Miter});
    at(roles, Role::Undeformed) = plain_style(p, mixed(p.background, p.faint, 0.75), {.width = 1.3, .dash = {5, 4}});
    at(roles, Role::LocalAxes) = role_style(p, reddish_purple, {.width = 1.3});
    at(roles, Role::Dimension) = plain_style(p, p.faint, {.width = 1.0});
    at(roles, Role::Label) = plain_style(p, p.ink, {.width = 1.0});
    at(roles, Role::FaintLabel) = plain_style(p, p.faint, {.width = 1.0});
    at(roles, Role::Leader) = plain_style(p, p.faint, {.width = 0.8});
}

void add_actions(Roles& roles, const Palette& p)
{
    at(roles, Role::Load) = role_style(p, vermillion, {.width = 1.6, .join = Join::Miter});
    at(roles, Role::LoadMoment) = role_style(p, vermillion, {.width = 1.8, .join = Join::Miter});
    at(roles, Role::Temperature) = role_style(p, orange, {.width = 1.5, .dash = {2, 3}});
    at(roles, Role::Reaction) = role_style(p, bluish_green, {.width = 2.4, .join = Join::Miter});
}

void add_results(Roles& roles, const Palette& p)
{
    at(roles, Role::AxialForce) = role_style(p, sky_blue, {.width = 1.6, .dash = {10, 3, 2, 3}});
    at(roles, Role::ShearForce) = role_style(p, orange, {.width = 1.6, .dash = {7, 3}});
    at(roles, Role::BendingMoment) = role_style(p, blue, {.width = 1.9});
    at(roles, Role::Guess) = role_style(p, reddish_purple, {.width = 2.2, .dash = {7, 4}});
    at(roles, Role::Torsion) = role_style(p, yellow, {.width = 1.9, .dash = {2, 3}});
    at(roles, Role::Deformed) = role_style(p, reddish_purple, {.width = 2.6, .cap = Cap::Round});
    at(roles, Role::Mechanism) = role_style(p, vermillion, {.width = 3.0, .dash = {12, 4, 3, 4}});
    at(roles, Role::Selection) = role_style(p, blue, {.width = 5.0, .cap = Cap::Round});
    at(roles, Role::Hover) = role_style(p, sky_blue, {.width = 5.0, .dash = {4, 3}});
    at(roles, Role::Warning) = role_style(p, orange, {.width = 2.0, .dash = {6, 4}});
    at(roles, Role::Error) = role_style(p, vermillion, {.width = 2.5});
}

void add_steps(Roles& roles, const Palette& p)
{
    at(roles, Role::Edge) = plain_style(p, p.ink, {.width = 1.8, .cap = Cap::Round});
    at(roles, Role::HiddenEdge) = plain_style(p, mixed(p.background, p.faint, 0.75), {.width = 1.0});
    at(roles, Role::HiddenEdge).text = p.faint;
    at(roles, Role::Created) = role_style(p, bluish_green, {.width = 3.2, .cap = Cap::Round});
    at(roles, Role::Changed) = role_style(p, orange, {.width = 2.4, .cap = Cap::Round});
    at(roles, Role::Killed) = role_style(p, vermillion, {.width = 2.8, .dash = {6, 4}});
    at(roles, Role::Offered) = role_style(p, yellow, {.width = 7.0, .cap = Cap::Round});
    if (!p.is_gray) at(roles, Role::Offered).stroke.color = yellow; // a broad mark below something else
}

/// Where there is no colour, shades and dashes stand for hues.
std::array<RoleStyle, n_series> series(const Palette& p)
{
    constexpr Color hues[n_series] = {blue, orange, bluish_green, reddish_purple, sky_blue, vermillion, yellow};
    const DashPattern dashes[n_series] = {{}, {6, 3}, {2, 2}, {9, 3, 2, 3}, {4, 2}, {12, 3}, {2, 4}};
    std::array<RoleStyle, n_series> styles;
    for (std::size_t i = 0; i < n_series; ++i) {
        styles[i] = role_style(p, hues[i], {.width = 1.5, .dash = p.is_gray ? dashes[i] : DashPattern{}});
        if (p.is_gray) styles[i].fill = with_opacity(p.ink, p.fill_opacity * (0.4 + 0.2 * static_cast<double>(i)));
    }
    return styles;
}

constexpr std::pair<ThemeName, std::string_view> theme_names[] = {{ThemeName::Light, "light"},
                                                                  {ThemeName::Dark, "dark"},
                                                                  {ThemeName::Print, "print"},
                                                                  {ThemeName::Projector, "projector"}};

} // namespace

Theme::Theme(ThemeName name) : Theme(worked_out(name)) {}

const Theme& Theme::worked_out(ThemeName name)
{
    using enum ThemeName;
    static const std::array themes{Theme(Light, FromPalette()), Theme(Dark, FromPalette()), Theme(Print, FromPalette()),
                                   Theme(Projector, FromPalette())};
    return *std::ranges::find(themes, name, &Theme::name);
}

Theme::Theme(ThemeName name, FromPalette) : name_(name)
{
    const Palette p = palette(name);
    background_ = p.background;
    add_structure(roles_, p);
    add_actions(roles_, p);
    add_results(roles_, p);
    add_steps(roles_, p);
    series_ = ui::series(p);
    if (name == ThemeName::Projector) {
        type_ = {.small = 17.0, .normal = 20.0, .large = 26.0};
        symbol_scale_ = 1.5;
    }
}

Theme Theme::scaled(double factor) const
{
    Theme theme = *this;
    theme.type_ = {.small = factor * type_.small, .normal = factor * type_.normal, .large = factor * type_.large};
    theme.symbol_scale_ *= factor;
    const auto scale = [&](RoleStyle& style) {
        style.stroke.width *= factor;
        style.stroke.dash = style.stroke.dash.scaled(factor);
    };
    std::for_each(theme.roles_.begin(), theme.roles_.end(), scale);
    std::for_each(theme.series_.begin(), theme.series_.end(), scale);
    return theme;
}

TextStyle Theme::text(Role role, Anchor anchor) const
{
    return {.color = (*this)[role].text, .size = type_.normal, .anchor = anchor};
}

std::string_view text(ThemeName name)
{
    for (const auto& [known, word] : theme_names)
        if (known == name) return word;
    return "light";
}

std::optional<ThemeName> theme_named(std::string_view name)
{
    for (const auto& [known, word] : theme_names)
        if (word == name) return known;
    return std::nullopt;
}

} // namespace ui
