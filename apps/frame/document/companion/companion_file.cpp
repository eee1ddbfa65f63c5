#include "apps/frame/document/companion/companion_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>

#include "apps/frame/document/document.h"
#include "apps/frame/document/set_library.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/model_file.h"
#include "femoop/io/reader/value_reader.h"
#include "femoop/io/whole_file.h"
#include "femoop/model/check/suggestion.h"
#include "femoop/model/quantity/in_units.h"

namespace frame {

using namespace femoop;
using namespace std::string_view_literals;

namespace {

constexpr double format = 1.0;
constexpr std::string_view ending = ".view.json";
constexpr Keys<4> file_keys{{"cremona_view", "dimensions", "sets", "views"}, 1};
constexpr Keys<7> view_keys{{"name", "show", "case", "diagrams", "loads", "displacements", "region"}, 2};
constexpr Keys<3> dimension_keys{{"nodes", "direction", "offset"}, 3};
constexpr std::array directions{"aligned"sv, "horizontal"sv, "vertical"sv}; // as DimensionDirection has them

class CompanionReader {
public:
    CompanionReader(const JsonReading& json, const Model& model) : model_(model)
    {
        for (const Fault& fault : json.faults) reader_.add(fault);
        if (json.document) read(json.document->root());
    }

    CompanionReading take() { return {std::move(companion_), reader_.take_faults()}; }

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
        const auto [name, show, load_case, diagrams, loads, displacements, region] = reader_.fields(value, view_keys,
                                                                                                    place);
        NamedView view{.name = reader_.text(name, place).value_or(""),
                       .show = reader_.text(show, place).value_or(""),
                       .load_case = reader_.text(load_case, place),
                       .diagrams = positive(diagrams, place).value_or(1.0),
                       .loads = positive(loads, place).value_or(1.0),
                       .displacements = positive(displacements, place),
                       .region = std::nullopt};
        if (region.is_present()) view.region = read_region(region, place);
        if (value.is(JsonKind::Object) && reader_.n_troubles() == before) companion_.views.push_back(std::move(view));
    }

    std::optional<double> positive(JsonValue value, const Place& place)
    {
        const std::optional<double> number = reader_.number(value, place);
        if (number && !(*number > 0.0)) reader_.wrong_type(value, {"a number above 0", "1.5"}, place);
        return number;
    }

    // Centre and height: [x, y, height].
    std::optional<Region> read_region(JsonValue value, const Place& place)
    {
        std::vector<double> numbers;
        for (const JsonValue entry : value)
            if (entry.is(JsonKind::Number)) numbers.push_back(entry.number());
        const bool is_region = value.is(JsonKind::Array) && value.size() == 3 && numbers.size() == 3 &&
                               numbers.back() > 0.0;
        if (is_region) return Region{.centre = {numbers[0], numbers[1]}, .height = numbers[2]};
        reader_.wrong_type(value, {"a list of x, y and a height above 0", "[3, 2, 5]"}, place);
        return std::nullopt;
    }

    // They have the form of a model, which is read as such, and counted in the units of this one.
    void add_sets(JsonValue value)
    {
        ModelReading library = examine_model(compact_json(value));
        if (library.is_sound()) companion_.sets = sets_in(in_units(library.model, model_.units));
        for (Fault& fault : library.faults)
            if (severity(fault.kind) == Severity::Error) reader_.add(std::move(fault));
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
            if (!model_.find_node(*name)) no_such_node(*name, own_place);
            if (std::ranges::find(names, *name) != names.end())
                reader_.add({FaultKind::SameNodeTwice, {own_place.text(), *name}});
            names.push_back(*name);
        }
    }

    void no_such_node(const std::string& name, const Place& place)
    {
        std::vector<std::string_view> known;
        for (const Node& node : model_.nodes) known.push_back(node.id);
        auto near = nearest(name, known);
        if (near) reader_.add({FaultKind::NoSuchNodeNear, {place.text(), name, std::move(*near)}});
        else reader_.add({FaultKind::NoSuchNode, {place.text(), name}});
    }

    const Model& model_;
    ValueReader reader_;
    Companion companion_;
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
    json.begin_object().member("name", view.name).member("show", view.show);
    if (view.load_case) json.member("case", *view.load_case);
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

std::filesystem::path companion_path(std::filesystem::path model_file) { return model_file.replace_extension(ending); }

std::filesystem::path old_companion_path(const std::filesystem::path& model_file)
{
    return companion_path(model_file) += ".old";
}

bool is_companion_path(const std::filesystem::path& path) { return path.filename().string().ends_with(ending); }

CompanionReading read_companion(std::string_view text, const Model& model)
{
    return CompanionReader(parse_json(text), model).take();
}

namespace {

CompanionReading unreadable(const std::filesystem::path& path, int reason)
{
    return {{}, {{FaultKind::FileUnreadable, {path.string(), std::generic_category().message(reason)}}}};
}

} // namespace

CompanionReading read_companion_of(const std::filesystem::path& model_file, const Model& model)
{
    const std::filesystem::path path = companion_path(model_file);
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown) && !unknown) return {};
    if (std::filesystem::is_directory(path, unknown)) return unreadable(path, EISDIR);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return unreadable(path, errno);
    return read_companion(std::string{std::istreambuf_iterator<char>(file), {}}, model);
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

std::error_code save_companion_of(const std::filesystem::path& model_file, const Document& document)
{
    const Companion& companion = document.companion;
    const std::filesystem::path path = companion_path(model_file);
    if (!companion.is_empty()) return write_whole_file(path, write_companion(companion, document.model));
    std::error_code error;
    std::filesystem::remove(path, error);
    return error;
}

} // namespace frame
