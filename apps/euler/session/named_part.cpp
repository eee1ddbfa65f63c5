#include "apps/euler/session/named_part.h"

#include <string>
#include <vector>

#include "ui/scenario/words.h"

namespace euler {

namespace {

using Words = std::span<const std::string>;

std::optional<topology::HalfEdgeId> half_edge(const Snapshot& in, const std::string& from, const std::string& to)
{
    const auto start = in.names->vertices.find(from, *in.solid), end = in.names->vertices.find(to, *in.solid);
    if (!start || !end) return std::nullopt;
    for (const topology::HalfEdgeId h : in.solid->fan(*start))
        if (in.solid->edge(h) && in.solid->end(h) == *end) return h;
    return std::nullopt;
}

std::optional<topology::Entity> entity(const Snapshot& in, Words words)
{
    const auto found = [](const auto& id) { return id ? std::optional<topology::Entity>(*id) : std::nullopt; };
    if (words.size() == 2 && words[0] == "vertex") return found(in.names->vertices.find(words[1], *in.solid));
    if (words.size() == 2 && words[0] == "face") return found(in.names->faces.find(words[1], *in.solid));
    if (words.size() == 3 && words[0] == "half-edge") return found(half_edge(in, words[1], words[2]));
    if (words.size() != 3 || words[0] != "edge") return std::nullopt;
    const auto h = half_edge(in, words[1], words[2]);
    return h ? found(in.solid->edge(*h)) : std::nullopt;
}

} // namespace

std::optional<Part> named_part(std::span<const Snapshot> solids, std::string_view text)
{
    const std::vector<std::string> words = ui::words_of(text);
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const bool names_solid = !words.empty() && words.front() == solids[i].name;
        if (!solids[i].is_alive()) continue;
        const auto wanted = entity(solids[i], Words(words).subspan(names_solid ? 1 : 0));
        if (wanted) return Part{i, *wanted};
    }
    return std::nullopt;
}

} // namespace euler
