#pragma once

#include <cstddef>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/place.h"
#include "femoop/io/reader/value_reader.h"
#include "femoop/model/load.h"
#include "femoop/model/node.h"
#include "femoop/model/property.h"

namespace femoop {

/// What a reference that names nothing becomes: the fault is noted, the index is out of every list.
inline constexpr std::size_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// Reads what the files of all models have in common: units, materials, parts of supports, combinations, and how
/// entries refer to one another by name.
class FileReader {
protected:
    /// The names of a list. A name that is not in it may be that of an entry whose own name cannot be read: each such
    /// entry, which is a fault already, excuses one unknown name.
    struct NameTable {
        FaultKind missing, missing_near; ///< what an unknown name is, without and with a suggestion
        std::unordered_map<std::string_view, std::size_t> entries = {};
        std::size_t n_lost = 0; ///< entries whose name is missing, no text or taken
        bool is_lost = false;   ///< the list itself cannot be read
        std::unordered_set<std::string_view> excused = {};

        void add(JsonValue list, std::size_t first_index = 0);
        template <class Parts> void add_parts(const Parts& parts)
        {
            for (const auto& part : parts) entries.emplace(part.id, entries.size());
        }
        bool is_lost_entry(std::string_view name, std::size_t index) const;
        bool excuses(std::string_view name, std::size_t n_own); ///< but not by `n_own` lost entries
    };

    void read_format(JsonValue cremona);
    Units read_units(JsonValue units);
    /// Calls read(value, place) for every entry of a list.
    template <class Read> void for_each(JsonValue list, const Place& place, Read read);
    /// Every entry of a list as a part of the model, and whether it could be read.
    template <class Reader, class Part>
    void read_parts(Reader& reader, JsonValue list, const Place& place, std::vector<Part>& parts,
                    std::vector<bool>& unreadable, Part (Reader::*read)(JsonValue, const Place&));
    static std::string_view id_of(JsonValue entry);                 ///< "" if it has none
    static JsonValue field(JsonValue object, std::string_view key); ///< absent if there is none
    std::size_t reference(JsonValue value, NameTable& names, const Place& place);
    std::size_t lookup(std::string_view name, NameTable& names, const Place& place, std::size_t n_own = 0);

    Material material(JsonValue value, const Place& place);
    DofSet dof_set(JsonValue value, const Place& place);
    /// Stiffness along each degree of freedom that the object names. `dimension_of` is that of each.
    std::vector<Spring> springs(JsonValue value, Dimension (*dimension_of)(Dof), const Place& place);
    LoadAxes axes(JsonValue value, const Place& place);
    /// \param index  its own among load cases and combinations
    Combination combination(JsonValue value, std::size_t index, const Place& place);

    ValueReader reader_;
    NameTable materials_{FaultKind::NoSuchMaterial, FaultKind::NoSuchMaterialNear};
    NameTable cases_{FaultKind::NoSuchCase, FaultKind::NoSuchCaseNear};
};

template <class Read> void FileReader::for_each(JsonValue list, const Place& place, Read read)
{
    if (!reader_.is_list(list, place)) return;
    const Place here = place.key(list.key());
    std::size_t i = 0;
    for (const JsonValue value : list) read(value, here.entry(i++, id_of(value)));
}

template <class Reader, class Part>
void FileReader::read_parts(Reader& reader, JsonValue list, const Place& place, std::vector<Part>& parts,
                            std::vector<bool>& unreadable, Part (Reader::*read)(JsonValue, const Place&))
{
    for_each(list, place, [&](JsonValue value, const Place& own_place) {
        const std::size_t before = reader_.n_troubles();
        parts.push_back((reader.*read)(value, own_place));
        unreadable.push_back(reader_.n_troubles() != before);
    });
}

} // namespace femoop
