#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "femoop/model/quantity/quantity.h"

namespace femoop {

/// A linear elastic, isotropic material.
struct Material {
    std::string id;
    Quantity E;                      ///< Young's modulus, > 0
    std::optional<Quantity> nu;      ///< Poisson's ratio, -1 < nu <= 0.5; 0.3 when absent
    std::optional<Quantity> G;       ///< shear modulus; E / (2 (1 + nu)) when absent
    std::optional<Quantity> alpha;   ///< coefficient of thermal expansion [1/K]
    std::optional<Quantity> density; ///< [mass / length^3]
    std::optional<Quantity> fy;      ///< yield stress

    double poisson() const { return nu ? nu->value() : 0.3; }
    double shear_modulus() const { return G ? G->value() : E / (2.0 * (1.0 + poisson())); }
    friend bool operator==(const Material&, const Material&) = default;
};

/// The shapes that sections are built from, with h along y' and no fillets.
enum class SectionShapeKind : std::uint8_t { Rectangle, Circle, Tube, Box, I, T, L, C };

/// A shape and its dimensions; which of them a kind needs: rectangle b h | circle d | tube d t | box b h t |
/// i h bf tf tw | t h bf tf tw | l h b t | c h bf tf tw.
struct SectionShape {
    SectionShapeKind kind = SectionShapeKind::Rectangle;
    std::optional<Quantity> b, h, d, t, bf, tf, tw;

    friend bool operator==(const SectionShape&, const SectionShape&) = default;
};

/// A cross-section, given by properties, by a shape or by a profile's name. A property beside a shape or a
/// profile overrides it. What the analysis uses is `section_properties` (femoop/section/section_properties.h).
struct Section {
    std::string id;
    std::optional<SectionShape> shape;
    std::optional<std::string> profile; ///< as typed: "IPE 300", "w12x26"
    bool turned =
        false; ///< the shape or profile lies on its side, turned by 90 degrees counter-clockwise as seen along +x'
    std::optional<Quantity> A;        ///< area
    std::optional<Quantity> Iz;       ///< second moment for bending in the x'y' plane
    std::optional<Quantity> Iy;       ///< second moment for bending in the x'z' plane
    std::optional<Quantity> J;        ///< torsion constant
    std::optional<Quantity> Asy, Asz; ///< shear areas for Vy and Vz; absent: no shear strain in that plane
    std::optional<Quantity> h;        ///< depth along y'
    std::optional<Quantity> yc;       ///< centroid's distance from the -y' fibre; h/2 when absent

    friend bool operator==(const Section&, const Section&) = default;
};

} // namespace femoop
