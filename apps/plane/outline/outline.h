#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/plane/model/plane_model.h"

namespace outline {

/// Curves that another program has drawn, and what of its drawing is left out.
struct Outline {
    std::vector<femoop::plane::DrawnShape> curves; ///< by their own x and y, in `unit`; y up
    std::optional<femoop::LengthUnit> unit;        ///< nothing where the file does not say
    std::map<std::string, std::size_t> left_out;   ///< how many of each kind, by the words of its format: TEXT, HATCH
};

std::string left_out_text(const Outline& outline); ///< "2 HATCH, 5 TEXT"

/// The most pieces, straight ones and others, that are taken of a file: a drawing of more would not follow a hand.
inline constexpr std::size_t most_pieces = 10'000;

/// Is it a file of another program's, by its extension: .dxf or .svg?
bool is_outline_file(const std::filesystem::path& path);

/// The lines, arcs, circles, ellipses and splines of a DXF file (in text, of any version) as they lie in its model
/// space, blocks where they are inserted. What lies on layers that are off, and what is no curve in the plane of the
/// drawing, is left out.
/// Source  AutoCAD 2012 DXF Reference
/// \throws topology::LineError naming the line that cannot be read
Outline read_dxf(std::string_view text);

/// The shapes and paths of an SVG file, filled or not, in mm where it says how large its page is; y is turned upwards.
/// Source  W3C, Scalable Vector Graphics 1.1, 7 (coordinates), 8 (paths), 9 (shapes)
/// \throws topology::LineError naming the line that cannot be read
Outline read_svg(std::string_view text);

/// Either of them. \pre is_outline_file(path)
Outline read_outline(const std::filesystem::path& path, std::string_view text);

/// A drawing of these curves and nothing else, in the model's units. Their ends, corners and control points become
/// points of the model; places that differ by no more than the rounding of a file, 1e-6 of the outline's size, are one.
/// Where the file has no unit, its numbers are taken as they are.
femoop::plane::PlaneModel drawing_of(const Outline& outline, const femoop::Units& units);

} // namespace outline
