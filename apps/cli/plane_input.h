#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/plane/discretize/meshed_drawing.h"
#include "apps/plane/outline/outline.h"
#include "apps/plane/view/plate_picture.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/io/plane/plane_verify.h"
#include "ui/text/catalogue.h"

namespace cli {

/// The drawing of a plane model, where it is drawn and nothing is wrong with its file; what is wrong with the drawing
/// joins the reading's faults. The reading must outlive it.
std::unique_ptr<const discretize::Drawing> drawing_of(femoop::plane::PlaneReading& reading);

/// The curves of a file of another program. \throws UsageError naming the file and the line \pre is_outline_file(file)
outline::Outline load_outline(const std::string& file, const ui::Catalogue& tr);

/// Says at which corners stresses have no bound, which no mesh finds; nothing where there are none.
void tell_singular_corners(const discretize::Drawing& drawing, const std::string& file,
                           const ::plane::PlateOptions& options, const Console& console);

/// A plane model that was read, with its drawing and the mesh of that where it is drawn.
class PlaneInput {
public:
    enum class Depth : std::uint8_t { Drawing, Mesh }; ///< how far it is made

    /// What is wrong with the drawing or its mesh joins the reading's faults. The reading must outlive this.
    explicit PlaneInput(femoop::plane::PlaneReading& reading, Depth depth = Depth::Mesh);

    const discretize::Drawing* drawing() const { return drawing_.get(); }
    const discretize::MeshedDrawing* mesh() const { return mesh_ ? &*mesh_ : nullptr; }
    /// The model with elements. \pre the reading is sound
    const femoop::plane::PlaneModel& model() const { return mesh_ ? mesh_->model() : reading_.model; }
    std::optional<femoop::plane::DrawnChecks> checks() const;
    /// The points of a drawing that are in material; nothing where the mesh is the file's.
    std::optional<std::vector<femoop::plane::ShownPoint>> points_in_material() const;
    std::vector<std::string> methods() const; ///< by which each region was meshed

private:
    const femoop::plane::PlaneReading& reading_;
    std::unique_ptr<const discretize::Drawing> drawing_;
    std::optional<discretize::MeshedDrawing> mesh_;
};

} // namespace cli
