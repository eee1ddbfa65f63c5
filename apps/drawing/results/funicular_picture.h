#pragma once

#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/funicular/chain.h"
#include "femoop/methods/funicular/funicular.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drawing {

/// What of a funicular a hand takes hold of.
enum class FunicularHandle : std::uint8_t { LeftEnd, RightEnd, Rise };
inline constexpr FunicularHandle funicular_handles[] = {FunicularHandle::LeftEnd, FunicularHandle::RightEnd,
                                                        FunicularHandle::Rise};

/// The funicular over a chain, with its force polygon beside it.
struct FunicularPicture {
    femoop::funicular::Chain chain;
    femoop::funicular::Funicular funicular;
    std::optional<double> reading{};           ///< x of the place that is read
    std::optional<FunicularHandle> in_reach{}; ///< of the hand
    std::vector<std::string> sentences{};      ///< for the foot of the sheet

    Eigen::Vector3d place_of(FunicularHandle handle) const;
};

/// What has to be in sight.
std::vector<Eigen::Vector3d> places_of(const FunicularPicture& picture);

/// The line over its closing line, which is dashed; thin the sides of the polygon where loads are distributed; the rise
/// that gives H, and at the place that is read the ordinate and the moment H e off the axis.
void draw_funicular(const Scene& scene, const FunicularPicture& picture);
PanelHead funicular_head(const Scene& scene, const FunicularPicture& picture);

/// Loads and reactions on the load line, the pole with its rays, dashed that of the closing line.
void draw_force_polygon(const Scene& scene, const FunicularPicture& picture, const ui::Box& panel);
PanelHead force_polygon_head(const Scene& scene, const FunicularPicture& picture, const ui::Box& panel);

} // namespace drawing
