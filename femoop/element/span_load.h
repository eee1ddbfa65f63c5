#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace femoop {

/// Components along a member's own axes: forces x' y' z', then moments about them.
enum class LocalAxis : std::uint8_t { x, y, z, rx, ry, rz };
inline constexpr std::size_t n_local_axes = 6;
constexpr std::size_t index(LocalAxis axis) { return static_cast<std::size_t>(axis); }
constexpr bool is_rotation(LocalAxis axis) { return axis >= LocalAxis::rx; }

/// One component of a load on a member, in the member's own axes and consistent units.
struct SpanLoad {
    enum class Kind : std::uint8_t {
        Distributed, ///< from `start` at `from` to `end` at `to`, linear, per unit length
        Point,       ///< `start` at `from`
        Strain       ///< the whole member would lengthen by `start` and bend by the curvature `end` if it were free
    };
    Kind kind = Kind::Distributed;
    LocalAxis axis = LocalAxis::y;
    double from = 0.0, to = 0.0;
    double start = 0.0, end = 0.0;

    friend bool operator==(const SpanLoad&, const SpanLoad&) = default;
};

/// A stretch of a member between two neighbouring load points.
struct SpanPiece {
    double begin = 0.0, end = 0.0;
    bool begins_at_load = true;               ///< else it continues a longer stretch that was cut
    bool is_settled = false;                  ///< so far from loads and ends that a foundation feels them no more
    std::array<double, n_local_axes> jump{};  ///< point loads at `begin`
    std::array<double, n_local_axes> value{}; ///< distributed load just after `begin`
    std::array<double, n_local_axes> slope{}; ///< its change per unit length

    double length() const { return end - begin; }
};

/// All loads of one member, sorted into pieces; made once and refilled, so that a loop over members allocates nothing.
class SpanLoading {
public:
    static constexpr double no_settling = std::numeric_limits<double>::infinity();

    struct Scaled {
        std::span<const SpanLoad> loads;
        double factor = 1.0;
    };

    /// Sums `factor x loads` of every term over a member of length L.
    /// `longest` cuts pieces that would be longer (series on a foundation converge over a limited length).
    /// A stretch longer than twice `settling` has one settled piece in its middle, so that the pieces stay few.
    void assign(double L, std::span<const Scaled> terms, double longest, double settling = no_settling);

    double length() const { return length_; }
    const std::vector<SpanPiece>& pieces() const { return pieces_; }
    const std::array<double, n_local_axes>& last_jump() const { return last_jump_; } ///< point loads at x = L
    double strain() const { return strain_; }
    double curvature() const { return curvature_; }
    SpanLoading without_strain() const;    ///< a constraint follows imposed strains, so they load it not
    bool is_zero() const { return zero_; } ///< no load at all

private:
    void cut(std::span<const Scaled> terms, double longest, double settling);
    void cut(double begin, double end, double longest);
    void add(const SpanLoad& load, double factor);

    double length_ = 0.0;
    std::vector<double> places_;
    std::vector<SpanPiece> pieces_;
    std::array<double, n_local_axes> last_jump_{};
    double strain_ = 0.0, curvature_ = 0.0;
    bool zero_ = true;
};

} // namespace femoop
