#include "ui/paint/text_measure.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_ADVANCES_H

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <utility>

namespace ui {

namespace {

constexpr double ascent_of_em = 0.76;  // DejaVu Sans: b, d, k reach 1556 of 2048 units
constexpr double descent_of_em = 0.24; // g, p reach 426 below the baseline and have rounding left over
constexpr char32_t replacement = 0xFFFD;

std::string_view file_name(Weight weight) { return weight == Weight::Bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf"; }

std::string missing_font(const std::vector<std::filesystem::path>& folders)
{
    std::string text = "font DejaVu Sans: DejaVuSans.ttf and DejaVuSans-Bold.ttf were not found together in any of";
    for (const auto& folder : folders) text += "\n  " + folder.string();
    return text + "\ninstall the package fonts-dejavu-core or set CREMONA_FONT_DIR to the folder that holds them";
}

std::filesystem::path folder_with_fonts(const std::vector<std::filesystem::path>& folders)
{
    for (const auto& folder : folders) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(folder / file_name(Weight::Regular), ignored) &&
            std::filesystem::is_regular_file(folder / file_name(Weight::Bold), ignored))
            return folder;
    }
    throw FontError(missing_font(folders));
}

std::vector<unsigned char> bytes_of(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in || bytes.empty()) throw FontError("font file " + path.string() + ": cannot be read");
    return bytes;
}

void add_from_environment(std::vector<std::filesystem::path>& folders, const char* variable, const char* below)
{
    const char* value = std::getenv(variable);
    if (value != nullptr && *value != '\0') folders.push_back(std::filesystem::path(value) / below);
}

} // namespace

struct Fonts::Face {
    struct Glyph {
        unsigned index;
        float advance; // of the em
    };

    Face(const std::filesystem::path& file) : path(file), bytes(bytes_of(file)) { read_metrics(); }

    const Glyph* find(char32_t character) const
    {
        const auto it = glyphs.find(character);
        return it == glyphs.end() ? nullptr : &it->second;
    }

    void read_metrics();
    void read_glyphs(FT_Face face);

    std::filesystem::path path;
    std::vector<unsigned char> bytes;
    std::unordered_map<char32_t, Glyph> glyphs;
    double missing_advance = 0.0;
    double cap_height = 0.0;
};

void Fonts::Face::read_metrics()
{
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw FontError("font reader: FreeType does not start");
    const std::unique_ptr<FT_LibraryRec_, FT_Error (*)(FT_Library)> close_library(library, FT_Done_FreeType);
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face) != 0)
        throw FontError("font file " + path.string() + ": is not a font that can be read; install it again");
    const std::unique_ptr<FT_FaceRec_, FT_Error (*)(FT_Face)> close_face(face, FT_Done_Face);
    read_glyphs(face);
}

void Fonts::Face::read_glyphs(FT_Face face)
{
    const double em = face->units_per_EM;
    if (em <= 0.0) throw FontError("font file " + path.string() + ": has no scalable outlines; install it again");
    const auto advance_of = [&](FT_UInt index) {
        FT_Fixed units = 0;
        return FT_Get_Advance(face, index, FT_LOAD_NO_SCALE, &units) == 0 ? static_cast<double>(units) / em : 0.0;
    };
    FT_UInt index = 0;
    for (FT_ULong c = FT_Get_First_Char(face, &index); index != 0; c = FT_Get_Next_Char(face, c, &index))
        glyphs.emplace(static_cast<char32_t>(c), Glyph{index, static_cast<float>(advance_of(index))});
    missing_advance = advance_of(0);
    if (FT_Load_Char(face, 'H', FT_LOAD_NO_SCALE) == 0)
        cap_height = static_cast<double>(face->glyph->metrics.horiBearingY) / em;
}

Fonts::Fonts() : Fonts(folder_with_fonts(font_folders())) {}

Fonts::Fonts(const std::filesystem::path& folder)
{
    const auto place = folder_with_fonts({folder});
    regular_ = std::make_unique<Face>(place / file_name(Weight::Regular));
    bold_ = std::make_unique<Face>(place / file_name(Weight::Bold));
}

Fonts::~Fonts() = default;
Fonts::Fonts(Fonts&&) noexcept = default;
Fonts& Fonts::operator=(Fonts&&) noexcept = default;

const Fonts::Face& Fonts::face(Weight weight) const { return weight == Weight::Bold ? *bold_ : *regular_; }

TextExtent Fonts::measure(std::string_view utf8, double size, Weight weight) const
{
    double em_widths = 0.0;
    for (const char32_t character : decode_utf8(utf8)) em_widths += advance(character, weight);
    return {.width = em_widths * size, .ascent = ascent_of_em * size, .descent = descent_of_em * size};
}

TextExtent Fonts::measure(std::string_view utf8, const TextStyle& style) const
{
    return measure(utf8, style.size, style.weight);
}

double Fonts::advance(char32_t character, Weight weight) const
{
    const auto* glyph = face(weight).find(character);
    return glyph ? static_cast<double>(glyph->advance) : face(weight).missing_advance;
}

bool Fonts::has_glyph(char32_t character, Weight weight) const { return face(weight).find(character) != nullptr; }

unsigned Fonts::glyph_index(char32_t character, Weight weight) const
{
    const auto* glyph = face(weight).find(character);
    return glyph ? glyph->index : 0;
}

double Fonts::cap_height() const { return regular_->cap_height; }

std::span<const unsigned char> Fonts::file(Weight weight) const { return face(weight).bytes; }

std::filesystem::path Fonts::file_path(Weight weight) const { return face(weight).path; }

std::vector<std::filesystem::path> font_folders()
{
    std::vector<std::filesystem::path> folders;
    add_from_environment(folders, "CREMONA_FONT_DIR", "");
    for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu", "/usr/share/fonts/TTF",
                               "/usr/share/fonts/dejavu-sans-fonts", "/usr/local/share/fonts", "/Library/Fonts",
                               "/opt/homebrew/share/fonts", "C:/Windows/Fonts"})
        folders.emplace_back(folder);
    add_from_environment(folders, "HOME", ".local/share/fonts");
    add_from_environment(folders, "HOME", ".fonts");
    add_from_environment(folders, "HOME", "Library/Fonts");
    return folders;
}

namespace {

/// Number of bytes that follow a lead byte; nothing for a byte that cannot lead.
std::optional<std::size_t> n_continuations(unsigned char lead)
{
    if (lead < 0x80) return 0;
    if (lead >= 0xC2 && lead < 0xE0) return 1;
    if (lead >= 0xE0 && lead < 0xF0) return 2;
    if (lead >= 0xF0 && lead < 0xF5) return 3;
    return std::nullopt;
}

/// The character at the front of `utf8` and its number of bytes; one byte and the replacement where it is broken.
std::pair<char32_t, std::size_t> first_character(std::string_view utf8)
{
    constexpr char32_t smallest[] = {0, 0x80, 0x800, 0x10000};
    const auto lead = static_cast<unsigned char>(utf8.front());
    const auto following = n_continuations(lead);
    if (!following || *following >= utf8.size()) return {replacement, 1};
    if (*following == 0) return {lead, 1};
    char32_t character = lead & (0x3Fu >> *following);
    for (std::size_t i = 1; i <= *following; ++i) {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        if ((byte & 0xC0u) != 0x80u) return {replacement, 1};
        character = (character << 6) | (byte & 0x3Fu);
    }
    const bool is_surrogate = character >= 0xD800 && character < 0xE000;
    if (character < smallest[*following] || character > 0x10FFFF || is_surrogate) return {replacement, 1};
    return {character, *following + 1};
}

} // namespace

std::u32string decode_utf8(std::string_view utf8)
{
    std::u32string characters;
    characters.reserve(utf8.size());
    while (!utf8.empty()) {
        const auto [character, n_bytes] = first_character(utf8);
        characters += character;
        utf8.remove_prefix(n_bytes);
    }
    return characters;
}

int n_utf8_bytes(char32_t character)
{
    return character < 0x80 ? 1 : (character < 0x800 ? 2 : (character < 0x10000 ? 3 : 4));
}

std::string encode_utf8(std::u32string_view characters)
{
    constexpr std::array<unsigned, 5> lead_marks = {0, 0x00, 0xC0, 0xE0, 0xF0};
    std::string text;
    for (const char32_t c : characters) {
        const int n = n_utf8_bytes(c);
        text += static_cast<char>(lead_marks[static_cast<std::size_t>(n)] | (c >> (6 * (n - 1))));
        for (int i = n - 2; i >= 0; --i) text += static_cast<char>(0x80u | ((c >> (6 * i)) & 0x3Fu));
    }
    return text;
}

Point baseline_offset(const TextExtent& extent, double cap_height, Anchor anchor)
{
    const int column = static_cast<int>(anchor) % 3; // left, middle, right
    const int row = static_cast<int>(anchor) / 3;    // top, middle, bottom
    const double x = -0.5 * column * extent.width;
    const double y = row == 0 ? extent.ascent : (row == 1 ? 0.5 * cap_height : -extent.descent);
    return {x, y};
}

std::array<Point, 4> text_corners(const Fonts& fonts, Point at, std::string_view utf8, const TextStyle& style)
{
    const TextExtent extent = fonts.measure(utf8, style);
    const Point base = baseline_offset(extent, fonts.cap_height() * style.size, style.anchor);
    const double c = std::cos(style.rotation), s = std::sin(style.rotation);
    const auto placed = [&](double x, double y) { return at + Point{c * x + s * y, -s * x + c * y}; };
    const double right = base.x + extent.width, top = base.y - extent.ascent, bottom = base.y + extent.descent;
    return {placed(base.x, top), placed(right, top), placed(right, bottom), placed(base.x, bottom)};
}

Box text_box(const Fonts& fonts, Point at, std::string_view utf8, const TextStyle& style)
{
    const auto corners = text_corners(fonts, at, utf8, style);
    Box box{corners[0], corners[0]};
    for (const Point corner : corners) box = united(box, {corner, corner});
    return box;
}

} // namespace ui
