#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/picture_file.h"
#include "apps/cli/reference.h"
#include "apps/drawing/dimension.h"
#include "apps/drawing/draw_options.h"
#include "apps/frame/document/companion/named_view.h"
#include "femoop/model/model.h"

namespace cli {

/// A picture of a structure to be drawn.
struct PictureOrder {
    PictureFile file;
    std::optional<std::size_t> mechanism; ///< which way of moving is drawn when the structure cannot be solved
    drawing::DrawOptions view;
    std::optional<AskedReference> reference;            ///< whose diagrams stand behind, faint
    std::span<const drawing::DimensionLine> dimensions; ///< that stand beside the model; outlive the drawing
    std::optional<frame::Region> region;                ///< of a plane model that is looked at; the whole when absent
};

/// Solves the model and draws it with its results. A structure that can move is drawn moving: the motions are told on
/// stderr and the status is CannotSolve. \throws UsageError if the file cannot be written
ExitStatus draw_picture(const femoop::Model& model, const std::string& file, const PictureOrder& order,
                        const Console& console);

/// What a picture of the model stands on.
Backdrop backdrop_of(const PictureOrder& order, const femoop::Model& model);

/// How pictures are drawn when no option says otherwise: in the language of `tr`, with its decimal mark.
drawing::DrawOptions draw_options(const ui::Catalogue& tr);

} // namespace cli
