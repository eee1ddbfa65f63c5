#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/plane/model/plane_expected.h"

namespace plane {

/// What a picture of a plane model can show.
enum class PlateShow : std::uint8_t {
    Geometry, ///< curves, vertices, divisions; edges that dangle are marked
    Regions,  ///< filled by their entries; holes bare, faces that are left empty hatched
    Mesh,     ///< the elements' edges
    Loads,    ///< of the case that is shown
    Supports,
    Deformed,     ///< the body where its displacements take it, over its outline
    Principal,    ///< crosses of principal stresses
    Trajectories, ///< lines along the principal stresses, evenly spaced
    Vectors,      ///< displacements as arrows, evenly spaced
    Error,        ///< Zienkiewicz and Zhu's error of each element
    Reactions,    ///< resultants of the supports, and equilibrium in numbers
    Values,       ///< numbers beside loads and at extremes
    Names,        ///< of points, curves and regions
    Legend        ///< title, case, units, scales; of colours
};
inline constexpr std::size_t n_plate_shows = static_cast<std::size_t>(PlateShow::Legend) + 1;

/// A set of things to show.
class PlateShowSet {
public:
    constexpr PlateShowSet() = default;
    constexpr PlateShowSet(std::initializer_list<PlateShow> items)
    {
        for (const PlateShow item : items) insert(item);
    }
    constexpr void insert(PlateShow item) { bits_ |= bit(item); }
    constexpr void erase(PlateShow item) { bits_ &= ~bit(item); }
    constexpr bool contains(PlateShow item) const { return (bits_ & bit(item)) != 0; }
    constexpr bool meets(PlateShowSet other) const { return (bits_ & other.bits_) != 0; }
    friend constexpr PlateShowSet operator|(PlateShowSet a, PlateShowSet b)
    {
        a.bits_ |= b.bits_;
        return a;
    }
    friend constexpr bool operator==(PlateShowSet, PlateShowSet) = default;

private:
    static constexpr std::uint32_t bit(PlateShow item) { return std::uint32_t{1} << static_cast<std::uint32_t>(item); }

    std::uint32_t bits_ = 0;
};

enum class FieldStyle : std::uint8_t {
    Bands,   ///< filled between levels
    Contours ///< lines of equal value
};

/// A component that is drawn over the body.
struct FieldShow {
    femoop::plane::PlaneComponent component = femoop::plane::PlaneComponent::Mises;
    FieldStyle style = FieldStyle::Bands;

    friend bool operator==(const FieldShow&, const FieldShow&) = default;
};

/// Those that bands and contours can show: sx sy sz txy s1 s2 tmax mises tresca ex ey ez gxy ux uy.
const std::vector<femoop::plane::PlaneComponent>& shown_components();

/// All that `--show` asks for.
struct PlateShown {
    PlateShowSet set;
    std::vector<FieldShow> fields; ///< at most one of each style

    bool needs_results() const;
    bool needs_mesh() const; ///< results do too
    friend bool operator==(const PlateShown&, const PlateShown&) = default;
};

/// What is shown when nothing is asked for: `geometry,regions,loads,supports,labels`.
PlateShown plate_shown_by_default();

/// A word of `--show` and what it shows.
struct PlateShowWord {
    std::string_view word;
    PlateShowSet shows;
    std::string_view meaning; ///< in English, translatable
};
/// Besides these there are `contour:` and `bands:` with a component.
const std::vector<PlateShowWord>& plate_show_words();

/// What one word asks for, such as `mesh`, `labels` or `bands:sx`; nothing where it is none of ours.
std::optional<PlateShown> plate_shown(std::string_view word);
/// All words, for a message that names them.
std::vector<std::string> all_plate_words();
PlateShown operator|(PlateShown a, const PlateShown& b);

} // namespace plane
