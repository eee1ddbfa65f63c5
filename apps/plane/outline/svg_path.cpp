#include "apps/plane/outline/svg_path.h"

#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "apps/plane/outline/svg_scanner.h"
#include "femoop/model/fault/translator.h"
#include "topology/text/line_error.h"

namespace outline {

using femoop::translatable;
using topology::LineError;

namespace {

/// An arc as SVG writes it: by its ends, its radii and which of the four arcs it is.
struct EndpointArc {
    Place from, to;
    double rx = 0.0, ry = 0.0, angle = 0.0; ///< [rad]
    bool is_large = false, grows = false;   ///< more than half a turn; the angle grows from one end to the other
};

/// The arc by its centre; radii that are too small for the ends are made larger. \pre its radii are not 0
EllipticArc by_centre(const EndpointArc& arc)
{
    const Eigen::Rotation2Dd turn(arc.angle);
    const Eigen::Vector2d half = turn.inverse() * Eigen::Vector2d(0.5 * (arc.from - arc.to));
    Eigen::Vector2d radii(std::abs(arc.rx), std::abs(arc.ry));
    const double reach = half.cwiseQuotient(radii).squaredNorm();
    if (reach > 1.0) radii *= std::sqrt(reach);
    const Eigen::Vector2d on_circle = half.cwiseQuotient(radii);
    const double squared = on_circle.squaredNorm();
    const double share = std::sqrt(std::max(0.0, 1.0 / squared - 1.0)) * (arc.is_large == arc.grows ? -1.0 : 1.0);
    const Eigen::Vector2d centre(share * on_circle.y(), -share * on_circle.x()); // of the circle of radius 1
    const Eigen::Vector2d a = on_circle - centre, b = -on_circle - centre;
    const double from = std::atan2(a.y(), a.x());
    double sweep = std::atan2(b.y(), b.x()) - from;
    if (arc.grows && sweep < 0.0) sweep += 2.0 * std::numbers::pi;
    if (!arc.grows && sweep > 0.0) sweep -= 2.0 * std::numbers::pi;
    return {.center = 0.5 * (arc.from + arc.to) + turn * Eigen::Vector2d(radii.cwiseProduct(centre)),
            .u = turn * Eigen::Vector2d(radii.x(), 0.0),
            .v = turn * Eigen::Vector2d(0.0, radii.y()),
            .from = from,
            .to = from + sweep};
}

class PathReader {
public:
    explicit PathReader(std::string_view data) : scanner_(data) {}

    std::vector<Curve> take()
    {
        char command = 0;
        while (!scanner_.is_at_end()) {
            if (!scanner_.is_at_number()) command = scanner_.letter();
            else if (command == 'Z' || command == 'z')
                throw LineError(translatable("path data begin with M, and no number follows Z"), {});
            else if (command == 'M') command = 'L'; // further pairs are lines
            else if (command == 'm') command = 'l';
            draw(command);
        }
        end_run();
        return std::move(curves_);
    }

private:
    void draw(char command)
    {
        is_relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        if (!has_begun_ && kind != 'M')
            throw LineError(translatable("path data begin with M, and no number follows Z"), {});
        const std::optional<Place> cubic_before = std::exchange(last_cubic_, std::nullopt);
        const std::optional<Place> quadratic_before = std::exchange(last_quadratic_, std::nullopt);
        switch (kind) {
        case 'M': move_to(place()); break;
        case 'L': line_to(place()); break;
        case 'H': line_to({(is_relative_ ? at_.x() : 0.0) + scanner_.number(), at_.y()}); break;
        case 'V': line_to({at_.x(), (is_relative_ ? at_.y() : 0.0) + scanner_.number()}); break;
        case 'C': cubic_to(place()); break;
        case 'S': cubic_to(mirrored(cubic_before)); break;
        case 'Q': quadratic_to(place()); break;
        case 'T': quadratic_to(mirrored(quadratic_before)); break;
        case 'A': arc_to(); break;
        case 'Z': close(); break;
        default:
            throw LineError(translatable("\"{0}\" is no command of path data; wanted M L H V C S Q T A Z"),
                            {std::string(1, command)});
        }
    }

    Place place()
    {
        const double x = scanner_.number(), y = scanner_.number();
        return is_relative_ ? Place(at_.x() + x, at_.y() + y) : Place(x, y);
    }
    Place mirrored(const std::optional<Place>& control) const { return control ? Place(2.0 * at_ - *control) : at_; }

    void move_to(const Place& to)
    {
        end_run();
        at_ = begin_ = to;
        has_begun_ = true;
    }

    void line_to(const Place& to)
    {
        end_chain();
        if (run_.places.empty()) run_.places.push_back(at_);
        run_.places.push_back(to);
        at_ = to;
    }

    void cubic_to(const Place& first)
    {
        const Place second = place(), to = place();
        add_cubic(first, second, to);
        last_cubic_ = second;
    }

    void quadratic_to(const Place& control)
    {
        const Place to = place();
        const std::array<Place, 4> cubic = raised({at_, control, to});
        add_cubic(cubic[1], cubic[2], to);
        last_quadratic_ = control;
    }

    void add_cubic(const Place& first, const Place& second, const Place& to)
    {
        end_line();
        if (chain_.places.empty()) chain_.places.push_back(at_);
        chain_.places.insert(chain_.places.end(), {first, second, to});
        at_ = to;
    }

    void arc_to()
    {
        EndpointArc arc{.from = at_, .to = at_};
        arc.rx = scanner_.number();
        arc.ry = scanner_.number();
        arc.angle = scanner_.number() * std::numbers::pi / 180.0;
        arc.is_large = scanner_.flag();
        arc.grows = scanner_.flag();
        arc.to = place();
        if (arc.rx == 0.0 || arc.ry == 0.0) return line_to(arc.to);
        end_run();
        if (arc.to != arc.from) curves_.emplace_back(by_centre(arc));
        at_ = arc.to;
    }

    void close()
    {
        const bool is_all = !run_.places.empty() && run_.places.front() == begin_ && chain_.places.empty();
        if (is_all) run_.is_closed = true;
        else if (at_ != begin_) line_to(begin_);
        end_run();
        at_ = begin_;
    }

    void end_line()
    {
        if (run_.places.size() > 1) curves_.emplace_back(run_);
        run_ = {};
    }
    void end_chain()
    {
        if (!chain_.places.empty()) curves_.emplace_back(chain_);
        chain_ = {};
    }
    void end_run()
    {
        end_line();
        end_chain();
    }

    SvgScanner scanner_;
    std::vector<Curve> curves_;
    Polyline run_;
    CubicChain chain_;
    Place at_ = Place::Zero(), begin_ = Place::Zero();
    std::optional<Place> last_cubic_, last_quadratic_; ///< the control point before the end, which S and T mirror
    bool is_relative_ = false, has_begun_ = false;
};

/// One of the factors of an attribute `transform`.
Affine factor(std::string_view name, const std::vector<double>& values)
{
    constexpr double degree = std::numbers::pi / 180.0;
    const std::size_t n = values.size();
    const auto value = [&](std::size_t i, double absent) { return i < n ? values[i] : absent; };
    Affine map = Affine::Identity();
    if (name == "matrix" && n == 6) {
        map.matrix().topRows<2>() << values[0], values[2], values[4], values[1], values[3], values[5];
        return map;
    }
    if (name == "translate" && (n == 1 || n == 2)) return map * Eigen::Translation2d(values[0], value(1, 0.0));
    if (name == "scale" && (n == 1 || n == 2)) return map * Eigen::Scaling(values[0], value(1, values[0]));
    if (name == "rotate" && (n == 1 || n == 3)) {
        const Eigen::Vector2d about(value(1, 0.0), value(2, 0.0));
        return map * Eigen::Translation2d(about) * Eigen::Rotation2Dd(values[0] * degree) *
               Eigen::Translation2d(-about);
    }
    if (name == "skewX" && n == 1) map(0, 1) = std::tan(values[0] * degree);
    else if (name == "skewY" && n == 1) map(1, 0) = std::tan(values[0] * degree);
    else
        throw LineError(translatable("\"{0}\" with {1} numbers is no transform"),
                        {std::string(name.substr(0, 40)), std::to_string(n)});
    return map;
}

} // namespace

std::vector<Curve> svg_path(std::string_view data) { return PathReader(data).take(); }

std::vector<double> svg_numbers(std::string_view text)
{
    SvgScanner scanner(text);
    std::vector<double> numbers;
    while (!scanner.is_at_end()) numbers.push_back(scanner.number());
    return numbers;
}

Affine svg_transform(std::string_view text)
{
    Affine map = Affine::Identity();
    SvgScanner scanner(text);
    while (!scanner.is_at_end()) {
        std::string_view name = scanner.word("(");
        name = name.substr(0, name.find_last_not_of(" \t\r\n") + 1);
        if (scanner.is_at_end())
            throw LineError(translatable("\"{0}\" with {1} numbers is no transform"),
                            {std::string(name.substr(0, 40)), "0"});
        scanner.letter();
        map = map * factor(name, svg_numbers(scanner.word(")")));
        if (!scanner.is_at_end()) scanner.letter();
    }
    return map;
}

} // namespace outline
