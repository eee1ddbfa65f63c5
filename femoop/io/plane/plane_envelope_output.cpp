#include "femoop/io/plane/plane_envelope_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/plane/cut_sentences.h"
#include "femoop/io/plane/mesh_json.h"
#include "femoop/io/results/range_columns.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "femoop/plane/result/plane_envelope.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"
#include "femoop/tabular/separated.h"
#include "femoop/tabular/table.h"

namespace femoop::plane {

namespace {

enum class EnvelopePart : std::uint8_t { Point, Curve, Region, Place, Cut };

/// A value of a part: its place and region where it has one.
struct EnvelopeRow {
    EnvelopePart part;
    std::string id;
    std::optional<Eigen::Vector2d> at{};
    std::string region{}; ///< of stresses
    std::string_view component;
    enum class Kind : std::uint8_t { Displacement, Force, Moment, Stress } kind;
    GoverningRange range;
    std::optional<std::array<Eigen::Vector2d, 2>> places{}; ///< of the largest and of the smallest; the ends of a cut
};

struct NamedForce {
    std::string_view name;
    EnvelopeRow::Kind kind;
    double CutForces::*of;
};
constexpr std::array cut_forces_named{NamedForce{"N", EnvelopeRow::Kind::Force, &CutForces::N},
                                      NamedForce{"V", EnvelopeRow::Kind::Force, &CutForces::V},
                                      NamedForce{"M", EnvelopeRow::Kind::Moment, &CutForces::M}};

/// Lists everything that an envelope has, part by part.
class EnvelopeRows {
public:
    /// \param has_point_stresses  a large mesh has many
    EnvelopeRows(const PlaneResults& results, const PlaneSelection& selection, bool has_point_stresses = true)
        : results_(results),
          model_(results.model()),
          selection_(selection),
          envelope_(results, selection.cases),
          regions_of_(has_point_stresses ? regions_of_points(model_)
                                         : std::vector<std::vector<RegionId>>(model_.points.size()))
    {}

    std::vector<EnvelopeRow> all()
    {
        if (selection_.points && !selection_.is_full)
            for (const ShownPoint& point : *selection_.points) add_point(point);
        else
            for (std::size_t i = 0; i < model_.points.size(); ++i)
                add_node(NodeId(i), model_.points[i].id, position(model_.points[i]));
        for (std::size_t c = 0; c < model_.curves.size(); ++c)
            if (model_.curves[c].support) add_curve(c);
        const std::vector<RegionSize> sizes = region_sizes(model_);
        for (std::size_t r = 0; r < model_.regions.size(); ++r)
            if (sizes[r].n_elements > 0) add_region(RegionId(r));
        for (const Eigen::Vector2d& at : selection_.probes)
            add_state(EnvelopePart::Place, {}, at, results_.locator().find(at));
        for (std::size_t i = 0; i < selection_.cuts.size(); ++i) add_cut(i);
        return std::move(rows_);
    }

private:
    void add_point(const ShownPoint& point)
    {
        if (point.node) add_node(*point.node, point.id, point.at);
        else add_state(EnvelopePart::Point, point.id, point.at, results_.locator().find(point.at));
    }

    template <class Of> void add_pair(EnvelopeRow row, std::array<std::string_view, 2> names, const Of& of)
    {
        for (const int i : {0, 1}) {
            row.component = names[static_cast<std::size_t>(i)];
            row.range = envelope_.range([&](const PlaneCase& result) { return of(result)[i]; });
            rows_.push_back(row);
        }
    }

    void add_node(NodeId node, const std::string& id, const Eigen::Vector2d& at)
    {
        EnvelopeRow row{.part = EnvelopePart::Point, .id = id, .at = at, .kind = EnvelopeRow::Kind::Displacement};
        add_pair(row, {"ux", "uy"}, [&](const PlaneCase& result) { return result.displacement(node); });
        row.kind = EnvelopeRow::Kind::Force;
        if (envelope_.cases().front().is_supported(node))
            add_pair(row, {"fx", "fy"}, [&](const PlaneCase& result) { return result.reaction(node); });
        for (const RegionId region : regions_of_[node.index])
            add_stress(row, region, [&](const PlaneCase& result) { return result.smoothed_stress(node, region); });
    }

    void add_state(EnvelopePart part, const std::string& id, const Eigen::Vector2d& at,
                   const std::vector<Location>& places)
    {
        const EnvelopeRow row{.part = part, .id = id, .at = at, .kind = EnvelopeRow::Kind::Displacement};
        add_pair(row, {"ux", "uy"}, [&](const PlaneCase& result) { return result.displacement(places.front()); });
        std::vector<RegionId> seen;
        for (const Location& place : places) {
            const RegionId region = model_[place.element].region;
            if (std::ranges::find(seen, region) != seen.end()) continue;
            seen.push_back(region);
            add_stress(row, region, [&](const PlaneCase& result) { return result.smoothed_stress(place); });
        }
    }

    template <class Stress> void add_stress(EnvelopeRow row, RegionId region, const Stress& stress)
    {
        row.kind = EnvelopeRow::Kind::Stress;
        row.region = model_[region].id;
        for (const PlaneComponent which : shown_extremes) {
            row.component = plane::name(which);
            row.range = envelope_.range([&](const PlaneCase& result) {
                return component(stress(result), which, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
            });
            rows_.push_back(row);
        }
    }

    void add_curve(std::size_t c)
    {
        const std::vector<NodeId> nodes = nodes_along(envelope_.cases().front().structure().curves().edges[c]);
        EnvelopeRow row{.part = EnvelopePart::Curve, .id = model_.curves[c].id, .kind = EnvelopeRow::Kind::Force};
        add_pair(row, {"fx", "fy"}, [&](const PlaneCase& result) { return result.reaction(nodes); });
        if (model_.analysis == StressState::Axisymmetric) return; // around the axis moments cancel
        row.component = "mz";
        row.kind = EnvelopeRow::Kind::Moment;
        row.range = envelope_.range(
            [&](const PlaneCase& result) { return result.reaction_moment(nodes, Eigen::Vector2d::Zero()); });
        rows_.push_back(row);
    }

    void add_region(RegionId region)
    {
        for (const PlaneComponent which : shown_extremes) {
            const GoverningPlaces found = envelope_.extremes(region, which);
            rows_.push_back({.part = EnvelopePart::Region,
                             .id = model_[region].id,
                             .region = model_[region].id,
                             .component = plane::name(which),
                             .kind = EnvelopeRow::Kind::Stress,
                             .range = {{found.max.value, found.max.load_case}, {found.min.value, found.min.load_case}},
                             .places = std::array{found.max.at, found.min.at}});
        }
    }

    void add_cut(std::size_t i)
    {
        const Cut& cut = selection_.cuts[i];
        std::vector<CutForces> forces;
        for (const PlaneCase& result : envelope_.cases()) forces.push_back(result.forces(cut));
        for (const NamedForce& named : cut_forces_named) {
            const GoverningRange range = governing_range(envelope_.ids(),
                                                         [&](std::size_t c) { return forces[c].*named.of; });
            rows_.push_back({.part = EnvelopePart::Cut,
                             .id = std::to_string(i + 1),
                             .component = named.name,
                             .kind = named.kind,
                             .range = range,
                             .places = std::array{cut.start, cut.end}});
        }
    }

    const PlaneResults& results_;
    const PlaneModel& model_;
    const PlaneSelection& selection_;
    PlaneEnvelope envelope_;
    std::vector<std::vector<RegionId>> regions_of_;
    std::vector<EnvelopeRow> rows_;
};

/// The largest number of each kind, beside which rounding is nothing.
class EnvelopeSizes {
public:
    explicit EnvelopeSizes(const std::vector<EnvelopeRow>& rows)
    {
        for (const EnvelopeRow& row : rows)
            for (const double value : {row.range.max.value, row.range.min.value})
                of(row.kind) = std::max(of(row.kind), std::abs(value));
    }
    double clean(const EnvelopeRow& row, double value) const
    {
        return without_rounding(value, sizes_[static_cast<std::size_t>(row.kind)]);
    }

private:
    double& of(EnvelopeRow::Kind kind) { return sizes_[static_cast<std::size_t>(kind)]; }
    std::array<double, 4> sizes_{};
};

// --- JSON ---

void write_governing(JsonWriter& json, const PlaneModel& model, std::string_view key, const Governing& end,
                     const Eigen::Vector2d* at)
{
    json.key(key).begin_object();
    if (at != nullptr) json.key("at").begin_array().value(at->x()).value(at->y()).end();
    json.member("value", end.value).member("case", model.case_name(end.load_case)).end();
}

void write_row(JsonWriter& json, const PlaneModel& model, const EnvelopeRow& row)
{
    json.key(row.component).begin_object();
    const auto* const places = row.part == EnvelopePart::Region ? &*row.places : nullptr;
    write_governing(json, model, "max", row.range.max, places != nullptr ? &(*places)[0] : nullptr);
    write_governing(json, model, "min", row.range.min, places != nullptr ? &(*places)[1] : nullptr);
    json.end();
}

/// Rows of one part that follow one another and are grouped under one key: "u", "reaction", "stress", "extremes".
class PartWriter {
public:
    PartWriter(JsonWriter& json, const PlaneModel& model, const std::vector<EnvelopeRow>& rows)
        : json_(json), model_(model), rows_(rows)
    {}

    void write(EnvelopePart part, std::string_view key)
    {
        const bool is_list = part == EnvelopePart::Place || part == EnvelopePart::Cut;
        if (is_list && std::ranges::find(rows_, part, &EnvelopeRow::part) == rows_.end()) return;
        json_.key(key);
        if (is_list) json_.begin_array(JsonWriter::Layout::Block);
        else json_.begin_object(JsonWriter::Layout::Block);
        for (std::size_t i = 0; i < rows_.size();) {
            const std::size_t first = i;
            for (++i; i < rows_.size() && is_same(first, i);) ++i;
            if (rows_[first].part == part) write_one(first, i, is_list);
        }
        json_.end();
    }

private:
    bool is_same(std::size_t a, std::size_t b) const
    {
        return rows_[a].part == rows_[b].part && rows_[a].id == rows_[b].id && rows_[a].at == rows_[b].at;
    }

    void write_one(std::size_t first, std::size_t end, bool is_list)
    {
        const EnvelopeRow& head = rows_[first];
        if (!is_list) json_.key(head.id);
        json_.begin_object(JsonWriter::Layout::Block);
        if (is_list && head.at) json_.key("at").begin_array().value(head.at->x()).value(head.at->y()).end();
        if (head.part == EnvelopePart::Cut) {
            json_.key("cut").begin_array();
            for (const Eigen::Vector2d& end_of_cut : *head.places)
                json_.begin_array().value(end_of_cut.x()).value(end_of_cut.y()).end();
            json_.end();
            for (std::size_t i = first; i < end; ++i) write_row(json_, model_, rows_[i]);
        } else write_groups(first, end);
        json_.end();
    }

    void write_groups(std::size_t first, std::size_t end)
    {
        for (std::size_t i = first; i < end;) {
            const std::string_view key = group_of(rows_[i]);
            json_.key(key).begin_object(JsonWriter::Layout::Block);
            while (i < end && group_of(rows_[i]) == key) {
                if (key != "stress") {
                    write_row(json_, model_, rows_[i++]);
                    continue;
                }
                const std::string& region = rows_[i].region;
                json_.key(region).begin_object(JsonWriter::Layout::Block);
                for (; i < end && group_of(rows_[i]) == key && rows_[i].region == region; ++i)
                    write_row(json_, model_, rows_[i]);
                json_.end();
            }
            json_.end();
        }
    }
    static std::string_view group_of(const EnvelopeRow& row)
    {
        if (row.part == EnvelopePart::Region) return "extremes";
        if (row.kind == EnvelopeRow::Kind::Displacement) return "u";
        return row.kind == EnvelopeRow::Kind::Stress ? "stress" : "reaction";
    }

    JsonWriter& json_;
    const PlaneModel& model_;
    const std::vector<EnvelopeRow>& rows_;
};

// --- tables ---

const PrintedUnit& unit_of(EnvelopeRow::Kind kind, const ResultUnits& units)
{
    switch (kind) {
    case EnvelopeRow::Kind::Displacement: return units.displacement;
    case EnvelopeRow::Kind::Force: return units.force;
    case EnvelopeRow::Kind::Moment: return units.moment;
    case EnvelopeRow::Kind::Stress: break;
    }
    return units.stress;
}

class EnvelopeText {
public:
    EnvelopeText(const PlaneModel& model, const std::vector<EnvelopeRow>& rows, const ResultUnits& units,
                 const Translator& tr)
        : model_(model), rows_(rows), sizes_(rows), units_(units), tr_(tr)
    {
        for (const EnvelopeRow& row : rows) {
            if (row.part != EnvelopePart::Point || row.kind != EnvelopeRow::Kind::Displacement) continue;
            double& most = row.component == "ux" ? most_ux_ : most_uy_;
            most = std::max(most, size_of(row));
            n_points_ += row.component == "ux" ? 1 : 0;
        }
        for (const PlanePoint& point : model.points)
            if (point.support) supported_.insert(point.id);
    }

    std::string text() const
    {
        using Kind = EnvelopeRow::Kind;
        std::string text = table(tr_("Displacements of the points"), {tr_("point")}, [&](const EnvelopeRow& row) {
            return row.part == EnvelopePart::Point && row.kind == Kind::Displacement && is_shown(row);
        });
        text += table(tr_("Reactions of the supports on the body"), {""}, [&](const EnvelopeRow& row) {
            if (row.part == EnvelopePart::Point) return row.kind == Kind::Force && supported_.contains(row.id);
            return row.part == EnvelopePart::Curve;
        });
        text += table(tr_("Extreme stresses of the regions (smoothed, tension positive)"), {tr_("region")},
                      [](const EnvelopeRow& row) {
                          return row.part == EnvelopePart::Region && row.component != "sz" && row.component != "s1" &&
                                 row.component != "s2";
                      });
        text += table(tr_("At the places asked for"), {""},
                      [](const EnvelopeRow& row) { return row.part == EnvelopePart::Place; });
        return text + table(tr_("On the cuts (N positive in tension; V = dM/dx')"), {""},
                            [](const EnvelopeRow& row) { return row.part == EnvelopePart::Cut; });
    }

private:
    static double size_of(const EnvelopeRow& row)
    {
        return std::max(std::abs(row.range.max.value), std::abs(row.range.min.value));
    }
    /// Of a mesh of many points those alone that some case moves most.
    bool is_shown(const EnvelopeRow& row) const
    {
        constexpr std::size_t most_shown = 60;
        return n_points_ <= most_shown || size_of(row) >= (row.component == "ux" ? most_ux_ : most_uy_);
    }

    std::string name_of(const EnvelopeRow& row) const
    {
        const auto shown = [&](double place) { return number_of(place * units_.length.factor); };
        switch (row.part) {
        case EnvelopePart::Curve: return fill(tr_("curve {0}"), {row.id});
        case EnvelopePart::Cut: return fill(tr_("cut {0}"), {row.id});
        case EnvelopePart::Place: return "(" + shown(row.at->x()) + ", " + shown(row.at->y()) + ") " + row.region;
        case EnvelopePart::Point:
            return row.kind == EnvelopeRow::Kind::Force ? fill(tr_("point {0}"), {row.id}) : row.id;
        case EnvelopePart::Region: break;
        }
        return row.id;
    }
    std::string number_of(double value) const { return localized(number_text(to_six_digits(value)), tr_); }

    template <class Wanted> std::string table(const std::string& title, std::string what, const Wanted& is_wanted) const
    {
        tabular::Table table({std::move(what), "", tr_("largest"), tr_("case"), tr_("smallest"), tr_("case")});
        std::string last;
        for (const EnvelopeRow& row : rows_) {
            if (!is_wanted(row)) continue;
            const PrintedUnit& unit = unit_of(row.kind, units_);
            std::string name = name_of(row);
            table.add_row(
                {name == last ? std::string() : name, tabular::Column(std::string(row.component), unit.name).label(),
                 sizes_.clean(row, row.range.max.value) * unit.factor, model_.case_name(row.range.max.load_case),
                 sizes_.clean(row, row.range.min.value) * unit.factor, model_.case_name(row.range.min.load_case)},
                static_cast<std::size_t>(row.kind));
            last = std::move(name);
        }
        return table.is_empty() ? std::string()
                                : "\n" + title + "\n" + tabular::plain_text(table, {2, decimal_mark(tr_)});
    }

    const PlaneModel& model_;
    const std::vector<EnvelopeRow>& rows_;
    EnvelopeSizes sizes_;
    const ResultUnits& units_;
    const Translator& tr_;
    std::size_t n_points_ = 0;
    double most_ux_ = 0.0, most_uy_ = 0.0;
    std::set<std::string_view> supported_; ///< points, by supports of their own
};

std::string_view part_name(EnvelopePart part)
{
    switch (part) {
    case EnvelopePart::Point: return "point";
    case EnvelopePart::Curve: return "curve";
    case EnvelopePart::Region: return "region";
    case EnvelopePart::Place: return "place";
    case EnvelopePart::Cut: break;
    }
    return "cut";
}

} // namespace

std::string plane_envelope_json(const PlaneResults& results, const PlaneSelection& selection)
{
    const PlaneModel& model = results.model();
    const std::vector<EnvelopeRow> rows = EnvelopeRows(results, selection).all();
    JsonWriter json;
    begin_output(json, model.units);
    json.member("analysis", name(model.analysis));
    write_mesh(json, model, selection.is_full);
    json.key("envelope").begin_object(JsonWriter::Layout::Block);
    json.key("cases").begin_array();
    for (const CaseId id : selection.cases) json.value(model.case_name(id));
    json.end();
    PartWriter writer(json, model, rows);
    writer.write(EnvelopePart::Point, "points");
    writer.write(EnvelopePart::Curve, "curves");
    writer.write(EnvelopePart::Region, "regions");
    writer.write(EnvelopePart::Place, "probes");
    writer.write(EnvelopePart::Cut, "cuts");
    json.end().end();
    return json.take();
}

std::string plane_envelope_text(const PlaneResults& results, const PlaneSelection& selection, const ResultUnits& units,
                                const Translator& tr)
{
    const PlaneModel& model = results.model();
    std::string names;
    for (const CaseId id : selection.cases) names += (names.empty() ? "" : ", ") + model.case_name(id);
    const std::string title = fill(tr("Envelope of {0}"), {names});
    const std::vector<EnvelopeRow> rows = EnvelopeRows(results, selection, false).all();
    std::string text = "\n" + title + "\n" + std::string(tabular::shown_width(title), '=') + "\n" +
                       EnvelopeText(model, rows, units, tr).text();
    for (const CaseId id : selection.cases)
        for (const std::string& sentence : cut_sentences(results, results[id], selection.cuts, units, tr))
            text += "  " + model.case_name(id) + ": " + sentence + "\n";
    return text;
}

std::vector<CsvFile> plane_envelope_csv(const PlaneResults& results, const PlaneSelection& selection)
{
    const PlaneModel& model = results.model();
    PlaneSelection of_all = selection;
    of_all.points.reset();
    const std::vector<EnvelopeRow> rows = EnvelopeRows(results, of_all).all();
    const EnvelopeSizes sizes(rows);
    const ResultUnits units = result_units(model.units);
    const std::string length = unit_text(dimension::length, model.units);
    tabular::SeparatedText csv;
    csv << "part"
        << "id" << tabular::Column("x", length).label() << tabular::Column("y", length).label() << "region"
        << "component"
        << "unit";
    add_range_columns(csv);
    csv.end_row();
    for (const EnvelopeRow& row : rows) {
        csv << part_name(row.part) << row.id;
        if (row.at) csv << row.at->x() << row.at->y();
        else
            csv << ""
                << "";
        csv << row.region << row.component << unit_of(row.kind, units).name;
        for (const Governing& end : {row.range.max, row.range.min})
            csv << sizes.clean(row, end.value) << model.case_name(end.load_case);
        csv.end_row();
    }
    return {{"envelope.csv", csv.take()}};
}

} // namespace femoop::plane
