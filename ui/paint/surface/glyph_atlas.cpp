#include "ui/paint/surface/glyph_atlas.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

constexpr std::size_t most_pages = 4;
constexpr int gap = 1; // [px] between glyphs, so that a turned one does not pick up its neighbour

long em_in_64ths(double size) { return std::lround(std::clamp(size, 1.0, GlyphAtlas::largest_em) * 64.0); }

std::uint64_t key_of(const GlyphLook& look)
{
    std::uint64_t key = look.character;                                   // 21 bits
    key = key << 16 | static_cast<std::uint64_t>(em_in_64ths(look.size)); // below 2^15
    key = key << 2 | static_cast<std::uint64_t>(look.phase);
    key = key << 1 | (look.weight == Weight::Bold ? 1u : 0u);
    return key << 1 | (look.fit == GlyphFit::None ? 1u : 0u);
}

} // namespace

struct GlyphAtlas::FreeType {
    FT_Library library = nullptr;
    std::array<FT_Face, 2> faces{};

    explicit FreeType(const Fonts& fonts)
    {
        if (FT_Init_FreeType(&library) != 0) throw FontError("font reader: FreeType does not start");
        for (const Weight weight : {Weight::Regular, Weight::Bold}) {
            const auto file = fonts.file(weight);
            if (FT_New_Memory_Face(library, file.data(), static_cast<FT_Long>(file.size()), 0, &face(weight)) == 0)
                continue;
            FT_Done_FreeType(library); // closes the faces too
            throw FontError("font file " + fonts.file_path(weight).string() + ": cannot be read");
        }
    }
    ~FreeType() { FT_Done_FreeType(library); }
    FreeType(const FreeType&) = delete;
    FreeType& operator=(const FreeType&) = delete;

    FT_Face& face(Weight weight) { return faces[weight == Weight::Bold ? 1 : 0]; }

    /// The glyph's bitmap, valid until the next call; nothing for a glyph that cannot be drawn.
    FT_GlyphSlot draw(const GlyphLook& look, unsigned index)
    {
        const FT_Face f = face(look.weight);
        const FT_Int32 flags = look.fit == GlyphFit::Pixels ? FT_LOAD_TARGET_LIGHT : FT_LOAD_NO_HINTING;
        if (FT_Set_Char_Size(f, 0, em_in_64ths(look.size), 72, 72) != 0 || FT_Load_Glyph(f, index, flags) != 0)
            return nullptr;
        FT_Outline_Translate(&f->glyph->outline, look.phase * 64 / n_phases, 0);
        return FT_Render_Glyph(f->glyph, FT_RENDER_MODE_NORMAL) == 0 ? f->glyph : nullptr;
    }
};

GlyphAtlas::GlyphAtlas(const Fonts& fonts) : fonts_(fonts), freetype_(std::make_unique<FreeType>(fonts)) { add_page(); }

GlyphAtlas::~GlyphAtlas() = default;

void GlyphAtlas::add_page()
{
    auto page = std::make_unique<Image>();
    page->width = page->height = page_side;
    page->pixels.assign(static_cast<std::size_t>(page_side) * page_side, 0);
    for (std::size_t row = 0; row < 3; ++row)
        std::fill_n(page->pixels.begin() + static_cast<std::ptrdiff_t>(row * page_side), 3, 255);
    page->version = ++version_;
    pages_.push_back(std::move(page));
    shelf_x_ = 3 + gap;
    shelf_y_ = 0;
    shelf_height_ = 3;
}

GlyphPlace GlyphAtlas::room_for(int width, int height)
{
    if (shelf_x_ + width > page_side) {
        shelf_x_ = 0;
        shelf_y_ += shelf_height_ + gap;
        shelf_height_ = 0;
    }
    if (shelf_y_ + height > page_side) {
        add_page();
        return room_for(width, height);
    }
    GlyphPlace place{.page = page(), .x = shelf_x_, .y = shelf_y_, .width = width, .height = height};
    shelf_x_ += width + gap;
    shelf_height_ = std::max(shelf_height_, height);
    return place;
}

GlyphPlace GlyphAtlas::glyph(const GlyphLook& look)
{
    const std::uint64_t key = key_of(look);
    if (const auto known = glyphs_.find(key); known != glyphs_.end()) return known->second;
    const FT_GlyphSlot slot = freetype_->draw(look, fonts_.glyph_index(look.character, look.weight));
    GlyphPlace place{.page = page()};
    if (slot && slot->bitmap.width > 0 && slot->bitmap.rows > 0) {
        place = room_for(static_cast<int>(slot->bitmap.width), static_cast<int>(slot->bitmap.rows));
        place.left = slot->bitmap_left;
        place.top = -slot->bitmap_top;
        Image& image = *pages_.back();
        for (int row = 0; row < place.height; ++row) {
            const unsigned char* source = slot->bitmap.buffer + static_cast<std::ptrdiff_t>(row) * slot->bitmap.pitch;
            std::copy_n(source, place.width, image.pixels.begin() + (place.y + row) * page_side + place.x);
        }
        image.version = ++version_;
    }
    glyphs_.emplace(key, place);
    return place;
}

void GlyphAtlas::trim()
{
    if (pages_.size() <= most_pages) return;
    glyphs_.clear();
    pages_.clear();
    add_page();
}

} // namespace ui
