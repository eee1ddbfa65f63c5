#include "femoop/section/profile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace femoop {

namespace {

// The tables stand as their standards print them: those of EN 10365 mix mm, cm and kg, those of AISC are in inches.
struct EuropeanRow {
    std::string_view name;
    double mass, h, b, tw, tf, r, A, Iy, Wel_y, Wpl_y, Iz, Wel_z, Wpl_z, It;
    double es = 0.0; // UPN only: the others are symmetric
};
constexpr EuropeanRow european_rows[] = {
#include "femoop/section/european_i.inc"
};
constexpr EuropeanRow upn_rows[] = {
#include "femoop/section/upn.inc"
};

struct AmericanRow {
    std::string_view name;
    double weight, A, d, bf, tw, tf, k, Ix, Zx, Sx, Iy, Zy, Sy, J;
};
constexpr AmericanRow american_rows[] = {
#include "femoop/section/aisc_w.inc"
};

constexpr ProfileFamily family_of(std::string_view name)
{
    if (name.starts_with("IPE")) return ProfileFamily::IPE;
    if (name.starts_with("HEA")) return ProfileFamily::HEA;
    if (name.starts_with("HEB")) return ProfileFamily::HEB;
    return name.starts_with("HEM") ? ProfileFamily::HEM : ProfileFamily::UPN;
}

constexpr Profile profile(const EuropeanRow& row)
{
    constexpr double mm = 10.0; // in a cm
    return {.name = row.name,
            .family = family_of(row.name),
            .unit = LengthUnit::cm,
            .h = row.h / mm,
            .bf = row.b / mm,
            .tf = row.tf / mm,
            .tw = row.tw / mm,
            .r = row.r / mm,
            .A = row.A,
            .Iz = row.Iy,
            .Wz = row.Wel_y,
            .Zz = row.Wpl_y,
            .Iy = row.Iz,
            .Wy = row.Wel_z,
            .Zy = row.Wpl_z,
            .J = row.It,
            .zc = row.es > 0.0 ? row.es : row.b / (2.0 * mm),
            .mass = row.mass};
}

constexpr Profile profile(const AmericanRow& row)
{
    constexpr double kg_per_m = 0.45359237 / 0.3048; // in a lb/ft
    return {.name = row.name,
            .family = ProfileFamily::W,
            .unit = LengthUnit::in,
            .h = row.d,
            .bf = row.bf,
            .tf = row.tf,
            .tw = row.tw,
            .r = row.k - row.tf,
            .A = row.A,
            .Iz = row.Ix,
            .Wz = row.Sx,
            .Zz = row.Zx,
            .Iy = row.Iy,
            .Wy = row.Sy,
            .Zy = row.Zy,
            .J = row.J,
            .zc = row.bf / 2.0,
            .mass = row.weight * kg_per_m};
}

constexpr auto all_profiles = [] {
    std::array<Profile, std::size(european_rows) + std::size(upn_rows) + std::size(american_rows)> all;
    auto* next = all.data();
    for (const EuropeanRow& row : european_rows) *next++ = profile(row);
    for (const EuropeanRow& row : upn_rows) *next++ = profile(row);
    for (const AmericanRow& row : american_rows) *next++ = profile(row);
    return all;
}();

constexpr std::array families{ProfileFamily::IPE, ProfileFamily::HEA, ProfileFamily::HEB,
                              ProfileFamily::HEM, ProfileFamily::UPN, ProfileFamily::W};
constexpr std::array<std::string_view, families.size()> family_names{"IPE", "HEA", "HEB", "HEM", "UPN", "W"};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// A name as the tables write it, on the stack.
class Key {
public:
    explicit Key(std::string_view name)
    {
        constexpr std::string_view times = "\u00d7";
        for (std::size_t i = 0; i < name.size(); ++i) {
            if (name.substr(i).starts_with(times)) {
                add('X');
                i += times.size() - 1;
            } else if (name[i] != ' ' && name[i] != '\t') {
                add(upper(name[i]));
            }
        }
        move_series_letter();
    }

    /// Empty when the name is longer than any in the tables.
    std::string_view text() const { return size_ > text_.size() ? std::string_view() : view(); }

private:
    std::string_view view() const { return {text_.data(), std::min(size_, text_.size())}; }
    void add(char c)
    {
        if (size_ < text_.size()) text_[size_] = c;
        ++size_;
    }
    /// "HE300A" becomes "HEA300".
    void move_series_letter()
    {
        if (view().starts_with("HE") && size_ > 3 && size_ <= text_.size() && is_digit(text_[2]))
            std::rotate(text_.begin() + 2, text_.begin() + static_cast<std::ptrdiff_t>(size_) - 1,
                        text_.begin() + static_cast<std::ptrdiff_t>(size_));
    }

    std::array<char, 16> text_{};
    std::size_t size_ = 0;
};

} // namespace

const Profile* find_profile(std::string_view name)
{
    const Key key(name);
    const auto found = std::ranges::find(all_profiles, key.text(), &Profile::name);
    return found == all_profiles.end() ? nullptr : &*found;
}

std::span<const Profile> profiles() { return all_profiles; }

std::span<const Profile> profiles(ProfileFamily family)
{
    const auto first = std::ranges::lower_bound(all_profiles, family, {}, &Profile::family);
    const auto last = std::ranges::upper_bound(all_profiles, family, {}, &Profile::family);
    return {first, last};
}

std::span<const ProfileFamily> profile_families() { return families; }

std::string_view name(ProfileFamily family) { return family_names[static_cast<std::size_t>(family)]; }

std::string_view standard(ProfileFamily family)
{
    return family == ProfileFamily::W ? "AISC Shapes Database v16.0" : "EN 10365:2017";
}

} // namespace femoop
