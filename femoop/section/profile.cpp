#include "femoop/section/profile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "femoop/model/check/suggestion.h"
#include "femoop/section/area_sums.h"

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

constexpr EuropeanRow w_metric_rows[] = {
#include "femoop/section/w_metric.inc"
};
constexpr EuropeanRow hp_metric_rows[] = {
#include "femoop/section/hp_metric.inc"
};

struct AngleRow {
    std::string_view name;
    double mass, h, b, t, r;
};
constexpr AngleRow angle_rows[] = {
#include "femoop/section/angle.inc"
};

struct HollowRow {
    std::string_view name;
    double h, b, t;
};
constexpr HollowRow chs_rows[] = {
#include "femoop/section/chs.inc"
};
constexpr HollowRow shs_rows[] = {
#include "femoop/section/shs.inc"
};
constexpr HollowRow rhs_rows[] = {
#include "femoop/section/rhs.inc"
};

constexpr double mm = 10.0;     // in a cm
constexpr double steel = 0.785; // kg/m of a cm^2
using std::numbers::pi;
constexpr double square(double x) { return x * x; }
constexpr double cube(double x) { return x * x * x; }

constexpr ProfileFamily family_of(std::string_view name)
{
    if (name.starts_with("W")) return ProfileFamily::WMetric;
    if (name.starts_with("HP")) return ProfileFamily::HPMetric;
    if (name.starts_with("IPE")) return ProfileFamily::IPE;
    if (name.starts_with("HEA")) return ProfileFamily::HEA;
    if (name.starts_with("HEB")) return ProfileFamily::HEB;
    return name.starts_with("HEM") ? ProfileFamily::HEM : ProfileFamily::UPN;
}

constexpr Profile profile(const EuropeanRow& row)
{
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
            .yc = row.h / (2.0 * mm),
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
            .yc = row.d / 2.0,
            .mass = row.weight * kg_per_m};
}

constexpr double torsion_of_angle(double h, double b, double t, double r)
{
    const double D = 2.0 * (3.0 * r + 2.0 * t - std::numbers::sqrt2 * (2.0 * r + t)), alpha = 0.0768 + 0.0479 * r / t;
    return (h + b - t) * cube(t) / 3.0 - 0.21 * square(square(t)) + alpha * square(square(D));
}

constexpr Profile profile(const AngleRow& row)
{
    const double h = row.h / mm, b = row.b / mm, t = row.t / mm, r = row.r / mm;
    AreaSums sums;
    sums.add_rectangle({0.0, h}, {0.0, t});
    sums.add_rectangle({0.0, t}, {t, b});
    sums.add_rounded_corner({t, t, 1.0, 1.0}, r);
    sums.add_rounded_corner({h, t, -1.0, -1.0}, 0.5 * r, -1.0);
    sums.add_rounded_corner({t, b, -1.0, -1.0}, 0.5 * r, -1.0);
    const double yc = sums.centroid_y(), zc = sums.centroid_z();
    return {.name = row.name,
            .family = ProfileFamily::L,
            .unit = LengthUnit::cm,
            .h = h,
            .bf = b,
            .tf = t,
            .tw = t,
            .r = r,
            .A = sums.A,
            .Iz = sums.Iz(),
            .Wz = sums.Iz() / (h - yc),
            .Iy = sums.Iy(),
            .Wy = sums.Iy() / (b - zc),
            .J = torsion_of_angle(h, b, t, r),
            .zc = zc,
            .yc = yc,
            .Iyz = sums.Iyz(),
            .mass = row.mass};
}

constexpr Profile ring(const HollowRow& row)
{
    const double d = row.h / mm, t = row.t / mm, di = d - 2.0 * t;
    const double A = pi * t * (d - t), I = A / 16.0 * (square(d) + square(di)), W = 2.0 * I / d;
    const double Z = (cube(d) - cube(di)) / 6.0;
    return {.name = row.name,
            .family = ProfileFamily::CHS,
            .unit = LengthUnit::cm,
            .h = d,
            .bf = d,
            .tf = t,
            .tw = t,
            .A = A,
            .Iz = I,
            .Wz = W,
            .Zz = Z,
            .Iy = I,
            .Wy = W,
            .Zy = Z,
            .J = 2.0 * I,
            .zc = 0.5 * d,
            .yc = 0.5 * d,
            .mass = steel * A};
}

/// The quarter of a rectangle with one rounded corner, from the rectangle's centre.
constexpr void add_quarter(AreaSums& sums, double h, double b, double r, double times)
{
    sums.add_rectangle({0.0, 0.5 * h}, {0.0, 0.5 * b}, times);
    sums.add_rounded_corner({0.5 * h, 0.5 * b, -1.0, -1.0}, r, -times);
}

constexpr double torsion_of_hollow(double h, double b, double t)
{
    const double rc = 1.25 * t; // of the mid-line's corners
    const double wall = 2.0 * (h + b - 2.0 * t) - 2.0 * rc * (4.0 - pi),
                 Am = (h - t) * (b - t) - square(rc) * (4.0 - pi);
    return cube(t) * wall / 3.0 + 4.0 * square(Am) * t / wall;
}

constexpr Profile hollow(const HollowRow& row, ProfileFamily family)
{
    const double h = row.h / mm, b = row.b / mm, t = row.t / mm;
    AreaSums quarter;
    add_quarter(quarter, h, b, 1.5 * t, 1.0);
    add_quarter(quarter, h - 2.0 * t, b - 2.0 * t, t, -1.0);
    const double Iz = 4.0 * quarter.yy, Iy = 4.0 * quarter.zz;
    return {.name = row.name,
            .family = family,
            .unit = LengthUnit::cm,
            .h = h,
            .bf = b,
            .tf = t,
            .tw = t,
            .r = 1.5 * t,
            .A = 4.0 * quarter.A,
            .Iz = Iz,
            .Wz = 2.0 * Iz / h,
            .Zz = 4.0 * quarter.y,
            .Iy = Iy,
            .Wy = 2.0 * Iy / b,
            .Zy = 4.0 * quarter.z,
            .J = torsion_of_hollow(h, b, t),
            .zc = 0.5 * b,
            .yc = 0.5 * h,
            .mass = steel * 4.0 * quarter.A};
}

constexpr std::size_t n_profiles = std::size(european_rows) + std::size(upn_rows) + std::size(american_rows) +
                                   std::size(w_metric_rows) + std::size(hp_metric_rows) + std::size(angle_rows) +
                                   std::size(chs_rows) + std::size(shs_rows) + std::size(rhs_rows);

constexpr auto all_profiles = [] {
    std::array<Profile, n_profiles> all;
    auto* next = all.data();
    for (const EuropeanRow& row : european_rows) *next++ = profile(row);
    for (const EuropeanRow& row : upn_rows) *next++ = profile(row);
    for (const AmericanRow& row : american_rows) *next++ = profile(row);
    for (const EuropeanRow& row : w_metric_rows) *next++ = profile(row);
    for (const EuropeanRow& row : hp_metric_rows) *next++ = profile(row);
    for (const AngleRow& row : angle_rows) *next++ = profile(row);
    for (const HollowRow& row : chs_rows) *next++ = ring(row);
    for (const HollowRow& row : shs_rows) *next++ = hollow(row, ProfileFamily::SHS);
    for (const HollowRow& row : rhs_rows) *next++ = hollow(row, ProfileFamily::RHS);
    return all;
}();

constexpr std::array families{ProfileFamily::IPE, ProfileFamily::HEA, ProfileFamily::HEB,     ProfileFamily::HEM,
                              ProfileFamily::UPN, ProfileFamily::W,   ProfileFamily::WMetric, ProfileFamily::HPMetric,
                              ProfileFamily::L,   ProfileFamily::CHS, ProfileFamily::SHS,     ProfileFamily::RHS};
constexpr std::array<std::string_view, families.size()> family_names{"IPE",  "HEA", "HEB", "HEM", "UPN", "W",
                                                                     "W BR", "HP",  "L",   "CHS", "SHS", "RHS"};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Without blanks and what stands in brackets, in capitals, with a decimal point.
std::string letters(std::string_view name)
{
    constexpr std::string_view times = "\u00d7";
    std::string text;
    for (std::size_t i = 0; i < name.size() && name[i] != '('; ++i) {
        if (name.substr(i).starts_with(times)) {
            text += 'X';
            i += times.size() - 1;
        } else if (name[i] != ' ' && name[i] != '\t') {
            text += name[i] == ',' ? '.' : upper(name[i]);
        }
    }
    return text;
}

/// "W150X13.0" becomes "W150X13".
void drop_zero_decimals(std::string& text)
{
    for (std::size_t at = text.find(".0"); at != std::string::npos; at = text.find(".0", at + 1))
        if (at + 2 == text.size() || text[at + 2] == 'X') text.erase(at, 2);
}

/// "HE300A" becomes "HEA300".
void move_series_letter(std::string& text)
{
    if (text.starts_with("HE") && text.size() > 3 && is_digit(text[2]))
        std::rotate(text.begin() + 2, text.end() - 1, text.end());
}

/// "L100X10" becomes "L100X100X10".
void repeat_only_width(std::string& text)
{
    const bool has_equal_widths = text.starts_with("SHS") || (text.starts_with("L") && text.size() > 1);
    if (!has_equal_widths || std::ranges::count(text, 'X') != 1) return;
    const std::size_t begin = text.find_first_of("0123456789"), times = text.find('X');
    if (begin < times) text.insert(times, 'X' + text.substr(begin, times - begin));
}

/// A name as the tables write it.
std::string key(std::string_view name)
{
    std::string text = letters(name);
    drop_zero_decimals(text);
    move_series_letter(text);
    repeat_only_width(text);
    return text;
}

} // namespace

const Profile* find_profile(std::string_view name)
{
    const std::string wanted = key(name);
    const auto found = std::ranges::find(all_profiles, std::string_view(wanted), &Profile::name);
    return found == all_profiles.end() ? nullptr : &*found;
}

namespace {

std::string_view letters_before_sizes(std::string_view name)
{
    return name.substr(0, std::min(name.find_first_of("0123456789"), name.size()));
}

/// "L150X90X10": 150, 90, 10.
std::vector<double> sizes(std::string_view name)
{
    std::vector<double> found;
    const char* at = name.data() + letters_before_sizes(name).size();
    const char* const end = name.data() + name.size();
    while (at < end) {
        double size = 0.0;
        const auto [next, error] = std::from_chars(at, end, size);
        if (error != std::errc() || !(size > 0.0)) return {};
        found.push_back(size);
        at = next < end ? next + 1 : end; // behind the X
    }
    return found;
}

/// How far apart the sizes of two names are, each by its ratio; nothing where one has more of them.
std::optional<double> apart(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.empty() || a.size() != b.size()) return std::nullopt;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(std::log(a[i] / b[i]));
    return sum;
}

std::vector<std::string_view> of_about_the_sizes(std::string_view wanted, const std::vector<std::string_view>& names,
                                                 std::size_t most)
{
    constexpr double farthest = 0.5; // one size is half as large again and a little more
    const std::vector<double> sizes_wanted = sizes(wanted);
    std::vector<std::pair<double, std::string_view>> near;
    for (const std::string_view name : names)
        if (const auto distance = apart(sizes_wanted, sizes(name)); distance && *distance <= farthest)
            near.emplace_back(*distance, name);
    std::ranges::stable_sort(near, {}, &std::pair<double, std::string_view>::first);
    std::vector<std::string_view> found;
    for (const auto& [distance, name] : near)
        if (found.size() < most) found.push_back(name);
    return found;
}

std::vector<std::string_view> nearest_ones(const std::string& wanted, std::vector<std::string_view> names,
                                           std::size_t most)
{
    std::vector<std::string_view> found;
    while (found.size() < most) {
        const auto near = nearest(wanted, names);
        if (!near) break;
        const auto place = std::ranges::find(names, std::string_view(*near));
        found.push_back(*place);
        names.erase(place);
    }
    return found;
}

} // namespace

std::vector<std::string_view> near_profiles(std::string_view name, std::size_t most)
{
    const std::string wanted = key(name);
    std::vector<std::string_view> of_kind, all;
    for (const Profile& profile : all_profiles) {
        all.push_back(profile.name);
        if (letters_before_sizes(profile.name) == letters_before_sizes(wanted)) of_kind.push_back(profile.name);
    }
    std::vector<std::string_view> found = of_about_the_sizes(wanted, of_kind, most);
    if (found.empty()) found = nearest_ones(wanted, std::move(of_kind), most);
    return found.empty() ? nearest_ones(wanted, std::move(all), most) : found;
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
    switch (family) {
    case ProfileFamily::W: return "AISC Shapes Database v16.0";
    case ProfileFamily::WMetric:
    case ProfileFamily::HPMetric: return "ABNT NBR 15980:2020";
    case ProfileFamily::L: return "EN 10056-1:2017";
    case ProfileFamily::CHS:
    case ProfileFamily::SHS:
    case ProfileFamily::RHS: return "EN 10210-2:2019";
    case ProfileFamily::IPE:
    case ProfileFamily::HEA:
    case ProfileFamily::HEB:
    case ProfileFamily::HEM:
    case ProfileFamily::UPN: break;
    }
    return "EN 10365:2017";
}

} // namespace femoop
