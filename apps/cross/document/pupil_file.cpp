#include "apps/cross/document/pupil_file.h"

#include <cmath>
#include <limits>
#include <utility>

#include "apps/cross/document/block_entry.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/value_reader.h"

namespace cross {

using femoop::JsonKind;
using femoop::JsonValue;
using femoop::translatable;

namespace {

constexpr std::string_view exercise_key = "exercise";
constexpr std::size_t most_cells = 5000, longest_text = 60;

/// Reads an exercise and writes down whatever in it is none.
class PupilReader {
public:
    Pupil read(JsonValue block)
    {
        Pupil pupil;
        read_seed(pupil, block);
        const JsonValue cells = entry_of(block, "cells"), helped = entry_of(block, "helped");
        if (reader_.is_list(cells, place_))
            for (const JsonValue cell : cells) read_cell(pupil, cell);
        pupil.helped.resize(pupil.written.size());
        if (reader_.is_list(helped, place_))
            for (const JsonValue cell : helped) read_helped(pupil, cell);
        const JsonValue judges_at_once = entry_of(block, "judges_at_once");
        pupil.judges_at_once = !judges_at_once.is_present() || reader_.boolean(judges_at_once, place_);
        pupil.is_judged = reader_.boolean(entry_of(block, "is_judged"), place_);
        if (auto faults = reader_.collect_faults(); !faults.empty()) throw femoop::ModelError(std::move(faults));
        return pupil;
    }

private:
    void read_seed(Pupil& pupil, JsonValue block)
    {
        const JsonValue difficulty = entry_of(block, "difficulty"), seed = entry_of(block, "seed");
        if (!difficulty.is_present() && !seed.is_present()) return;
        if (!difficulty.is_present()) return reader_.missing_key("difficulty", place_);
        if (!seed.is_present()) return reader_.missing_key("seed", place_);
        const auto level = whole(difficulty, 1, n_difficulties, {translatable("a whole number from 1 to 6"), "3"},
                                 place_);
        const auto number = whole(seed, 0, std::numeric_limits<std::uint32_t>::max(),
                                  {translatable("a whole number from 0 to 4294967295"), "17"}, place_);
        if (level && number)
            pupil.seeded = Seeded{static_cast<femoop::cross::Difficulty>(static_cast<int>(*level)),
                                  static_cast<std::uint32_t>(*number)};
    }

    void read_cell(Pupil& pupil, JsonValue cell)
    {
        const bool is_text = cell.is(JsonKind::String) && cell.text().size() <= longest_text;
        if (is_text && pupil.written.size() < most_cells) return void(pupil.written.emplace_back(cell.text()));
        const femoop::Place cells = place_.key("cells");
        reader_.wrong_type(cell, {translatable("at most 5000 texts of at most 60 characters"), "\"12.5\""},
                           cells.entry(pupil.written.size()));
    }

    void read_helped(Pupil& pupil, JsonValue cell)
    {
        const auto at = whole(cell, 0, static_cast<double>(most_cells - 1), {translatable("a whole number"), "6"},
                              place_.key("helped"));
        if (!at) return;
        const auto place = static_cast<std::size_t>(*at);
        if (place >= pupil.helped.size()) pupil.helped.resize(place + 1);
        pupil.helped[place] = true;
    }

    std::optional<double> whole(JsonValue value, double least, double most, const femoop::ValueReader::Wanted& wanted,
                                const femoop::Place& place)
    {
        const double number = value.is(JsonKind::Number) ? value.number() : -1.0;
        if (number >= least && number <= most && number == std::floor(number)) return number;
        reader_.wrong_type(value, wanted, place);
        return std::nullopt;
    }

    femoop::Place top_, cross_ = top_.key("cross"), place_ = cross_.key(exercise_key);
    femoop::ValueReader reader_;
};

std::string json_of(const Pupil& pupil)
{
    std::string text = "{";
    if (pupil.seeded)
        text += "\"difficulty\": " + std::to_string(static_cast<int>(pupil.seeded->difficulty)) +
                ", \"seed\": " + std::to_string(pupil.seeded->seed) + ", ";
    text += std::string("\"judges_at_once\": ") + (pupil.judges_at_once ? "true" : "false") +
            ", \"is_judged\": " + (pupil.is_judged ? "true" : "false") + ", \"cells\": [";
    for (std::size_t i = 0; i < pupil.written.size(); ++i)
        text += (i == 0 ? "" : ", ") + femoop::quoted_json(pupil.written[i]);
    text += "], \"helped\": [";
    bool is_first = true;
    for (std::size_t i = 0; i < pupil.helped.size(); ++i) {
        if (!pupil.helped[i]) continue;
        text += (is_first ? "" : ", ") + std::to_string(i);
        is_first = false;
    }
    return text + "]}";
}

} // namespace

std::optional<Pupil> pupil_in(const std::string& block_json)
{
    const femoop::JsonReading reading = femoop::parse_json(block_json);
    if (!reading.document) return std::nullopt;
    const JsonValue block = entry_of(reading.document->root(), exercise_key);
    if (!block.is_present()) return std::nullopt;
    if (block.is(JsonKind::Object)) return PupilReader().read(block);
    femoop::ValueReader reader;
    const femoop::Place top;
    reader.is_object(block, top.key("cross"));
    throw femoop::ModelError(reader.collect_faults());
}

std::string with_pupil(const std::string& block_json, const std::optional<Pupil>& pupil)
{
    return with_entry(block_json, exercise_key, pupil ? std::optional(json_of(*pupil)) : std::nullopt);
}

} // namespace cross
