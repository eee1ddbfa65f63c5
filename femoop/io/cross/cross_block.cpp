#include "femoop/io/cross/cross_block.h"

#include <array>
#include <cmath>

#include "femoop/io/json/extra_block.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/value_reader.h"

namespace femoop::cross {

namespace {

constexpr double most_digits_typed = 16.0;
constexpr double most_balances = 1e5;

JsonValue member(JsonValue object, std::string_view key)
{
    for (const JsonValue value : object)
        if (value.key() == key) return value;
    return {};
}

/// Reads a block; what it does not know it leaves to others.
class BlockReader {
public:
    Block read(JsonValue value)
    {
        Block block;
        if (reader_.is_object(value, place_)) fill(block, value);
        if (auto faults = reader_.collect_faults(); !faults.empty()) throw ModelError(std::move(faults));
        return block;
    }

private:
    void fill(Block& block, JsonValue value)
    {
        block.load_case = reader_.text(member(value, "case"), place_);
        block.order = order(member(value, "order"));
        block.balances = count(member(value, "balances"), most_balances);
        block.digits = static_cast<int>(count(member(value, "digits"), most_digits_typed).value_or(0));
        block.tolerance = number(member(value, "tolerance"));
        block.is_modified = reader_.boolean(member(value, "modified_stiffness"), place_);
        block.is_by_halves = reader_.boolean(member(value, "symmetry"), place_);
        for (const JsonValue joint : list(member(value, "factors"), JsonKind::Object))
            block.factors.emplace_back(joint.key(), labelled(joint));
        block.fixed_end = labelled(member(value, "fixed_end_moments"));
        block.sheet = sheet(member(value, "sheet"));
        block.sheet_atol = number(member(value, "sheet_atol")).value_or(block.sheet_atol);
        block.last = labelled(member(value, "final"));
        block.rtol = number(member(value, "rtol")).value_or(block.rtol);
        const Place stages = place_.key("stages");
        for (const JsonValue stage : list(member(value, "stages"), JsonKind::Array))
            block.stages.push_back(read_stage(stage, stages.entry(block.stages.size())));
    }

    std::optional<double> number(JsonValue value)
    {
        const std::optional<double> found = reader_.number(value, place_);
        if (found && !(*found >= 0.0))
            reader_.wrong_type(value, {translatable("a number of at least 0"), "0.001"}, place_);
        return found;
    }

    std::optional<std::size_t> count(JsonValue value, double most)
    {
        const std::optional<double> found = reader_.number(value, place_);
        if (!found) return std::nullopt;
        if (*found >= 0.0 && *found <= most && *found == std::floor(*found)) return static_cast<std::size_t>(*found);
        reader_.wrong_type(value, {translatable("a whole number"), "6"}, place_);
        return std::nullopt;
    }

    /// A text, or a list of joints.
    std::optional<std::string> order(JsonValue value)
    {
        if (!value.is(JsonKind::Array)) return reader_.text(value, place_);
        std::string joints;
        for (const JsonValue joint : value)
            joints += (joints.empty() ? "" : ",") + reader_.text(joint, place_).value_or("");
        return joints;
    }

    JsonValue list(JsonValue value, JsonKind kind)
    {
        if (!value.is_present() || value.is(kind)) return value;
        if (kind == JsonKind::Object) reader_.is_object(value, place_);
        else reader_.is_list(value, place_);
        return {};
    }

    Labelled labelled(JsonValue value)
    {
        Labelled values;
        for (const JsonValue one : list(value, JsonKind::Object))
            if (const auto number = reader_.number(one, place_)) values.emplace_back(one.key(), *number);
        return values;
    }

    std::vector<Block::Row> sheet(JsonValue value)
    {
        std::vector<Block::Row> rows;
        for (const JsonValue row : list(value, JsonKind::Array)) {
            Block::Row& read = rows.emplace_back();
            for (const JsonValue one : list(row, JsonKind::Object))
                if (one.key() == "step") read.step = reader_.text(one, place_).value_or("");
                else if (one.key() == "joint" || one.is(JsonKind::Null)) continue; // whose balance; an empty cell
                else if (const auto number = reader_.number(one, place_)) read.values.emplace_back(one.key(), *number);
        }
        return rows;
    }

    Block::Stage read_stage(JsonValue value, const Place& place)
    {
        Block::Stage stage;
        if (!reader_.is_object(value, place)) return stage;
        const JsonValue prop = member(value, "prop"), props = member(value, "props"), sway = member(value, "sway");
        stage.is_propped = prop.is_present() || props.is_present();
        if (prop.is_present()) stage.props.push_back(read_prop(prop, place.key("prop")));
        const Place list_place = place.key("props");
        std::size_t i = 0;
        for (const JsonValue one : list(props, JsonKind::Array))
            stage.props.push_back(read_prop(one, list_place.entry(i++)));
        if (sway.is_present()) stage.sway = read_prop(sway, place.key("sway"));
        stage.fixed_end = labelled(member(value, "fixed_end_moments"));
        stage.sheet = sheet(member(value, "sheet"));
        stage.last = labelled(member(value, "final"));
        stage.reactions = numbers(member(value, "reaction"), place);
        return stage;
    }

    Block::Prop read_prop(JsonValue value, const Place& place)
    {
        constexpr std::array<std::string_view, 2> dofs{"ux", "uy"};
        Block::Prop prop;
        if (!value.is(JsonKind::Object)) {
            reader_.not_an_object(value, place);
            return prop;
        }
        prop.node = reader_.text(member(value, "node"), place);
        if (const auto dof = reader_.choice(member(value, "dof"), dofs, place))
            prop.dof = *dof == 0 ? Dof::ux : Dof::uy;
        const std::vector<double> direction = numbers(member(value, "direction"), place);
        if (direction.size() == 2 && std::hypot(direction[0], direction[1]) > 0.0)
            prop.direction = Eigen::Vector2d(direction[0], direction[1]);
        prop.reaction = reader_.number(member(value, "reaction"), place);
        return prop;
    }

    /// A number, or a list of them.
    std::vector<double> numbers(JsonValue value, const Place& place)
    {
        std::vector<double> found;
        if (!value.is(JsonKind::Array)) {
            if (const auto number = reader_.number(value, place)) found.push_back(*number);
            return found;
        }
        const Place own = place.key(value.key());
        std::size_t i = 0;
        for (const JsonValue one : value)
            if (const auto number = reader_.number(one, own.entry(i++))) found.push_back(*number);
        return found;
    }

    Place top_;
    Place place_ = top_.key("cross");
    ValueReader reader_;
};

/// Of the loads: the block's own, or those of its first stage.
const Labelled& fixed_end_of(const Block& block)
{
    if (!block.fixed_end.empty() || block.stages.empty()) return block.fixed_end;
    const Block::Stage& first = block.stages.front();
    return first.fixed_end.empty() && !first.sheet.empty() ? first.sheet.front().values : first.fixed_end;
}

/// How far a problem's fixed-end moments are from a file's.
double distance_of_moments(const Problem& problem, const Labelled& wanted)
{
    double sum = 0.0;
    for (const auto& [end, value] : by_end(problem, wanted, "cross.fixed_end_moments"))
        sum += std::abs(problem.loading.fixed_end[end.index] - value);
    return sum;
}

} // namespace

std::optional<Block> block_of(const Model& model)
{
    const std::optional<JsonDocument> json = extra_block(model, "cross");
    if (!json) return std::nullopt;
    return BlockReader().read(json->root());
}

void set_order(Procedure& procedure, const std::string& order, const Model& model, const Problem& problem)
{
    procedure.joints.clear();
    if (order == "largest") procedure.order = Order::Largest;
    else if (order == "left-to-right") procedure.order = Order::LeftToRight;
    else if (order == "all-at-once") procedure.order = Order::AllAtOnce;
    else {
        procedure.order = Order::Listed;
        std::string rest = order;
        while (!rest.empty()) {
            const std::size_t comma = rest.find(',');
            std::string name = rest.substr(0, comma);
            rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
            const std::size_t first = name.find_first_not_of(' ');
            name = first == std::string::npos ? "" : name.substr(first, name.find_last_not_of(' ') - first + 1);
            const std::optional<NodeId> node = model.find_node(name);
            const std::optional<JointId> joint = node ? problem.joint_at(*node) : std::nullopt;
            if (!joint || !problem.is_balanced(*joint))
                throw ModelError(
                    {{FaultKind::CrossNoSuchJoint, {'"' + name + '"', listed(joint_names(model, problem))}}});
            procedure.joints.push_back(*joint);
        }
    }
}

CaseId case_of(const Model& model, const std::optional<Block>& block)
{
    if (!block || !block->load_case) return CaseId(0);
    if (const auto found = model.find_case(*block->load_case)) return *found;
    throw ModelError({{FaultKind::NoSuchCase, {"cross.case", *block->load_case}}});
}

FarEnds far_ends_of(const Model& model, CaseId load_case, const Block& block)
{
    if (!block.is_modified) return FarEnds::Plain;
    const double modified = distance_of_moments(problem_of(model, load_case, FarEnds::Modified), fixed_end_of(block));
    const double on_sheet = distance_of_moments(problem_of(model, load_case, FarEnds::ReleasedOnSheet),
                                                fixed_end_of(block));
    return on_sheet < modified ? FarEnds::ReleasedOnSheet : FarEnds::Modified;
}

Extent extent_of(const std::optional<Block>& block)
{
    return block && block->is_by_halves ? Extent::Half : Extent::Whole;
}

Procedure procedure_of(const Model& model, const Problem& problem, const Block& block)
{
    Procedure procedure;
    if (block.order) set_order(procedure, *block.order, model, problem);
    procedure.balances = block.balances;
    procedure.tolerance = block.tolerance;
    procedure.digits = block.digits;
    const std::vector<Block::Row>& sheet = block.sheet.empty() && !block.stages.empty() ? block.stages.front().sheet
                                                                                        : block.sheet;
    procedure.ends_with_balance = sheet.size() > 1 ? sheet[sheet.size() - 2].step == "BAL"
                                                   : procedure.order == Order::AllAtOnce;
    return procedure;
}

std::vector<std::pair<EndId, double>> by_end(const Problem& problem, const Labelled& values, const std::string& place)
{
    std::vector<std::pair<EndId, double>> found;
    for (const auto& [label, value] : values) {
        const std::optional<EndId> end = problem.find_end(label);
        if (!end) {
            std::vector<std::string> labels;
            for (const End& one : problem.ends) labels.push_back(one.label);
            throw ModelError({{FaultKind::CrossNoSuchEnd, {place, label, listed(labels)}}});
        }
        found.emplace_back(*end, value);
    }
    return found;
}

} // namespace femoop::cross
