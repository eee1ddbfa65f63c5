#include "femoop/methods/influence/train/train_library.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"

namespace femoop::influence {

namespace {

constexpr Units us{.length = LengthUnit::ft, .force = ForceUnit::kip};
constexpr Units si{.length = LengthUnit::m, .force = ForceUnit::kN};

constexpr std::array truck_axles{8.0, 32.0, 32.0};
constexpr std::array truck_spacings{14.0, 14.0};
constexpr LibraryTrain::Range truck_range{.spacing = 1, .least = 14.0, .most = 30.0};
constexpr std::array tandem_axles{25.0, 25.0};
constexpr std::array tandem_spacings{4.0};

// Twice an engine of one pilot axle, four drivers and four tender axles.
constexpr std::array cooper_axles{40.0, 80.0, 80.0, 80.0, 80.0, 52.0, 52.0, 52.0, 52.0,
                                  40.0, 80.0, 80.0, 80.0, 80.0, 52.0, 52.0, 52.0, 52.0};
constexpr std::array cooper_spacings{8.0, 5.0, 5.0, 5.0, 9.0, 5.0, 6.0, 5.0, 8.0,
                                     8.0, 5.0, 5.0, 5.0, 9.0, 5.0, 6.0, 5.0};

constexpr std::array lane_1_axles{300.0, 300.0}, lane_2_axles{200.0, 200.0}, lane_3_axles{100.0, 100.0};
constexpr std::array lm1_spacings{1.2};
constexpr double lane_width = 3.0; // [m]
constexpr std::array lm71_axles{250.0, 250.0, 250.0, 250.0};
constexpr std::array lm71_spacings{1.6, 1.6, 1.6};

constexpr std::array tb450_axles{150.0, 150.0, 150.0}; // of two wheels each
constexpr std::array tb450_spacings{1.5, 1.5};
constexpr double tb450_length = 6.0, tb450_width = 3.0, crowd = 5.0; // [m], [kN/m^2]

constexpr std::string_view aashto = "AASHTO Standard Specifications for Highway Bridges, 2002, 3.7.6";
constexpr std::string_view lrfd = translatable("AASHTO LRFD Bridge Design Specifications, 2020, 3.6.1.2 and 3.6.2");
constexpr std::string_view lm1 = translatable("EN 1991-2:2003, 4.3.2, adjustment factors 1");

// What of the standards' models is not in these trains.
constexpr std::string_view without_truck_effects = translatable(
    "Left out: the impact, which depends on the span (3.8), and the reduction for several lanes (3.12).");
constexpr std::string_view without_second_force = translatable(
    "Left out: the second single force for moments over inner supports (3.11.3), the impact (3.8), and the reduction "
    "for several lanes (3.12).");
constexpr std::string_view without_truck_train = translatable(
    "With 33 % on the axles. Left out: the pair of trucks over inner supports (3.6.1.3.1), and the factor for several "
    "lanes (3.6.1.1.2).");
constexpr std::string_view without_cars = translatable(
    "The two engines alone. Left out: the 8 kip/ft of the cars, which begin 5 ft behind the last axle and cannot be "
    "given on one side of the axles only; the alternate load of four axles; and the impact.");
constexpr std::string_view without_other_lanes = translatable(
    "One lane alone, dynamic effects included. Left out: the other lanes, what lies beside them, and the single axle "
    "of load model 2.");
constexpr std::string_view without_dynamic_factor = translatable(
    "Left out: the dynamic factor, and the heavy models SW/0 and SW/2.");
constexpr std::string_view without_impact = translatable(
    "The vehicle and the crowd before and behind it. Left out: the impact, which depends on the span, and the crowd "
    "beside the vehicle.");

constexpr LibraryTrain lm1_lane(std::string_view name, std::span<const double> axles, double pressure)
{
    return {.name = name,
            .source = lm1,
            .left_out = without_other_lanes,
            .units = si,
            .axles = axles,
            .spacings = lm1_spacings,
            .uniform = pressure * lane_width};
}

constexpr std::array library{
    LibraryTrain{.name = "HS20-44 truck",
                 .source = aashto,
                 .left_out = without_truck_effects,
                 .units = us,
                 .axles = truck_axles,
                 .spacings = truck_spacings,
                 .range = truck_range,
                 .both_directions = true},
    LibraryTrain{.name = "HS20-44 lane",
                 .source = aashto,
                 .left_out = without_second_force,
                 .units = us,
                 .uniform = 0.64,
                 .concentrated = LibraryTrain::Concentrated{.for_moments = 18.0, .for_others = 26.0}},
    LibraryTrain{.name = "HL-93 truck + lane",
                 .source = lrfd,
                 .left_out = without_truck_train,
                 .units = us,
                 .axles = truck_axles,
                 .spacings = truck_spacings,
                 .range = truck_range,
                 .impact = 1.33,
                 .uniform = 0.64,
                 .both_directions = true},
    LibraryTrain{.name = "HL-93 tandem + lane",
                 .source = lrfd,
                 .left_out = without_truck_train,
                 .units = us,
                 .axles = tandem_axles,
                 .spacings = tandem_spacings,
                 .impact = 1.33,
                 .uniform = 0.64},
    LibraryTrain{.name = "Cooper E80 engines",
                 .source = translatable("AREMA Manual for Railway Engineering, chapter 15, 1.3.3"),
                 .left_out = without_cars,
                 .units = us,
                 .axles = cooper_axles,
                 .spacings = cooper_spacings,
                 .both_directions = true},
    lm1_lane("LM1 lane 1", lane_1_axles, 9.0),
    lm1_lane("LM1 lane 2", lane_2_axles, 2.5),
    lm1_lane("LM1 lane 3", lane_3_axles, 2.5),
    LibraryTrain{.name = "LM71",
                 .source = translatable("EN 1991-2:2003, 6.3.2, classification factor 1"),
                 .left_out = without_dynamic_factor,
                 .units = si,
                 .axles = lm71_axles,
                 .spacings = lm71_spacings,
                 .uniform = 80.0,
                 .extent = UniformExtent::Outside,
                 .gap = 0.8},
    LibraryTrain{.name = "TB-450",
                 .source = "ABNT NBR 7188:2013, 5.1",
                 .left_out = without_impact,
                 .units = si,
                 .axles = tb450_axles,
                 .spacings = tb450_spacings,
                 .uniform = crowd * tb450_width,
                 .extent = UniformExtent::Outside,
                 .gap = (tb450_length - 3.0) / 2.0},
};

/// Numbers of an entry as quantities of a model.
class Writer {
public:
    Writer(const Units& from, const Units& to) : from_(from), to_(to) {}

    Quantity operator()(double value, Dimension dimension) const
    {
        if (from_ == to_) return value;
        std::string text = quantity_text(value, dimension, from_);
        const auto read = parse_quantity(text, dimension, to_);
        return {std::get<double>(read), std::move(text)};
    }

    std::vector<Quantity> operator()(std::span<const double> values, Dimension dimension) const
    {
        std::vector<Quantity> quantities;
        for (const double value : values) quantities.push_back((*this)(value, dimension));
        return quantities;
    }

private:
    Units from_, to_;
};

} // namespace

std::span<const LibraryTrain> train_library() { return library; }

Train train_from(const LibraryTrain& entry, const Units& units, LoadPathReference path)
{
    const Writer written(entry.units, units);
    Train train{.id = std::string(entry.name), .path = std::move(path)};
    train.axles = written(entry.axles, dimension::force);
    train.spacings = written(entry.spacings, dimension::length);
    if (entry.range)
        train.spacing_ranges.push_back({entry.range->spacing, written(entry.range->least, dimension::length),
                                        written(entry.range->most, dimension::length)});
    train.both_directions = entry.both_directions;
    train.impact = entry.impact;
    if (entry.uniform != 0.0) train.uniform = written(entry.uniform, dimension::force_per_length);
    train.uniform_extent = entry.extent;
    if (entry.gap != 0.0) train.gap = written(entry.gap, dimension::length);
    if (entry.concentrated)
        train.concentrated.push_back({written(entry.concentrated->for_moments, dimension::force),
                                      written(entry.concentrated->for_others, dimension::force)});
    return train;
}

const LibraryTrain* library_entry(const Train& train, const Units& units)
{
    const auto found = std::ranges::find_if(library, [&](const LibraryTrain& entry) {
        Train taken = train_from(entry, units, train.path);
        taken.id = train.id;
        return taken == train;
    });
    return found != library.end() ? &*found : nullptr;
}

} // namespace femoop::influence
