#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/style.h"

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ui {

/// The font is missing or unreadable; the message names the places searched and the remedy.
class FontError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Room that a string takes, in logical pixels, unrotated.
///
///     ---------------   ^ ascent: from the baseline to the top of b, d, k (accents on capitals stand above it)
///     k N · m        |  |
///     ---- baseline --  v
///                       descent: from the baseline to the foot of g, p
struct TextExtent {
    double width = 0.0;
    double ascent = 0.0;
    double descent = 0.0;

    double height() const { return ascent + descent; }
};

/// The suite's typeface, DejaVu Sans in two weights, read from its font files. Immutable and free to share.
///
/// The one place where text is measured: the width of a string is the sum of its glyphs' advances as the file has
/// them, without hinting and kerning, times the size. Every surface sets its text at this width.
class Fonts {
public:
    /// Looks in $CREMONA_FONT_DIR and in the usual places of the system. \throws FontError
    Fonts();
    /// Looks in one folder only. \throws FontError
    explicit Fonts(const std::filesystem::path& folder);
    ~Fonts();
    Fonts(Fonts&&) noexcept;
    Fonts& operator=(Fonts&&) noexcept;

    TextExtent measure(std::string_view utf8, double size, Weight weight = Weight::Regular) const;
    TextExtent measure(std::string_view utf8, const TextStyle& style) const;
    /// Advance of one character [fraction of the em]; that of the replacement box where the font has no such glyph.
    double advance(char32_t character, Weight weight) const;
    bool has_glyph(char32_t character, Weight weight) const;
    /// Number of the glyph in the file, 0 (the replacement box) where there is none.
    unsigned glyph_index(char32_t character, Weight weight) const;
    /// Height of a capital letter [fraction of the em].
    double cap_height() const;
    /// The whole font file, for those who draw its outlines.
    std::span<const unsigned char> file(Weight weight) const;
    std::filesystem::path file_path(Weight weight) const;

private:
    struct Face;
    std::unique_ptr<Face> regular_;
    std::unique_ptr<Face> bold_;

    const Face& face(Weight weight) const;
};

/// Folders that `Fonts()` looks into, in this order.
std::vector<std::filesystem::path> font_folders();

/// Characters of a UTF-8 string; each byte that is no part of a character becomes U+FFFD.
std::u32string decode_utf8(std::string_view utf8);
std::string encode_utf8(std::u32string_view characters);
/// Bytes that a character takes in UTF-8, 1 to 4.
int n_utf8_bytes(char32_t character);

/// From the anchored point to the baseline's left end, in the text's own unrotated frame (y down).
Point baseline_offset(const TextExtent& extent, double cap_height, Anchor anchor);

/// The corners of the string's box when it is drawn at `at`, in the order top left, top right, bottom right, bottom
/// left of the unrotated text.
std::array<Point, 4> text_corners(const Fonts& fonts, Point at, std::string_view utf8, const TextStyle& style);
/// The axis-aligned box around those corners.
Box text_box(const Fonts& fonts, Point at, std::string_view utf8, const TextStyle& style);

} // namespace ui
