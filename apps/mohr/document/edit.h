#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/mohr/document/solution.h"

namespace mohr {

/// What comes of an edit: the document as it would be, or why it cannot be.
struct Edit {
    Document document;
    std::optional<Fault> fault{};
};

/// A number as it is typed. A bare one gets the unit that its group has.
Edit with_number(const Document& document, NumberId number, std::string_view text);
/// The angle of the plane [degrees], taken into (-180, 180].
Edit with_angle(const Document& document, double degrees);
Edit with_normal(const Document& document, const std::array<double, 3>& normal);
/// The plane's components; of a rosette its readings follow. \pre a plane subject
Edit with_plane(const Document& document, const femoop::mohr::PlaneState& state);
/// The components by the principal values and the direction of the first [degrees]. \pre a plane subject
Edit with_principal(const Document& document, double first, double second, double degrees);

/// The components in space. \pre Subject::SpaceStress
Edit with_space(const Document& document, const femoop::mohr::SpaceState& state);
/// The components by principal values, in any order, and directions. \pre Subject::SpaceStress
Edit with_space_principal(const Document& document, const femoop::mohr::SpacePrincipal& principal);

/// The present state becomes the path's next one. \pre has_path(document.subject)
Edit with_path_state(const Document& document);
Edit without_path(const Document& document);

/// The height of the fibre [mm]. \pre Subject::Section
Edit with_fibre(const Document& document, double y);

/// The plane's number counted as the document writes it: rounded to `digits` significant digits of `largest`.
double rounded(double value, double largest, int digits);

/// The next larger of 1, 2, 5 times a power of ten. \pre least > 0
double round_step(double least);

} // namespace mohr
