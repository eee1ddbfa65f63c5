#include "apps/euler/document/palette/operator_form.h"

#include "ui/text/catalogue.h"

namespace euler {

namespace {

using ui::translatable;
using enum ArgumentKind;

constexpr Argument in{Solid, translatable("the solid")};
constexpr Argument new_vertex{NewVertex, translatable("the new vertex's name")};
constexpr Argument new_face{NewFace, translatable("the new face's name")};
constexpr Argument place{Point, translatable("the place of the vertex")};

constexpr std::array<OperatorForm, n_verbs> forms{{
    {Verb::Mvfs,
     "mvfs",
     "MVFS",
     translatable("make a vertex, a face and a shell"),
     {{{AnySolid, translatable("the solid: a new name, or one that gets another shell")}, new_face, new_vertex, place}},
     4},
    {Verb::Kvfs,
     "kvfs",
     "KVFS",
     translatable("kill a vertex, a face and a shell"),
     {{in, {Face, translatable("the only face of the shell that goes")}}},
     2},
    {Verb::Mev,
     "mev",
     "MEV",
     translatable("make an edge and a vertex"),
     {{in, {Corner, translatable("the corner that the edge grows from")}, new_vertex, place}},
     4},
    {Verb::Split,
     "split",
     "MEV",
     translatable("make an edge and a vertex by splitting a vertex"),
     {{in,
       {HalfEdge, translatable("the first half-edge at the vertex that moves to the new one")},
       {HalfEdge, translatable("the first half-edge, clockwise from there, that stays")},
       new_vertex,
       place}},
     5},
    {Verb::Kev,
     "kev",
     "KEV",
     translatable("kill an edge and a vertex"),
     {{in, {HalfEdge, translatable("the half-edge that runs to the vertex that goes")}}},
     2},
    {Verb::Mef,
     "mef",
     "MEF",
     translatable("make an edge and a face"),
     {{in,
       {Corner, translatable("the corner where the new face's part of the loop begins")},
       {Corner, translatable("the corner where it ends")},
       new_face}},
     4},
    {Verb::Kef,
     "kef",
     "KEF",
     translatable("kill an edge and a face"),
     {{in, {HalfEdge, translatable("the edge's half in the face that stays")}}},
     2},
    {Verb::Kemr,
     "kemr",
     "KEMR",
     translatable("kill an edge and make a ring"),
     {{in, {HalfEdge, translatable("the edge's half that runs to the part that becomes a ring")}}},
     2},
    {Verb::Mekr,
     "mekr",
     "MEKR",
     translatable("make an edge and kill a ring"),
     {{in,
       {Corner, translatable("the corner in the loop that stays")},
       {Corner, translatable("the corner in the loop that goes")}}},
     3},
    {Verb::Kfmrh,
     "kfmrh",
     "KFMRH",
     translatable("kill a face and make a ring and a hole, or join two shells"),
     {{in, {Face, translatable("the face that gets a ring")}, {Face, translatable("the face that becomes the ring")}}},
     3},
    {Verb::Mfkrh,
     "mfkrh",
     "MFKRH",
     translatable("make a face and kill a ring and a hole, or part a shell"),
     {{in, {Ring, translatable("the ring that gets a face of its own")}, new_face}},
     3},
    {Verb::Mvr,
     "mvr",
     "MVR",
     translatable("make a vertex and a ring"),
     {{in, {Face, translatable("the face that the lone vertex lies in")}, new_vertex, place}},
     4},
    {Verb::Kvr,
     "kvr",
     "KVR",
     translatable("kill a vertex and a ring"),
     {{in, {Vertex, translatable("the lone vertex that goes")}}},
     2},
    {Verb::Semv,
     "semv",
     "SEMV",
     translatable("split an edge and make a vertex"),
     {{in, {HalfEdge, translatable("the edge to split")}, new_vertex, place}},
     4},
    {Verb::Jekv,
     "jekv",
     "JEKV",
     translatable("join two edges and kill a vertex"),
     {{in, {HalfEdge, translatable("the half-edge that runs to the vertex that goes")}}},
     2},
    {Verb::Ringmv,
     "ringmv",
     "RINGMV",
     translatable("move a ring to another face"),
     {{in, {Ring, translatable("the ring to move")}, {Face, translatable("the face that it moves to")}}},
     3},
    {Verb::Move,
     "move",
     "MOVE",
     translatable("move a vertex, which changes no link"),
     {{in, {Vertex, translatable("the vertex to move")}, place}},
     3},
    {Verb::Sweep,
     "sweep",
     "SWEEP",
     translatable("sweep a face along a line: many MEV and MEF"),
     {{in, {Face, translatable("the face that moves")}, {Vector, translatable("how far it moves")}}},
     3},
}};

} // namespace

std::span<const OperatorForm> operator_forms() { return forms; }

const OperatorForm& form(Verb verb) { return forms[static_cast<std::size_t>(verb)]; }

bool is_pointed_at(ArgumentKind kind)
{
    return kind == Face || kind == Corner || kind == HalfEdge || kind == Ring || kind == Vertex;
}

} // namespace euler
