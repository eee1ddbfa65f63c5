#pragma once

#include "ui/canvas/orbit_camera.h"
#include "ui/canvas/plane_camera.h"

#include <Eigen/Core>
#include <optional>
#include <variant>

namespace drawing {

/// How the structure is looked at: plane models with a PlaneCamera, grillages and models in space with an OrbitCamera.
using Camera = std::variant<ui::PlaneCamera, ui::OrbitCamera>;

/// A flat frame that symbols are drawn in, measured in logical pixels along the model's own directions. On the sheet
/// it is an affine frame: a circle in it is a circle where the eye looks along its normal, else an ellipse.
struct SymbolFrame {
    ui::Point origin;
    ui::Point x{1.0, 0.0};
    ui::Point y{0.0, -1.0};

    ui::Point operator()(double along, double up) const { return origin + along * x + up * y; }
    SymbolFrame moved(double along, double up) const { return {(*this)(along, up), x, y}; }
    SymbolFrame turned(double angle) const; ///< [rad], from x towards y
};

/// Takes places of the model to the sheet: a camera, and the shift of the panel that is drawn. Parallel projection, so
/// that directions have one image everywhere.
class Projection {
public:
    explicit Projection(Camera camera, ui::Point shift = {}) : camera_(std::move(camera)), shift_(shift) {}

    ui::Point operator()(const Eigen::Vector3d& place) const;
    /// Image of a direction of length 1, in logical pixels per pixel: shorter than 1 where it is seen at an angle.
    ui::Point direction(const Eigen::Vector3d& unit) const;
    double scale() const; ///< logical pixels per unit of length
    /// Larger is nearer to the eye; 0 in the plane.
    double nearness(const Eigen::Vector3d& place) const;
    /// The place that is seen there, so near to the eye; in the plane that of the plane.
    Eigen::Vector3d place_at(ui::Point on_sheet, double nearness) const;
    bool is_plane() const { return std::holds_alternative<ui::PlaneCamera>(camera_); }
    /// Where a straight from `start` to `end` is seen nearest to a place of the sheet: a share of its length, beyond 0 to 1
    /// beside it; nothing where the straight is seen end-on.
    std::optional<double> nearest_share(const Eigen::Vector3d& start, const Eigen::Vector3d& end, ui::Point at) const;
    /// Unit vector from the model to the eye.
    Eigen::Vector3d toward_eye() const;
    const Camera& camera() const { return camera_; }
    ui::Point shift() const { return shift_; }

    SymbolFrame frame(const Eigen::Vector3d& origin, const Eigen::Vector3d& x, const Eigen::Vector3d& y) const
    {
        return {(*this)(origin), direction(x), direction(y)};
    }

private:
    Camera camera_;
    ui::Point shift_;
};

} // namespace drawing
