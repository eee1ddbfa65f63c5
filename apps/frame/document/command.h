#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"

namespace frame {

/// Commands that change a property which is no number (those are in number.h). All throw std::out_of_range, with the
/// document as it was, where the part is not there.

/// Nothing: the node is free. A keyword support loses angle, springs and a list of its own.
void set_support(Document& document, femoop::NodeId node, std::optional<femoop::SupportKind> kind);
/// Blocks or frees one degree of freedom; the support becomes one of the object form, or goes when it holds nothing.
enum class Hold : std::uint8_t { Free, Blocked };
void set_hold(Document& document, femoop::NodeId node, femoop::Dof dof, Hold hold);

/// Turns the support's own axes to an angle from those of the model [degrees], counter-clockwise; one that was a
/// keyword becomes one of the object form. \pre there is a support, in a model whose supports can be inclined
void set_support_angle(Document& document, femoop::NodeId node, double degrees);

/// Lets the support yield along or about a degree of freedom: the spring takes the place of a spring or a block there.
/// A node that was free gets a support of it.
void set_spring(Document& document, femoop::NodeId node, const femoop::Spring& spring);

enum class Joint : std::uint8_t { Rigid, Hinged };
void set_joint(Document& document, femoop::NodeId node, Joint joint);

void set_material(Document& document, femoop::MemberId member, femoop::MaterialId material);
void set_section(Document& document, femoop::MemberId member, femoop::SectionId section);
void set_theory(Document& document, femoop::MemberId member, femoop::BeamTheory theory);

/// Can the depth of this member vary, as far as its section and the kind of structure go?
bool can_taper(const femoop::Model& model, const femoop::Member& member);
/// Gives it the depth of its section at both ends, for the hand to change. \pre can_taper
void taper(Document& document, femoop::MemberId member);
void make_prismatic(Document& document, femoop::MemberId member);

/// What sets a member apart from an ordinary beam.
enum class MemberTrait : std::uint8_t { Inextensible, Unshearable, Rigid, Bar };
enum class Switch : std::uint8_t { Off, On };
void set_trait(Document& document, femoop::MemberId member, MemberTrait trait, Switch state);
bool has_trait(const femoop::Member& member, MemberTrait trait);

enum class MemberEndName : std::uint8_t { Start, End };
/// A release takes the place of a spring on the same degree of freedom.
void set_release(Document& document, femoop::MemberId member, MemberEndName end, femoop::Dof dof, Switch state);

void set_load_axes(Document& document, const MemberLoadPlace& load, femoop::LoadAxes axes);
/// Of a distributed load. On makes its axes global, since only those are projected. \throws std::invalid_argument for
/// another kind of load
void set_projected(Document& document, const MemberLoadPlace& load, Switch state);

void set_title(Document& document, std::string title);
void set_notes(Document& document, std::string notes);

} // namespace frame
