#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/frame/document/part.h"
#include "femoop/edit/condense.h"
#include "femoop/model/load.h"
#include "femoop/model/node.h"
#include "ui/text/message.h"

namespace frame {

struct Document;

using MemberLoadValue = decltype(femoop::MemberLoad::load);
/// What a name can stand for, besides materials and sections: a support, forces on a node, or a load on a member.
using SetValue = std::variant<femoop::Support, std::vector<femoop::Component>, MemberLoadValue>;

/// A support or load under a name, to be given to many nodes or members. These do not refer to it: whoever has an equal
/// support or load has it, so a file without the names means the same.
struct NamedSet {
    std::string name;
    SetValue value;

    friend bool operator==(const NamedSet&, const NamedSet&) = default;
};

/// The place of a set among the document's.
struct NamedSetPlace {
    std::size_t set = 0;
    friend auto operator<=>(NamedSetPlace, NamedSetPlace) = default;
};

/// Equal numbers, however they were typed.
bool are_alike(const SetValue& a, const SetValue& b);

/// The support of a node, or the load itself; nothing for a free node and for other parts.
std::optional<SetValue> value_of(const femoop::Model& model, const Part& part);

/// The set that the part's value is, however its numbers were typed.
std::optional<NamedSetPlace> set_of(const Document& document, const Part& part);

/// The parts whose value the set is: nodes for a support, loads of every load case for a load.
std::vector<Part> users(const Document& document, NamedSetPlace set);

/// Whether `give` does something with the part: nodes take supports and forces, members take their loads.
bool suits(const SetValue& value, const Part& part);

/// The commands on named sets. They throw std::out_of_range, with the document as it was, where the set or a part is
/// not there.

/// Keeps the part's value under a name, made fresh where another has it. \pre the part has a value
NamedSetPlace keep(Document& document, const Part& part, const std::string& name);

/// The parts that it suits get it: the support in place of theirs, the load in addition to what acts in the load case
/// shown, once. \returns the new loads
std::vector<Part> give(Document& document, NamedSetPlace set, std::span<const Part> parts, femoop::CaseId load_case);

/// The node's support or the load becomes the set. \pre the part is of the set's kind
void assign(Document& document, NamedSetPlace set, const Part& part);

/// The set becomes what the part has, and so does everything that had it. \pre value_of(part) is of the set's kind
void replace(Document& document, NamedSetPlace set, const Part& part);

std::optional<ui::Message> why_not_rename(const Document& document, NamedSetPlace set, std::string_view name);
/// \pre why_not_rename gives no reason
void rename(Document& document, NamedSetPlace set, std::string name);

/// The name goes; whoever has its value keeps it.
void erase(Document& document, NamedSetPlace set);

/// Of equal sets the first stays; those that nobody has go. \returns how many went
femoop::Condensed condense_sets(Document& document);

/// The sets of another document, in the units of this one: those that are like one that is there stay out, names that
/// are taken are made fresh, and what the analysis has no use for is left. \returns how many came
std::size_t import_sets(Document& document, const Document& other);

} // namespace frame
