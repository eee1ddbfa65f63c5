#pragma once

#include "ui/paint/color.h"
#include "ui/paint/style.h"

#include <array>
#include <optional>
#include <string_view>

namespace ui {

enum class ThemeName { Light, Dark, Print, Projector };

/// What a mark on the sheet means. Views ask the theme how a role looks and never choose a colour of their own.
enum class Role {
    Grid,
    GridAxis,
    Member,
    Bar,       ///< member that carries axial force only
    RigidPart, ///< rigid member or end offset
    Node,
    Hinge,
    Support,
    Spring,
    Load,
    LoadMoment,
    Temperature,
    Reaction,
    AxialForce,
    ShearForce,
    BendingMoment,
    Guess, ///< bending moment as a hand sketched it
    Torsion,
    Deformed,
    Undeformed, ///< the structure behind its deformed shape
    Mechanism,
    Dimension,
    LocalAxes,
    Label,
    FaintLabel,
    Leader,
    Edge,       ///< of a solid
    HiddenEdge, ///< behind faces
    Created,    ///< by the step that is shown
    Changed,    ///< by it, but there before and after
    Killed,     ///< by it
    Offered,    ///< may be picked now
    Selection,
    Hover,
    Warning,
    Error
};
inline constexpr std::size_t n_roles = static_cast<std::size_t>(Role::Error) + 1;
inline constexpr std::size_t n_series = 7;

/// How a role looks: its line, the fill of its areas, and the colour of its words and numbers.
struct RoleStyle {
    Stroke stroke;
    Color fill;
    Color text;
};

/// Sizes of type, in logical pixels.
struct TypeSizes {
    double small = 11.0;
    double normal = 13.0;
    double large = 17.0;
};

/// A complete set of looks.
///
/// Hues are those of Okabe and Ito, which people with any common colour blindness tell apart; roles that may stand
/// beside one another differ in dash pattern or width too, so that a black and white copy still reads.
/// Text has a contrast of at least 4.5 on the background (WCAG 2.1 level AA).
/// Source: M. Okabe, K. Ito, "Color Universal Design", 2008.
class Theme {
public:
    explicit Theme(ThemeName name);

    ThemeName name() const { return name_; }
    bool is_dark() const { return name_ == ThemeName::Dark; }
    Color background() const { return background_; }
    const TypeSizes& type() const { return type_; }
    /// Factor for arrow heads, support symbols and gaps that views draw: 1 but on the projector and where scaled.
    double symbol_scale() const { return symbol_scale_; }
    const RoleStyle& operator[](Role role) const { return roles_[static_cast<std::size_t>(role)]; }
    Stroke stroke(Role role) const { return (*this)[role].stroke; }
    Color fill(Role role) const { return (*this)[role].fill; }
    /// The i-th of things of one kind that are told apart by colour, or in print by shade and dashes; the looks come in
    /// turn, `n_series` of them.
    const RoleStyle& series(std::size_t i) const { return series_[i % n_series]; }
    /// The same with all sizes of type, lines and symbols multiplied.
    Theme scaled(double factor) const;
    /// Normal size, in the role's text colour.
    TextStyle text(Role role, Anchor anchor = Anchor::Center) const;

private:
    struct FromPalette {};
    Theme(ThemeName name, FromPalette);
    /// Of that name, worked out once: finding colours that stand out takes as long as many a picture.
    static const Theme& worked_out(ThemeName name);

    ThemeName name_;
    Color background_;
    TypeSizes type_;
    double symbol_scale_ = 1.0;
    std::array<RoleStyle, n_roles> roles_;
    std::array<RoleStyle, n_series> series_;
};

std::string_view text(ThemeName name); ///< "light", "dark", "print", "projector"
/// Nothing when there is no theme of that name.
std::optional<ThemeName> theme_named(std::string_view name);

} // namespace ui
