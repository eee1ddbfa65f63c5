#include "femoop/io/train/train_json.h"

#include <string_view>

#include "femoop/geometry/member_geometry.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/reader/names.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"

namespace femoop::influence {

namespace {

using Layout = JsonWriter::Layout;
using CandidateKind = PositionFunction::Candidate::Kind;

class TrainWriter {
public:
    TrainWriter(JsonWriter& json, const Model& model) : json_(json), model_(model) {}

    void write(const TrainResults& results)
    {
        json_.begin_object(Layout::Block).member("id", results.id);
        json_.key("effects").begin_array(Layout::Block);
        for (std::size_t i = 0; i < results.effects.size(); ++i)
            write_effect(results.effects[i], results.is_envelope,
                         results.proofs.empty() ? nullptr : &results.proofs[i]);
        json_.end();
        json_.key("extremes").begin_array(Layout::Block);
        for (const TrainExtreme& extreme : results.extremes) write_extreme(extreme, results.is_envelope);
        json_.end().end();
    }

private:
    void write_effect(const TrainEffect& effect, bool names_train, const TrainResults::Proof* proof)
    {
        json_.begin_object();
        json_.member("quantity", names::quantities[static_cast<std::size_t>(effect.effect.quantity)]);
        write_part(effect.effect);
        write_placing("max", effect.max, *effect.max_train, names_train);
        write_placing("min", effect.min, *effect.min_train, names_train);
        if (proof != nullptr) {
            json_.key("proof").begin_object(Layout::Block);
            write_proof("max", proof->max);
            write_proof("min", proof->min);
            json_.end();
        }
        json_.end();
    }

    void write_part(const MovingEffect& effect)
    {
        if (effect.member) json_.member("member", model_[*effect.member].id);
        if (effect.node) json_.member("node", model_[*effect.node].id);
        json_.member("component", component_name(model_.analysis, effect));
        if (effect.at) json_.member("at", along(*effect.at, geometry_of(model_, model_[*effect.member]).length));
    }

    void write_position(const Placing& placing)
    {
        json_.key("position");
        if (placing.position) json_.value(*placing.position);
        else json_.null();
        json_.key("reversed");
        if (placing.position) json_.value(placing.reversed);
        else json_.null();
    }

    void write_placing(std::string_view key, const Placing& placing, const Train& train, bool names_train)
    {
        json_.key(key).begin_object().member("value", placing.value);
        write_position(placing);
        json_.key("spacings");
        if (placing.position) write_numbers(placing.spacings);
        else json_.null();
        json_.key("uniform");
        if (train.uniform) write_stretches(placing.uniform);
        else json_.null();
        json_.key("concentrated");
        if (train.concentrated.empty()) json_.null();
        else write_places(placing.concentrated);
        if (names_train) json_.member("train", train.id);
        json_.end();
    }

    void write_numbers(const std::vector<double>& numbers)
    {
        json_.begin_array();
        for (const double number : numbers) json_.value(number);
        json_.end();
    }

    void write_places(const std::vector<std::optional<double>>& places)
    {
        json_.begin_array();
        for (const auto& place : places)
            if (place) json_.value(*place);
            else json_.null();
        json_.end();
    }

    void write_stretches(const std::vector<Stretch>& stretches)
    {
        json_.begin_array();
        for (const Stretch& stretch : stretches) write_numbers({stretch.from, stretch.to});
        json_.end();
    }

    void write_extreme(const TrainExtreme& extreme, bool names_train)
    {
        json_.begin_object();
        write_part(extreme.effect);
        write_worst("max", extreme.max, *extreme.max_train, names_train);
        write_worst("min", extreme.min, *extreme.min_train, names_train);
        json_.end();
    }

    void write_worst(std::string_view key, const WorstSection& worst, const Train& train, bool names_train)
    {
        json_.key(key).begin_object().member("value", worst.placing.value);
        json_.key("section");
        write_numbers(worst.sections);
        write_position(worst.placing);
        if (names_train) json_.member("train", train.id);
        json_.end();
    }

    void write_proof(std::string_view key, const SearchProof& proof)
    {
        json_.key(key).begin_object(Layout::Block);
        json_.member("uniform", proof.uniform).member("concentrated", proof.concentrated);
        json_.key("candidates").begin_array(Layout::Block);
        for (const SearchProof::Entry& entry : proof.entries) {
            json_.begin_object().member("position", entry.candidate.x).member("reversed", entry.reversed);
            json_.member("kind", name(entry.candidate.kind)).member("value", entry.candidate.value).end();
        }
        json_.end().end();
    }

    static std::string_view name(CandidateKind kind)
    {
        if (kind == CandidateKind::Root) return "root";
        return kind == CandidateKind::BreakBefore ? "break-" : "break+";
    }

    JsonWriter& json_;
    const Model& model_;
};

} // namespace

std::string trains_json(const Model& model, const std::vector<TrainResults>& results)
{
    JsonWriter json;
    TrainWriter writer(json, model);
    begin_output(json, model.units);
    for (const bool is_envelope : {false, true}) {
        json.key(is_envelope ? "envelopes" : "trains").begin_array(Layout::Block);
        for (const TrainResults& one : results)
            if (one.is_envelope == is_envelope) writer.write(one);
        json.end();
    }
    json.end();
    return json.take();
}

} // namespace femoop::influence
