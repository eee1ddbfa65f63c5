#include "apps/cross/document/worked_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "apps/cross/document/block_entry.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/value_reader.h"

namespace cross {

namespace fc = femoop::cross;
using femoop::JsonKind;
using femoop::JsonValue;
using femoop::translatable;

namespace {

constexpr std::string_view worked_key = "worked";
constexpr std::size_t most_turns = 20000; // of all branches

/// Joints by name; nothing: all at once.
using Way = std::vector<std::optional<std::string>>;

struct SavedTurnTree {
    std::vector<Way> ways;
    std::size_t way = 0, at = 0;
};

struct Saved {
    std::size_t sheet = 0;
    std::vector<SavedTurnTree> plays;
};

/// Reads what was worked and writes down whatever in it is none.
class WorkedReader {
public:
    Saved read(JsonValue worked)
    {
        Saved saved;
        if (reader_.is_object(worked, cross_)) {
            saved.sheet = whole(entry_of(worked, "sheet"), place_);
            if (const JsonValue plays = entry_of(worked, "plays"); reader_.is_list(plays, place_))
                for (const JsonValue turn_tree : plays) saved.plays.push_back(read_play(turn_tree, saved.plays.size()));
        }
        if (auto faults = reader_.collect_faults(); !faults.empty()) throw femoop::ModelError(std::move(faults));
        return saved;
    }

private:
    SavedTurnTree read_play(JsonValue value, std::size_t i)
    {
        const femoop::Place plays = place_.key("plays"), place = plays.entry(i);
        SavedTurnTree turn_tree;
        if (!reader_.is_object(value, plays)) return turn_tree;
        turn_tree.way = whole(entry_of(value, "way"), place);
        turn_tree.at = whole(entry_of(value, "at"), place);
        const JsonValue ways = entry_of(value, "ways");
        if (!reader_.is_list(ways, place)) return turn_tree;
        for (const JsonValue way : ways) {
            turn_tree.ways.emplace_back();
            if (reader_.is_list(way, place))
                for (const JsonValue turn : way) read_turn(turn, turn_tree.ways.back(), place);
        }
        return turn_tree;
    }

    void read_turn(JsonValue turn, Way& way, const femoop::Place& place)
    {
        if (++n_turns_ <= most_turns && turn.is(JsonKind::Null)) way.emplace_back(std::nullopt);
        else if (n_turns_ <= most_turns && turn.is(JsonKind::String)) way.emplace_back(std::string(turn.text()));
        else if (n_turns_ == most_turns + 1 || !turn.is(JsonKind::String))
            reader_.wrong_type(turn, {translatable("at most 20000 joints, or null for all at once"), "\"B\""},
                               place.key("ways"));
    }

    std::size_t whole(JsonValue value, const femoop::Place& place)
    {
        if (!value.is_present()) return 0;
        const double number = value.is(JsonKind::Number) ? value.number() : -1.0;
        if (number >= 0.0 && number <= static_cast<double>(most_turns) && number == std::floor(number))
            return static_cast<std::size_t>(number);
        reader_.wrong_type(value, {translatable("a whole number"), "6"}, place);
        return 0;
    }

    femoop::Place top_, cross_ = top_.key("cross"), place_ = cross_.key(worked_key);
    femoop::ValueReader reader_;
    std::size_t n_turns_ = 0;
};

/// The turns of a way as far as the structure has such joints.
std::vector<TurnTree::Turn> turns_of(const Way& way, const femoop::Model& model, const fc::Problem& problem)
{
    std::vector<TurnTree::Turn> turns;
    for (const auto& name : way) {
        if (!name) {
            turns.emplace_back();
            continue;
        }
        const auto node = model.find_node(*name);
        const auto joint = node ? problem.joint_at(*node) : std::nullopt;
        if (!joint || !problem.is_balanced(*joint)) break;
        turns.emplace_back(*joint);
    }
    return turns;
}

TurnTree play_of(const SavedTurnTree& saved, const femoop::Model& model, const fc::Problem& problem)
{
    TurnTree turn_tree;
    std::vector<std::size_t> ends;
    for (const Way& way : saved.ways) {
        turn_tree.restart();
        for (const TurnTree::Turn& turn : turns_of(way, model, problem)) turn_tree.advance(turn);
        ends.push_back(turn_tree.place());
    }
    if (saved.way < ends.size()) turn_tree.go_to(ends[saved.way]);
    turn_tree.jump(saved.at);
    return turn_tree;
}

void set_worked(Document& document, const Saved& saved)
{
    try {
        const fc::Problem problem = problem_of(document);
        if (problem.balanced_joints().empty()) return;
        const std::size_t n_sheets = 1 + problem.sways.size();
        for (std::size_t i = 0; i < std::min(n_sheets, saved.plays.size()); ++i)
            document.plays.push_back(play_of(saved.plays[i], document.model, problem.of_sheet(i)));
        document.stage = std::min(saved.sheet, n_sheets - 1);
    } catch (const femoop::ModelError&) {
        document.plays.clear(); // it is said when the structure is solved
    }
}

std::string json_of(const TurnTree& turn_tree, const femoop::Model& model, const fc::Problem& problem)
{
    std::string ways;
    std::size_t way = 0, n_ways = 0;
    TurnTree ahead = turn_tree;
    while (ahead.forward()) continue;
    for (const std::size_t end : turn_tree.branches()) {
        if (end == ahead.place()) way = n_ways;
        std::string list;
        for (const TurnTree::Turn& turn : turn_tree.turns_to(end))
            list += (list.empty() ? "" : ", ") + (turn ? femoop::quoted_json(model[problem[*turn].node].id) : "null");
        ways += (n_ways++ == 0 ? "[" : ", [") + list + "]";
    }
    return "{\"ways\": [" + ways + "], \"way\": " + std::to_string(way) +
           ", \"at\": " + std::to_string(turn_tree.length()) + "}";
}

std::optional<std::string> worked_json(const Document& document)
{
    const auto is_empty = [](const TurnTree& turn_tree) { return turn_tree.branches().empty(); };
    if (document.pupil || std::ranges::all_of(document.plays, is_empty)) return std::nullopt;
    try {
        const fc::Problem problem = problem_of(document);
        std::string plays;
        for (const TurnTree& turn_tree : document.plays)
            plays += (plays.empty() ? "" : ", ") + json_of(turn_tree, document.model, problem);
        const std::size_t last = problem.sways.size();
        return "{\"sheet\": " + std::to_string(std::min(document.stage, last)) + ", \"plays\": [" + plays + "]}";
    } catch (const femoop::ModelError&) {
        return std::nullopt; // then there is no sheet
    }
}

} // namespace

std::string with_worked(const std::string& block_json, const Document& document)
{
    return with_entry(block_json, worked_key, worked_json(document));
}

void read_worked(std::string& block_json, Document& document)
{
    const femoop::JsonReading reading = femoop::parse_json(block_json);
    if (!reading.document) return;
    const JsonValue worked = entry_of(reading.document->root(), worked_key);
    if (!worked.is_present()) return;
    const Saved saved = WorkedReader().read(worked);
    block_json = with_entry(block_json, worked_key, std::nullopt);
    if (!document.pupil) set_worked(document, saved);
}

} // namespace cross
