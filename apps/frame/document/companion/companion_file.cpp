#include "apps/frame/document/companion/companion_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "apps/frame/document/document.h"
#include "apps/frame/document/set_library.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/file_text.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/model_file.h"
#include "femoop/io/reader/value_reader.h"
#include "femoop/model/check/suggestion.h"
#include "femoop/model/fault/translator.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/units.h"
#include "ui/files/view_file.h"

namespace frame {

using namespace femoop;
using namespace std::string_view_literals;
namespace fs = std::filesystem;

namespace {

constexpr double format = 1.0;
constexpr Keys<4> file_keys{{"cremona_view", "dimensions", "sets", "views"}, 1};
constexpr Keys<8> view_keys{{"name", "show", "case", "envelope", "diagrams", "loads", "displacements", "region"}, 2};
constexpr Keys<3> dimension_keys{{"nodes", "direction", "offset"}, 3};
constexpr std::array directions{"aligned"sv, "horizontal"sv, "vertical"sv}; // as DimensionDirection has them

class CompanionReader {
public:
    CompanionReader(const JsonReading& json, const Model& model) : model_(model)
    {
        for (const Fault& fault : json.faults)
            reader_.add(fault.kind == FaultKind::FileEmpty ? Fault{FaultKind::MissingKey, {"file", "cremona_view"}}
                                                           : fault);
        if (json.document) read(json.document->root());
    }

    CompanionReading take() { return {std::move(companion_), reader_.collect_faults()}; }

private:
    void read(JsonValue file)
    {
        const Place top;
        const auto [version, dimensions, sets, views] = reader_.fields(file, file_keys, top);
        const auto found = reader_.number(version, top);
        if (found && *found != format)
            reader_.add({FaultKind::UnknownChoice, {top.text("cremona_view"), compact_json(version), "1"}});
        if (sets.is_present()) add_sets(sets);
        read_list(views, top.key("views"), [&](JsonValue view, const Place& place) { add_view(view, place); });
        if (!reader_.is_list(dimensions, top)) return;
        const Place list = top.key("dimensions");
        for (std::size_t i = 0; const JsonValue entry : dimensions) add_dimension(entry, list.entry(i++));
    }

    template <class Read> void read_list(JsonValue list, const Place& place, Read read)
    {
        if (!reader_.is_list(list, place)) return;
        for (std::size_t i = 0; const JsonValue entry : list) read(entry, place.entry(i++));
    }

    // One with a fault is left out.
    void add_view(JsonValue value, const Place& place)
    {
        const std::size_t before = reader_.n_troubles();
        const auto [name, show, load_case, envelope, diagrams, loads, displacements,
                    region] = reader_.fields(value, view_keys, place);
        NamedView view{.name = read_name(name, place),
                       .show = read_show(show, place),
                       .load_case = reader_.text(load_case, place),
                       .diagrams = positive(diagrams, place).value_or(1.0),
                       .loads = positive(loads, place).value_or(1.0),
                       .displacements = positive(displacements, place),
                       .region = std::nullopt};
        if (reader_.is_list(region, place)) view.region = read_region(region, place.key("region"));
        if (view.load_case) require_case(*view.load_case, place.key("case"));
        if (reader_.is_list(envelope, place)) view.envelope = read_cases(envelope, place.key("envelope"));
        if (value.is(JsonKind::Object) && reader_.n_troubles() == before) companion_.views.push_back(std::move(view));
    }

    // By its name one is asked for, so each has its own.
    std::string read_name(JsonValue value, const Place& place)
    {
        std::string name = reader_.text(value, place).value_or("");
        const auto [first, is_first] = named_views_.try_emplace(name, place.text());
        if (!is_first) reader_.add({FaultKind::RepeatedId, {place.text("name"), first->second}});
        return name;
    }

    ShowSet read_show(JsonValue value, const Place& place)
    {
        try {
            return parse_show(reader_.text(value, place).value_or(""));
        } catch (const ShowError& error) {
            std::vector<std::string_view> words;
            for (const ShowWord& known : show_text()) words.push_back(known.word);
            reader_.unknown_choice(place.text("show"), error.word(), words);
            return {};
        }
    }

    std::vector<std::string> read_cases(JsonValue list, const Place& place)
    {
        std::vector<std::string> ids;
        for (std::size_t i = 0; const JsonValue entry : list) {
            const Place own_place = place.entry(i++);
            ids.push_back(reader_.text(entry, own_place).value_or(""));
            if (entry.is(JsonKind::String)) require_case(ids.back(), own_place);
        }
        return ids;
    }

    void require_case(const std::string& id, const Place& place)
    {
        if (!model_.find_case(id)) no_such(id, case_names(), {FaultKind::NoSuchCase, FaultKind::NoSuchCaseNear}, place);
    }

    std::vector<std::string_view> case_names() const
    {
        std::vector<std::string_view> names;
        for (std::size_t i = 0; i < model_.n_cases(); ++i) names.push_back(model_.case_name(CaseId(i)));
        return names;
    }

    std::optional<double> positive(JsonValue value, const Place& place)
    {
        const std::optional<double> number = reader_.number(value, place);
        if (number && !(*number > 0.0))
            reader_.add({FaultKind::NotPositive, {place.text(), std::string(value.key()), number_text(*number)}});
        return number;
    }

    // Centre and height: [x, y, height].
    std::optional<Region> read_region(JsonValue list, const Place& place)
    {
        std::vector<double> numbers;
        for (const JsonValue entry : list) {
            const auto number = reader_.number(entry, place.entry(numbers.size()));
            if (!number) return std::nullopt;
            numbers.push_back(*number);
        }
        if (numbers.size() != 3) {
            const std::string unit = unit_text(dimension::length, model_.units);
            reader_.add({FaultKind::WrongCoordinateCount, {place.text(), std::to_string(numbers.size()), "3", unit}});
            return std::nullopt;
        }
        if (!(numbers[2] > 0.0))
            reader_.add({FaultKind::NotPositive, {place.text(), "height", number_text(numbers[2])}});
        return Region{.centre = {numbers[0], numbers[1]}, .height = numbers[2]};
    }

    // They have the form of a model, which is read as such, and counted in the units of this one.
    void add_sets(JsonValue value)
    {
        ModelReading library = examine_model(compact_json(value));
        for (const Fault& fault : library.faults)
            if (is_error(fault)) reader_.add(inside_sets(fault));
        if (!library.is_sound()) return;
        for (const std::string& place : places_beyond_sets(library.model))
            reader_.add({FaultKind::WrongType,
                         {"sets." + place, std::string(translatable("something else")),
                          std::string(translatable("the support of a node, or a load case of one load")),
                          R"("support": "fixed")"}});
        companion_.sets = sets_in(in_units(library.model, model_.units));
    }

    // A fault of the model that they form has its place in that model.
    static Fault inside_sets(Fault fault)
    {
        if (fault.kind == FaultKind::UnknownFormat || fault.arguments.empty()) return fault; // they begin with no place
        std::string& place = fault.arguments.front();
        place = place == "file" ? "sets" : "sets." + place;
        return fault;
    }

    // One with a fault is left out.
    void add_dimension(JsonValue value, const Place& place)
    {
        const std::size_t before = reader_.n_troubles();
        const auto [nodes, direction, offset] = reader_.fields(value, dimension_keys, place);
        DimensionLine dimension;
        read_nodes(nodes, place, dimension.nodes);
        if (const auto chosen = reader_.choice(direction, directions, place))
            dimension.direction = static_cast<DimensionDirection>(*chosen);
        dimension.offset = reader_.number(offset, place).value_or(0.0);
        if (value.is(JsonKind::Object) && reader_.n_troubles() == before)
            companion_.dimensions.push_back(std::move(dimension));
    }

    void read_nodes(JsonValue list, const Place& place, std::vector<std::string>& names)
    {
        if (!reader_.is_list(list, place)) return;
        if (list.size() < 2)
            reader_.add({FaultKind::WrongNodeCount, {place.text("nodes"), std::to_string(list.size())}});
        const Place here = place.key("nodes");
        for (std::size_t i = 0; const JsonValue entry : list) {
            const Place own_place = here.entry(i++);
            const auto name = reader_.text(entry, own_place);
            if (!name) continue;
            if (!model_.find_node(*name))
                no_such(*name, node_names(), {FaultKind::NoSuchNode, FaultKind::NoSuchNodeNear}, own_place);
            if (std::ranges::find(names, *name) != names.end())
                reader_.add({FaultKind::SameNodeTwice, {own_place.text(), *name}});
            names.push_back(*name);
        }
    }

    std::vector<std::string_view> node_names() const
    {
        std::vector<std::string_view> names;
        for (const Node& node : model_.nodes) names.push_back(node.id);
        return names;
    }

    /// What an unknown name is, without and with a suggestion.
    struct Missing {
        FaultKind plain, with_near;
    };
    void no_such(const std::string& name, const std::vector<std::string_view>& known, const Missing& kinds,
                 const Place& place)
    {
        auto near = nearest(name, known);
        if (near) reader_.add({kinds.with_near, {place.text(), name, std::move(*near)}});
        else reader_.add({kinds.plain, {place.text(), name}});
    }

    const Model& model_;
    ValueReader reader_;
    Companion companion_;
    std::map<std::string, std::string> named_views_; ///< names that were read, and their places
};

void write(JsonWriter& json, const DimensionLine& dimension)
{
    json.begin_object().key("nodes").begin_array();
    for (const std::string& name : dimension.nodes) json.value(name);
    json.end();
    json.member("direction", directions.at(static_cast<std::size_t>(dimension.direction)));
    json.member("offset", dimension.offset).end();
}

void write(JsonWriter& json, const NamedView& view)
{
    json.begin_object().member("name", view.name).member("show", words_of(view.show));
    if (view.load_case) json.member("case", *view.load_case);
    if (!view.envelope.empty()) {
        json.key("envelope").begin_array();
        for (const std::string& id : view.envelope) json.value(id);
        json.end();
    }
    if (view.diagrams != 1.0) json.member("diagrams", view.diagrams);
    if (view.loads != 1.0) json.member("loads", view.loads);
    if (view.displacements) json.member("displacements", *view.displacements);
    if (const std::optional<Region>& region = view.region) {
        json.key("region").begin_array();
        json.value(region->centre.x()).value(region->centre.y()).value(region->height).end();
    }
    json.end();
}

} // namespace

CompanionReading read_companion(std::string_view text, const Model& model)
{
    return CompanionReader(parse_json(text), model).take();
}

CompanionReading read_companion_of(const fs::path& model_file, const Model& model)
{
    const fs::path path = ui::view_path(model_file);
    std::error_code unknown;
    if (!fs::exists(path, unknown) && !unknown) return {};
    FileText file = file_text(path);
    if (file.fault) return {{}, {*std::move(file.fault)}};
    return read_companion(file.text, model);
}

std::string write_companion(const Companion& companion, const Model& model)
{
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::Block).member("cremona_view", 1);
    if (!companion.dimensions.empty()) {
        json.key("dimensions").begin_array(JsonWriter::Layout::Block);
        for (const DimensionLine& dimension : companion.dimensions) write(json, dimension);
        json.end();
    }
    if (!companion.sets.empty()) {
        const std::string library = write_model(library_of(companion.sets, model));
        json.key("sets").json(pretty_json(parse_json(library).document->root(), 2, 120));
    }
    if (!companion.views.empty()) {
        json.key("views").begin_array(JsonWriter::Layout::Block);
        for (const NamedView& view : companion.views) write(json, view);
        json.end();
    }
    json.end();
    return json.take();
}

std::error_code save_companion_of(const fs::path& model_file, const Document& document)
{
    const Companion& companion = document.companion;
    const fs::path path = ui::view_path(model_file);
    if (!companion.is_empty()) return files::write_whole_file(path, write_companion(companion, document.model));
    std::error_code error;
    fs::remove(path, error);
    return error;
}

} // namespace frame
