#pragma once

#include "ui/canvas/plane_camera.h"

#include <span>

namespace ui {

/// A place in space, in the model's unit of length; right-handed, z up.
struct World3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    friend bool operator==(const World3&, const World3&) = default;
};

/// Directions from which drawings are commonly made.
enum class StandardView {
    Isometric, ///< x to the right and down, y to the right and up, all three axes equally short
    Front,     ///< along +y: x right, z up
    Side,      ///< along -x: y right, z up
    Top        ///< along -z: x right, y up
};

/// Looks at a model in space from any side, in parallel projection: parallel members stay parallel on the sheet.
///
///              z ^   eye      azimuth    of the eye about z, from +x towards +y [rad]
///                |  /         elevation  of the eye above the xy plane [rad], from -90 to 90 degrees
///                | / elevation
///                +-------- y
///               / azimuth
///              x
class OrbitCamera {
public:
    OrbitCamera() { look(StandardView::Isometric); }

    double azimuth() const { return azimuth_; }
    double elevation() const { return elevation_; }
    double scale() const { return plane_.scale(); }

    /// These turn about the world's origin; `fit` afterwards.
    void look(StandardView view);
    void look(double azimuth, double elevation);
    /// Turns by a drag of the mouse in logical pixels, half a turn per 500, about `pivot`, which stays where it is on
    /// the sheet. The eye stops at the poles.
    void orbit(Point drag, World3 pivot);
    void pan(Point shift) { plane_.pan(shift); }
    void zoom(Point cursor, double factor) { plane_.zoom(cursor, factor); }
    void fit(std::span<const World3> points, Size sheet, const Margins& margins = {});

    Point to_sheet(World3 p) const { return plane_.to_sheet(on_plane(p)); }
    /// Distance towards the eye, for drawing from back to front; larger is nearer.
    double nearness(World3 p) const;
    /// The place shown at a point of the sheet that has the given nearness.
    World3 to_world(Point p, double nearness) const;
    /// A direction of the sheet (unit vectors) in space.
    World3 right() const;
    World3 up() const;
    World3 toward_eye() const;

    friend bool operator==(const OrbitCamera&, const OrbitCamera&) = default;

private:
    World2 on_plane(World3 p) const;

    double azimuth_ = 0.0;
    double elevation_ = 0.0;
    PlaneCamera plane_;
};

} // namespace ui
