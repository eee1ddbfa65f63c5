#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/io/influence/influence_block.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/file_reader.h"
#include "femoop/io/train/train_block.h"
#include "femoop/model/check/check_parts.h"
#include "femoop/model/model.h"

namespace femoop {

/// Reads the parts of a model in the order in which they refer to each other. What cannot be understood is noted and
/// reading goes on, so that a file's errors come in one list; `unreadable` then says what `check` should pass over.
class ModelReader : private FileReader {
public:
    ModelReader(JsonValue file, std::vector<Fault> faults);
    /// For a block of the file, which refers to parts of a model that was read before and outlives this.
    explicit ModelReader(const Model& whole);

    Model model;
    std::vector<Fault> faults() { return reader_.collect_faults(); }
    const Unreadable& unreadable() const { return unreadable_; }

    // influence_block_reader.cpp
    influence::Block influence_block(JsonValue value); ///< the file's block `influence`
    // train_reader.cpp
    influence::TrainBlock train_block(JsonValue value); ///< the file's block `train`

private:
    // model_reader.cpp
    void read_header(JsonValue format, JsonValue analysis, JsonValue units, JsonValue mass);
    Material own_material(JsonValue value, const Place& place) { return material(value, place); }
    void keep_extra_blocks(JsonValue file);

    // structure_reader.cpp
    Section section(JsonValue value, const Place& place);
    Node node(JsonValue value, const Place& place);
    std::optional<Support> support(JsonValue value, const Place& place);
    Member member(JsonValue value, const Place& place);
    MemberEnd member_end(JsonValue value, const Place& place);
    std::vector<Quantity> lengths(JsonValue value, std::size_t n, const Place& place);
    std::vector<Quantity> up_vector(JsonValue value, const Place& place);
    std::vector<Quantity> depths(JsonValue value, const Place& place);
    std::optional<Quantity> foundation(JsonValue value, const Place& place);

    // load_reader.cpp
    void read_load_cases(JsonValue list);
    LoadCase load_case(JsonValue value, const Place& place);
    NodeLoad node_load(JsonValue value, const Place& place);
    Settlement settlement(JsonValue value, const Place& place);
    MemberLoad member_load(JsonValue value, const Place& place);
    DistributedLoad distributed_load(JsonValue value, const Place& place);
    PointLoad point_load(JsonValue value, const Place& place);
    EndLoads end_loads(JsonValue value, const Place& place);
    TemperatureLoad temperature_load(JsonValue value, const Place& place);
    Misfit misfit(JsonValue value, const Place& place);
    std::optional<DistributedLoad::Value> line_load(JsonValue value, Dof dof, const Place& place);
    std::optional<Position> position(JsonValue value, const Place& place);
    Combination own_combination(JsonValue value, const Place& place);

    // expected_reader.cpp
    Expected expected(JsonValue value, const Place& place);
    void read_component(Expected& check, JsonValue component, const Place& place);
    void read_which(Expected& check, JsonValue which, const Place& place);

    // moving_load_reader.cpp
    /// What an entry says of the effect that it asks for.
    struct EffectFields {
        JsonValue quantity, node, member, component, at, side;
    };
    LoadPath load_path(JsonValue value, const Place& place);
    InfluenceLineDefinition influence_line(JsonValue value, const Place& place);
    std::vector<MemberId> member_list(JsonValue value, const Place& place);
    LoadPathReference path_reference(JsonValue value, const Place& place);
    MovingEffect moving_effect(const EffectFields& fields, ExpectedQuantity last_quantity, const Place& place);
    std::vector<Component> unit_load(JsonValue value, const Place& place);

    // train_reader.cpp
    /// What a train's object says, in the file's list and in a block alike.
    struct TrainFields {
        JsonValue path, axles, spacings, ranges, both_directions, impact, uniform, extent, gap, concentrated, load;
    };
    Train train(JsonValue value, const Place& place);
    void read_train(const TrainFields& fields, Train& train, const Place& place);
    std::vector<Quantity> quantities(JsonValue list, Dimension dimension, const Place& place);
    void read_ranges(JsonValue ranges, Train& train, const Place& place);
    void read_concentrated(JsonValue value, Dimension dimension, Train& train, const Place& place);
    ConcentratedForce concentrated_force(JsonValue value, Dimension dimension, const Place& place);
    MovingEnvelope moving_envelope(JsonValue value, const Place& place);
    influence::TrainCheck train_check(JsonValue value, const Place& place);

    // influence_block_reader.cpp
    influence::LineCheck line_check(JsonValue value, const influence::LineCheck& common, const Place& place);
    std::vector<influence::PathPosition> path_positions(JsonValue list, const Place& place);
    std::optional<influence::PathPosition> path_position(JsonValue value, const Place& place);
    std::optional<influence::ExtremeCheck> extreme_check(JsonValue value, const Place& place);
    std::vector<double> numbers(JsonValue list, const Place& place);

    Unreadable unreadable_;
    NameTable sections_{FaultKind::NoSuchSection, FaultKind::NoSuchSectionNear};
    NameTable nodes_{FaultKind::NoSuchNode, FaultKind::NoSuchNodeNear};
    NameTable members_{FaultKind::NoSuchMember, FaultKind::NoSuchMemberNear};
    NameTable paths_{FaultKind::NoSuchPath, FaultKind::NoSuchPathNear};
    NameTable trains_{FaultKind::NoSuchTrain, FaultKind::NoSuchTrainNear};
};

} // namespace femoop
