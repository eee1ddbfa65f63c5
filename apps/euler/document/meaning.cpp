#include "apps/euler/document/meaning.h"

#include <algorithm>
#include <array>
#include <string>

#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::EulerCounts;
using ui::Message;
using ui::translatable;

/// The sentence of each word of the script language. Places are the words of its line, by number: {1} is the solid.
struct Meaning {
    std::string_view word;
    std::string_view sentence;
};
constexpr std::array<Meaning, 16> meanings{{
    {"mvfs", translatable("A new shell of {1}: vertex {3} on a sphere whose one face is {2}.")},
    {"kvfs", translatable("A shell of {1}, which was one vertex in one face, is gone.")},
    {"mev", translatable("A strut grows from {3} in face {2} to the new vertex {4}.")},
    {"split",
     translatable("Vertex {4} is split: part of its edges go to the new vertex {7}, and a new edge joins the two.")},
    {"kev", translatable("The edge from {2} to {3} dies and {3} with it; what other edges met there meet at {2}.")},
    {"mef", translatable("An edge from {3} to {4} divides face {2}; the new face is {5}.")},
    {"kef", translatable("The edge from {3} to {4} dies; {2} takes in the face beyond it.")},
    {"kemr", translatable("The edge from {3} to {4} dies, which parts a loop of {2}: {4} lies on a ring now.")},
    {"mekr", translatable("An edge from {3} to {4} joins two loops of face {2} to one.")},
    {"mvr", translatable("A lone vertex {3} lies in face {2}, as a ring.")},
    {"kvr", translatable("The lone vertex {3}, a ring of {2}, is gone.")},
    {"semv", translatable("The edge from {2} to {3} is split by the new vertex {4}.")},
    {"jekv", translatable("Vertex {3} dies; the two edges that met there are one.")},
    {"ringmv", translatable("The ring at {3} moves from face {2} to face {4}.")},
    {"move", translatable("Vertex {2} moves; no link changes.")},
    {"sweep",
     translatable("Face {2} moves and leaves a wall behind each of its edges: one MEV a corner, one MEF an edge.")},
}};

std::string_view sentence(std::string_view word, const EulerCounts& before, const EulerCounts& after)
{
    if (word == "kfmrh")
        return after.S < before.S
                   ? translatable("Face {3} dies and becomes a ring of {2}: their two shells are joined, S − 1.")
                   : translatable("Face {3} dies and becomes a ring of {2}: their one shell gets a handle, G + 1.");
    if (word == "mfkrh")
        return after.S > before.S
                   ? translatable("The ring at {3} bounds the new face {4}: nothing else held the two parts, S + 1.")
                   : translatable("The ring at {3} bounds the new face {4}: its shell loses a handle, G − 1.");
    const auto* found = std::find_if(meanings.begin(), meanings.end(),
                                     [&](const Meaning& m) { return m.word == word; });
    return found == meanings.end() ? std::string_view() : found->sentence;
}

} // namespace

Message meaning(std::string_view line, const EulerCounts& before, const EulerCounts& after)
{
    const auto words = topology::words(line);
    Message said(sentence(words.front(), before, after));
    for (std::size_t i = 1; i < words.size(); ++i)
        said.arguments.emplace_back(std::to_string(i), std::string(words[i]));
    return said;
}

} // namespace euler
