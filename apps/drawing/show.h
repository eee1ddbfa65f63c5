#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace drawing {

/// What a picture of a frame can show, besides the members, nodes and supports that it always shows.
enum class Show : std::uint8_t {
    Loads,
    Reactions,
    N,
    V, ///< in space both Vy and Vz
    M, ///< in space both My and Mz
    T,
    Vy,
    Vz,
    My,
    Mz,
    Deformed,
    Thrust,       ///< the line of thrust of a plane frame
    Influence,    ///< the influence line that the input has; no word of a list asks for it
    Truss,        ///< the truss worked out by hand that the input has; no word asks for it either
    ForcePolygon, ///< the funicular and its force polygon that the input has, likewise
    UnitLoad,     ///< the structure under the unit load of virtual work that the input has, likewise
    NodeNumbers,  ///< those that the input has, likewise
    Values,       ///< numbers beside loads, reactions and diagrams
    StepValues,   ///< numbers along diagrams at equal steps (DrawOptions::steps)
    NodeNames,
    MemberNames,
    Dimensions,      ///< of the whole structure, in chains around it
    DrawnDimensions, ///< lines that were drawn by hand
    LocalAxes,
    Counting, ///< of the degree of indeterminacy: the sum, and each of its terms where it comes from
    Legend,   ///< title, case, scales, signs, degree of indeterminacy
};
inline constexpr std::size_t n_shows = static_cast<std::size_t>(Show::Legend) + 1;

/// A set of things to show.
class ShowSet {
public:
    constexpr ShowSet() = default;
    constexpr ShowSet(std::initializer_list<Show> items)
    {
        for (const Show item : items) insert(item);
    }
    constexpr void insert(Show item) { bits_ |= bit(item); }
    constexpr void erase(Show item) { bits_ &= ~bit(item); }
    constexpr bool contains(Show item) const { return (bits_ & bit(item)) != 0; }
    friend constexpr ShowSet operator|(ShowSet a, ShowSet b)
    {
        a.bits_ |= b.bits_;
        return a;
    }
    friend constexpr ShowSet operator&(ShowSet a, ShowSet b)
    {
        a.bits_ &= b.bits_;
        return a;
    }
    friend constexpr ShowSet operator-(ShowSet a, ShowSet b)
    {
        a.bits_ &= ~b.bits_;
        return a;
    }
    friend constexpr bool operator==(ShowSet, ShowSet) = default;

private:
    static constexpr std::uint32_t bit(Show item) { return std::uint32_t{1} << static_cast<std::uint32_t>(item); }

    std::uint32_t bits_ = 0;
};

/// What `--show labels` means: numbers, names of nodes and members, drawn dimension lines, and the legend.
inline constexpr ShowSet labels{Show::Values, Show::NodeNames, Show::MemberNames, Show::DrawnDimensions, Show::Legend};
/// What is shown when nothing is asked for: `loads,reactions,labels`.
inline constexpr ShowSet shown_by_default = ShowSet{Show::Loads, Show::Reactions} | labels;

/// A word of `--show` and what it shows.
struct ShowWord {
    std::string_view word;
    ShowSet shows;
    std::string_view meaning; ///< in English, translatable
};
std::span<const ShowWord> show_text();

/// A list of things to show that has a word which is none of ours; the message lists those that there are.
class ShowError : public std::runtime_error {
public:
    explicit ShowError(std::string word);

    const std::string& word() const { return word_; } ///< that is none of ours

private:
    std::string word_;
};

/// Reads a list such as `loads,N,V,M,labels`, in upper or lower case; blanks around the words and empty words do not
/// count. \throws ShowError
ShowSet parse_show(std::string_view list);
/// The list that `parse_show` reads as this set.
std::string words_of(ShowSet set);

} // namespace drawing
