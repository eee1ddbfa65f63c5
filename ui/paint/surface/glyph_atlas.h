#pragma once

#include "ui/paint/image.h"
#include "ui/paint/text_measure.h"

#include <cstdint>
#include <memory>
#include <unordered_map>

namespace ui {

/// Whether a glyph's horizontal strokes are fitted to whole pixels: yes for upright text, no for slanted text.
enum class GlyphFit { Pixels, None };

/// One glyph as drawn.
struct GlyphLook {
    char32_t character = 0;
    Weight weight = Weight::Regular;
    double size = 13.0; ///< em in PHYSICAL pixels, from 1 to GlyphAtlas::largest_em
    int phase = 0;      ///< quarter of a pixel by which it is shifted to the right, 0 to 3
    GlyphFit fit = GlyphFit::Pixels;
};

/// Where a glyph stands in its page, and where its bitmap's top left corner lies from the pen (y down) [px].
struct GlyphPlace {
    const Image* page = nullptr;
    int x = 0;
    int y = 0;
    int width = 0; ///< 0 for a blank
    int height = 0;
    int left = 0;
    int top = 0;
};

/// Bitmaps of glyphs, drawn by FreeType at the very size they are shown at, when they are first asked for.
/// Not thread-safe; one atlas may serve any number of draw lists that are rendered before `trim`.
class GlyphAtlas {
public:
    static constexpr int n_phases = 4;
    static constexpr int page_side = 1024;
    static constexpr double largest_em =
        400.0; ///< [px]: any glyph of it fits on a page; a larger one is to be stretched

    explicit GlyphAtlas(const Fonts& fonts);
    ~GlyphAtlas();
    GlyphAtlas(const GlyphAtlas&) = delete;
    GlyphAtlas& operator=(const GlyphAtlas&) = delete;

    GlyphPlace glyph(const GlyphLook& look);
    /// The page that lines and areas are drawn with: its first pixels are full.
    const Image* page() const { return pages_.back().get(); }
    /// Texture coordinate of a full pixel, the same on every page.
    static constexpr double full_pixel() { return 1.5 / page_side; }
    /// Call between frames: forgets all glyphs once they fill more than four pages.
    void trim();
    const Fonts& fonts() const { return fonts_; }

private:
    struct FreeType;

    void add_page();
    /// Takes room on the last page, or on a new one. \pre fits on an empty page
    GlyphPlace room_for(int width, int height);

    const Fonts& fonts_;
    std::unique_ptr<FreeType> freetype_;
    std::vector<std::unique_ptr<Image>> pages_;
    std::unordered_map<std::uint64_t, GlyphPlace> glyphs_;
    std::uint64_t version_ = 0; ///< of the page that changed last; never used twice
    int shelf_x_ = 0;
    int shelf_y_ = 0;
    int shelf_height_ = 0;
};

} // namespace ui
