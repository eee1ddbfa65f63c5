#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/cross/view/bay_scale.h"
#include "apps/cross/view/scene.h"
#include "apps/drawing/sketch/scene.h"

namespace cross {

/// How the structure's picture finds room for its marks.
struct LoadedView {
    ui::PlaneCamera camera;
    double arrows = 1.0; ///< height of the largest load, of the usual
};

/// How the columns of a beam's sheet stand: all below it, or those of every second joint above it, so that more of
/// them have room beside each other.
enum class BeamColumns : std::uint8_t { Below, InTurn };

/// Where one of the four pictures stands, and how it looks at the structure.
struct Panel {
    ui::Box box;
    ui::PlaneCamera camera; ///< within the box
    double stretch = 1.0;   ///< of heights: a calculation's sketch need not be to scale
    BayScale bays;          ///< of lengths, likewise
    BayScale storeys;       ///< of heights, likewise
    BeamColumns columns = BeamColumns::Below;
    bool is_zoomed = false;
    double zoom = 1.0;            ///< how much larger than the whole structure would be
    ui::Box whole;                ///< what of the picture would be seen of the whole structure, at this zoom
    double ems_high = 1.0;        ///< how many of the usual lines of type its marks need
    std::optional<ui::Box> title; ///< where it is known: labels keep clear of it, else below its line
    double arrows = 1.0;          ///< as in LoadedView

    /// Columns take no more room than they need.
    bool is_tight() const { return columns == BeamColumns::InTurn || !storeys.is_to_scale(); }
    void look_as(const LoadedView& loaded) { camera = loaded.camera, arrows = loaded.arrows; }
    ui::Point at(const Eigen::Vector3d& place) const
    {
        return box.min + camera.to_sheet({bays(place.x()), stretch * storeys(place.y())});
    }
};

struct Panels {
    Panel structure, deformed, moments, sheet;
    bool is_stacked = false; ///< below one another: a beam
    Zoom zoom{};             ///< as far as there is something to see

    const Panel& operator[](Part part) const;
    /// On a low projector a beam's sheet takes their room between the panels.
    bool has_deformed() const { return deformed.box.height() > 0.0; }
    bool has_moments() const { return moments.box.height() > 0.0; }
};

/// The left share of the width that the small pictures of a frame take: less where the sheet has many columns.
double share_of_small_pictures(const drawing::StructureShape& shape);

/// Ems left and right of the frame of a sheet, over and below it, for its columns.
struct SheetRoom {
    double beside = 6.5, above = 9.0, below = 4.0;
};
/// Those that are tried: where one lets more columns stand, or in larger type, it is taken.
std::vector<SheetRoom> rooms_tried(const ui::Theme& theme);

/// The least size of a sheet's numbers that the last row reads, that of the panels; 0 but on the projector.
double legible_type(const ui::Theme& theme);

/// Where the small pictures of a frame stand: below one another left of its sheet, or in a row above it.
enum class SmallPictures : std::uint8_t { Left, Above };

/// What the pictures' arrangement depends on but for the structure and the room.
struct Arrangement {
    Zoom zoom{};
    double small_share = 0.34, small_ems = 10.0; ///< breadth of a frame's small pictures, and at least
    SmallPictures small = SmallPictures::Left;
    BayScale bays{}; ///< of a beam's sheet
    BeamColumns columns = BeamColumns::Below;
    BayScale storeys{};                 ///< of a frame's sheet
    SheetRoom room{};                   ///< of a frame's sheet
    std::optional<LoadedView> loaded{}; ///< where the marks are known
};
/// A structure so much longer than high is drawn as a beam, each picture below the other, which zooms along its axis.
Panels panels_for(const drawing::StructureShape& shape, ui::Size sheet, const ui::Theme& theme,
                  const Arrangement& arrangement = {});
/// All of them about one place; a beam's stay at their heights.
void look_closer(Panels& panels, const drawing::StructureShape& shape, Zoom zoom);
/// The picture of the moments drawn smaller or higher, so that arrows of reactions find room; a zoomed one stays.
void make_room_for_reactions(Panels& panels, const drawing::StructureShape& shape, const ui::Theme& theme);
void make_room(Panel& sheet, const drawing::StructureShape& shape, const ui::Theme& theme, const SheetRoom& room);
/// The middle of the structure's extent.
Eigen::Vector2d middle_of(const drawing::StructureShape& shape);

/// A beam in the middle of its sheet, over the whole breadth, so that columns have room above it too.
/// \param foot  of the sheet, that they leave free [px]
void let_columns_stand_in_turn(Panel& sheet, const drawing::StructureShape& shape, const ui::Theme& theme,
                               double foot = 0.0);

/// A structure so much longer than high that its pictures stand one below the other.
bool is_beam(const drawing::StructureShape& shape);
/// One of the pictures alone on a sheet.
Panel panel_alone(Part part, const drawing::StructureShape& shape, ui::Size sheet, const ui::Theme& theme);
/// The sheet of a beam drawn so much broader than the page, and what a page that begins at `left` shows of it.
Panel stretch_of_sheet(const drawing::StructureShape& shape, ui::Size page, double whole_width, double left,
                       const ui::Theme& theme);
/// How high such a sheet is to be: a beam is flat, and the calculation has so many lines of numbers.
double height_alone(Part part, const drawing::StructureShape& shape, double width, std::size_t n_lines,
                    const ui::Theme& theme);

/// Where a panel is small, type, lines and symbols are smaller, as far as they can still be read.
ui::Theme theme_in(const Panel& panel, const Look& look);
/// Of the structure's marks, which a zoomed frame has larger.
ui::Theme theme_of_marks(const Panel& panel, const Look& look);

Drawn::View view_of(const Panel& panel);

/// The lines between the pictures.
void draw_borders(ui::Painter& painter, const Panels& panels, const ui::Theme& theme);
/// What a picture shows, at its top left. \returns where it is written
ui::Box draw_title(ui::Painter& painter, const Panel& panel, const std::string& title, const ui::Theme& theme);
/// Where it is written.
ui::Box title_box(const ui::Painter& painter, const Panel& panel, const std::string& title, const ui::Theme& theme);

/// What of a structure is shown, and the scale that its results keep.
struct StructureLook {
    drawing::ShowSet show;
    std::optional<drawing::LockedScale> locked_scale{};
    drawing::UnitsStand units_stand = drawing::UnitsStand::WithValues;
};

using Marks = std::function<void(const drawing::Scene&)>;
/// The structure as large as its marks leave room for, below a title.
ui::PlaneCamera camera_around(const Marks& marks, const Panel& panel, const Scene& scene, const StructureLook& look,
                              const ui::Fonts& fonts);

/// A beam keeps its length: it is moved up, and its loads are drawn lower, as far as its marks need that.
LoadedView beam_around(const Marks& marks, const Panel& panel, const Scene& scene, const StructureLook& look,
                       const ui::Fonts& fonts);

/// Draws marks of a structure in one panel through the drawing library's symbols. \returns what a hand can take hold of
drawing::Grips draw_structure_in(ui::Painter& painter, const Panel& panel, const Scene& scene,
                                 const StructureLook& look, const Marks& marks);

} // namespace cross
