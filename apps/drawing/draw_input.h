#pragma once

#include "apps/drawing/dimension.h"
#include "apps/drawing/structure/node_numbers.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/methods/counting/counting.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drawing {

class DiagramOverlay;
struct EnvelopePicture;
struct FreeBodyPicture;
struct FunicularPicture;
struct InfluencePicture;
struct TrussPicture;
struct WorkPicture;

/// One of the motions of a structure that cannot be solved.
struct MotionChoice {
    std::span<const femoop::Mechanism> all; ///< outlives whatever draws it
    std::size_t shown = 0;                  ///< \pre < all.size()
    std::string sentence;                   ///< how the structure moves, in the words of the app
};

/// A former model with its results, which others are compared with.
struct ReferenceResults {
    femoop::Model model;
    femoop::Results results;
    std::optional<femoop::CaseId> load_case{}; ///< that every case is compared with; absent: each with its namesake
    std::string name{};                        ///< of what is compared with: a load case, a file

    /// The case that one of the present model is compared with; nothing where there is none.
    std::optional<femoop::CaseId> counterpart(const femoop::Model& present, femoop::CaseId shown) const;
};

/// What a picture is of. All of it outlives whatever draws it.
struct DrawInput {
    const femoop::Model& model;
    const femoop::Results* results = nullptr;    ///< of the model; null where there are none
    std::optional<MotionChoice> motion{};        ///< of a model without results
    const ReferenceResults* reference = nullptr; ///< its diagrams are drawn behind, faint; none when null
    std::span<const DimensionLine> dimensions{}; ///< drawn by hand
    /// What an app draws over the moments, or in their place. While moments are not shown a fitted picture keeps room
    /// for it. None when null.
    const DiagramOverlay* overlay = nullptr;
    std::span<const NodeNumbers> numbers{};            ///< written at nodes where Show::NodeNumbers is
    const InfluencePicture* influence = nullptr;       ///< drawn where Show::Influence is; none when null
    std::vector<const InfluencePicture*> kept_lines{}; ///< each in a panel of its own above that one
    std::vector<std::string> reasons{};                ///< sentences at the foot: why there are no results
    /// Drawn in place of the results, with the structure behind it; none when null. \pre of the case that is shown
    const FreeBodyPicture* free_body = nullptr;
    const femoop::counting::Counting* counting =
        nullptr; ///< of the model, drawn where Show::Counting is; none when null
    /// Of trains, drawn in place of that of the cases where the options ask for an envelope; none when null.
    const EnvelopePicture* envelope = nullptr;
    const TrussPicture* truss = nullptr; ///< drawn where Show::Truss is, in place of the results; none when null
    /// Drawn where Show::ForcePolygon is, in place of the results; none when null. \pre of the case that is shown
    const FunicularPicture* funicular = nullptr;
    /// Drawn where Show::UnitLoad is: the structure under its unit load beside the results, and the table of their work;
    /// none when null. \pre of the case that is shown
    const WorkPicture* work = nullptr;
};

} // namespace drawing
