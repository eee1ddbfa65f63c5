#pragma once

#include "apps/drawing/results/position_curve.h"
#include "apps/drawing/show.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/member_motion.h"
#include "femoop/methods/influence/train/standing_train.h"

#include <optional>
#include <string>
#include <vector>

namespace drawing {

/// An influence line to be drawn on the path of its structure.
struct InfluencePicture {
    femoop::influence::PathLayout path;
    femoop::NodeVector load; ///< the unit load, global axes
    femoop::influence::InfluenceLine line;
    /// How the structure moves whose displacement the line is, by member; none where it is not drawn.
    std::vector<femoop::influence::MemberMotion> motion{};
    /// Forces that stand on the path: their ordinates are drawn, and written in place of the line's own values.
    std::vector<femoop::influence::StandingForce> forces{};
    std::optional<PositionCurve> curve{}; ///< of a train that is moved: drawn over the foot of the sheet
    /// The part of the line that is drawn, where it is traced by a load and its structure does not move yet.
    std::optional<femoop::influence::Stretch> traced{};
    std::vector<std::string> sentences{}; ///< for the foot of the sheet, the first one in bold
};

/// A line at a height that suits the panel, and keeps the motion behind it on the sheet.
struct InfluenceScale {
    double largest = 0.0;         ///< |ordinate|
    double pixels_per_unit = 0.0; ///< of the ordinates
    bool shows_motion = true;     ///< false where the structure moves so much farther that the line would be flat
};
InfluenceScale influence_scale(const Scene& scene, const InfluencePicture& picture, ui::Size panel);

/// The line, filled, on the members of its path; behind it the structure as it moves, to the same scale: where it moves
/// along the load alone the one lies on the other. A mark stands at the section.
///
/// Sides  positive ordinates to where the unit load points, along it: for a load that points down, below
void draw_influence(const Scene& scene, const InfluencePicture& picture, const InfluenceScale& scale);

/// The direction in which positive ordinates are drawn, a unit vector: that of the unit load, also over an inclined
/// member, so that the line goes on over the joints of an arch. Square to a member that the load points along within 15
/// degrees, to the load's side; under a couple below a beam.
/// \param is_flat  the structure is seen in its plane
Eigen::Vector3d ordinate_side(const femoop::NodeVector& load, const femoop::MemberGeometry& member, bool is_flat);

/// The same line kept from sight, for a class to sketch it first: its section is marked, nothing else is drawn or said.
InfluencePicture concealed(InfluencePicture picture);
bool is_concealed(const InfluencePicture& picture);

/// What its ordinates are counted in: of a moment under a force, metres.
struct OrdinateUnit {
    std::string name; ///< empty for a plain number
    double factor = 1.0;
};
OrdinateUnit ordinate_unit(const ui::DisplayUnits& units, const InfluencePicture& picture);

std::string ordinate_text(const ui::DisplayUnits& units, const OrdinateUnit& unit, double value); ///< 9.216 ft
/// "areas +612.4, −148.3 ft²": between the line and the path, of either sign.
std::string areas_text(const ui::DisplayUnits& units, const InfluencePicture& picture, const ui::Catalogue& tr);

/// M(BC, 38.57 ft), fy(A)
std::string effect_text(const femoop::Model& model, const ui::DisplayUnits& units, const femoop::MovingEffect& effect);

/// What moves, and by how much, so that the path moves by the line: a sentence for the foot of the sheet. Where the
/// support makes it zero, that it does.
std::string principle(const femoop::Model& model, const femoop::MovingEffect& effect, const ui::Catalogue& tr);
/// Why a support makes an effect zero wherever the load stands: it does not hold this reaction, or it holds this
/// displacement. Nothing where none does.
std::optional<std::string> zero_by_support(const femoop::Model& model, const femoop::MovingEffect& effect,
                                           const ui::Catalogue& tr);

ui::Role role_of(const femoop::MovingEffect& effect);
/// The diagram or result that the effect is read from in a case.
Show show_of(const femoop::MovingEffect& effect, femoop::AnalysisKind kind);
ui::Measure measure_of(const femoop::MovingEffect& effect);

} // namespace drawing
