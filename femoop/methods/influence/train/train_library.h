#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "femoop/model/moving_load.h"
#include "femoop/model/quantity/units.h"

namespace femoop::influence {

/// A train that a standard prescribes, as numbers in the standard's own units: what of it acts on one line.
///
/// Assumes  nominal values: no load factor, and of dynamic factors those alone that are one number for every span
struct LibraryTrain {
    /// The distance behind an axle that may have any value of a range.
    struct Range {
        std::size_t spacing; ///< counted from 0
        double least, most;
    };
    /// A force that stands once, where it is worst.
    struct Concentrated {
        double for_moments, for_others;
    };

    std::string_view name;     ///< HS20-44 truck: what it is called in every language
    std::string_view source;   ///< standard and clause; what of it is a word can be translated
    std::string_view left_out; ///< of the standard's loads, in a sentence that can be translated
    Units units;
    std::span<const double> axles{}, spacings{}; ///< from the leading axle
    std::optional<Range> range{};
    double impact = 1.0;  ///< on the axles alone
    double uniform = 0.0; ///< force per length of path; 0: none
    UniformExtent extent = UniformExtent::Adverse;
    double gap = 0.0; ///< of UniformExtent::Outside
    std::optional<Concentrated> concentrated{};
    bool both_directions = false; ///< it differs when it runs back
};

/// Road and railway traffic, standard by standard.
///
/// Source  [AashtoStandard2002, 3.7], [AashtoLrfd2020, 3.6.1.2], [AremaManual, ch. 15], [EN1991-2, 4.3.2 and 6.3.2],
///         [NBR7188, 5.1]
std::span<const LibraryTrain> train_library();

/// It as a train of a model of these units, along a path of it. Forces and lengths that the standard counts in other
/// units keep them: "32 kip".
Train train_from(const LibraryTrain& entry, const Units& units, LoadPathReference path);

/// The entry that a train of a model of these units was taken from, whatever it is called and wherever it runs; null
/// where something of it was changed since.
const LibraryTrain* library_entry(const Train& train, const Units& units);

} // namespace femoop::influence
