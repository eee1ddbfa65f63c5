#include "apps/frame/document/fault/sentence.h"

namespace frame {

using femoop::FaultKind;
using ui::translatable;

// Those that are not here have no word of the file in them.
std::string_view spoken_pattern(FaultKind kind)
{
    switch (kind) {
    case FaultKind::FileEmpty: return translatable("the file is empty; choose another one");
    case FaultKind::JsonComment:
        return translatable("line {0}, column {1}: found {2}; a model file has no comments: take it away");
    case FaultKind::RepeatedKey: return translatable("{0} is given twice in the file; keep one of them");
    case FaultKind::RepeatedDof: return translatable("{0}: {1} is given twice in the file; keep one of them");
    case FaultKind::WrongType:
        return translatable("{0}: the file has {1} here, wanted {2}; correct the file in a text editor");
    case FaultKind::WrongTypeText:
        return translatable("{0}: the file has a text here, wanted {2}; correct the file in a text editor");
    case FaultKind::UnknownKey: return translatable("{0}: this word of the file is not known; take it out of the file");
    case FaultKind::UnknownKeyNear:
        return translatable("{0}: this word of the file is not known; perhaps {1} is meant: correct the file");
    case FaultKind::MissingKey: return translatable("{0}: {8} is missing in the file; add it");
    case FaultKind::UnknownFormat:
        return translatable("the file has format {0}, wanted 1; read it with a newer program");
    case FaultKind::UnknownChoice: return translatable("{0}: {1} is none of {2}; choose one of them");
    case FaultKind::UnknownChoiceNear: return translatable("{0}: {1} is none of {2}; perhaps {3} is meant");
    case FaultKind::WrongLineLoadSize:
        return translatable("{0}: found {1} values, wanted one or two, at the beginning and the end of the load; "
                            "leave out the others or add one");
    case FaultKind::BadMode:
        return translatable(
            "{0}: found {1}, wanted the number of a mode (1, 2, ...), the largest or the smallest; correct the file");
    case FaultKind::SizeWithoutShape:
        return translatable("{0}: {1} is the size of a shape; choose a shape or take {1} away");
    case FaultKind::QuantityWithoutUnit: return translatable("{0}: \"{1}\" has no unit; write \"{2}\" for example");

    case FaultKind::EmptyId: return translatable("{0}: the name is empty; give it one");
    case FaultKind::ControlCharacterInId:
        return translatable(
            "{0}: the name has a control character, such as a line break or a tab; use letters, digits and blanks");
    case FaultKind::RepeatedId: return translatable("{0}: the name is taken already; choose another");
    case FaultKind::DanglingReference: return translatable("{0}: something that it refers to is gone; choose another");
    case FaultKind::NotFinite: return translatable("{0}: {8} is {2}; give a finite number");
    case FaultKind::OutOfReach:
        return translatable("{0}: {8} is {2}, too far for stiffnesses to be reckoned with; "
                            "give a length up to {3}, and check its unit");
    case FaultKind::NotPositive: return translatable("{0}: {8} is {2}; give a value greater than 0");
    case FaultKind::Negative: return translatable("{0}: {8} is {2}; give 0 or a positive value");
    case FaultKind::ZeroStiffness:
        return translatable("{0}: {8} is {2}, which holds nothing; take it away or give a value greater than 0");
    case FaultKind::ZeroEndSpring:
        return translatable("{0}: {8} is {2}, which is a full release; release the end or give a value greater than 0");
    case FaultKind::RepeatedComponent: return translatable("{0}: {8} is given twice; keep one");
    case FaultKind::PoissonOutOfRange:
        return translatable("{0}: {8} is {1}; give a value greater than −1 and at most 0.5");
    case FaultKind::CentroidOutside:
        return translatable("{0}: {8} is {1}, more than the depth {2}; measure it from the −y' fibre");
    case FaultKind::ShapeSizeMissing: return translatable("{0}: the shape needs {2}; give {3}");
    case FaultKind::ShapeSizeUnwanted:
        return translatable("{0}: the shape has no {2}; take it away: its sizes are {3}");
    case FaultKind::TurnedNumbers:
        return translatable(
            "{0}: only a shape or a profile is turned on its side, and this section is given by numbers; "
            "exchange Iy and Iz, and Asy and Asz, or turn it back");
    case FaultKind::MissingProperty:
        return translatable(
            "{0}: {8} is missing, which member {3} of the {2} needs; give it, a shape or a profile ({9})");
    case FaultKind::RollerNotPlane:
        return translatable(
            "{0}: a roller is for plane trusses and plane frames, and this is a {1}; hold single directions instead");
    case FaultKind::AngleNotPlane:
        return translatable(
            "{0}: supports can be turned in plane trusses and plane frames, and this is a {1}; take the angle away");
    case FaultKind::FixedDofLacking:
        return translatable("{0}: fixes {1}, which a {2} does not have; take it away: there are {3}");
    case FaultKind::SpringDofLacking:
        return translatable("{0}: has a spring for {1}, which a {2} does not have; take it away: there are {3}");
    case FaultKind::MassDofLacking:
        return translatable("{0}: has a mass for {1}, which a {2} does not have; take it away: there are {3}");
    case FaultKind::OffsetSize:
        return translatable(
            "{0}: its offset at the {1} has {2} lengths, which a {3} does not have; give one per coordinate");
    case FaultKind::TrussOffsetAcross:
        return translatable(
            "{0}: the offset {2} at its {1} lies {3} across the member, whose moment no node of a truss can take; "
            "give the part along the member, {4}, or make the structure a {5} with bars");
    case FaultKind::ReleaseDofLacking:
        return translatable(
            "{0}: releases {1} at its {2}, which a member of a {3} does not have; take it away: there are {4}");
    case FaultKind::EndSpringDofLacking:
        return translatable(
            "{0}: has a spring for {1} at its {2}, which a member of a {3} does not have; take it away: there are {4}");
    case FaultKind::FoundationTooStiff:
        return translatable("{0}: the elastic foundation {1} is too stiff for the member of {2}; "
                            "give {3} or less, or hold its nodes by supports instead");
    case FaultKind::DepthsOutsidePlaneFrame:
        return translatable(
            "{0}: only members of a plane frame can be tapered, and this is a {1}; take its depths away");
    case FaultKind::DepthsBeside:
        return translatable("{0}: a tapered member cannot be a bar, rigid or on an elastic foundation yet; "
                            "take one of the two away");
    case FaultKind::DepthsOfSection:
        return translatable("{0}: section {1} cannot be tapered; give it a rectangle, box, I or channel by its "
                            "dimensions alone, not turned");
    case FaultKind::UpNot3d:
        return translatable("{0}: the direction up is for structures in space, and this is a {1}; take it away");
    case FaultKind::UpSize: return translatable("{0}: the direction up has {1} numbers, wanted 3; give x, y and z");
    case FaultKind::UpZero: return translatable("{0}: the direction up is the zero vector; give a direction");
    case FaultKind::UpAlongMember:
        return translatable("{0}: the direction up points along the member; give another one");

    case FaultKind::LoadDofLacking:
        return translatable("{0}: {8} works on {2}, which a {3} does not have there; take it away: there are {4}");
    case FaultKind::MissingDensity:
        return translatable("{0}: self-weight needs the density of material {1} (member {2}); fill in {8} ({9})");
    case FaultKind::MissingAreaForWeight:
        return translatable("{0}: self-weight needs the area of section {1} (member {2}); fill in {8} ({9})");
    case FaultKind::PositionBeforeStart:
        return translatable("{0}: {8} is {2}, before the start of member {3}; give a length from 0 to {4}");
    case FaultKind::PositionBeyondEnd:
        return translatable("{0}: {8} is {2}, beyond the end of member {3}; give a length from 0 to {4}");
    case FaultKind::LoadEndsBeforeStart: return translatable("{0}: goes from {1} to {2}; let it begin before it ends");
    case FaultKind::ProjectedLocalLoad:
        return translatable(
            "{0}: a load per projected length has global axes; choose these or the length of the member");
    case FaultKind::TorqueOnBar:
        return translatable("{0}: turns member {1} about its own axis, which a bar does not resist; "
                            "take the torque away, or let the member be no bar");
    case FaultKind::MissingExpansion:
        return translatable(
            "{0}: material {1} of member {2} has no coefficient of thermal expansion; fill in {8} ({9})");
    case FaultKind::MissingDepth:
        return translatable(
            "{0}: top and bottom differ, which needs the depth of section {1} (member {2}); fill in {8} ({9})");

    case FaultKind::CrossNeedsPlaneFrame:
        return translatable("moment distribution works on continuous beams and plane frames, not on a {0}; "
                            "make the structure a plane frame");
    case FaultKind::CrossTooLarge:
        return translatable("the structure has {0} nodes, and a sheet of moment distribution is made for {1} at most; "
                            "read its results in the frame app");
    case FaultKind::CrossWithoutCase: return translatable("there is no load case to distribute; add one");

    case FaultKind::ExpectedWithoutCase:
        return translatable("{0}: of which case? there are {1} load cases and combinations; name it in the file");
    case FaultKind::ExpectedKeyMissing: return translatable("{0}: {8} is missing in the file; add it");
    case FaultKind::ExpectedDofLacking: return translatable("{0}: a {2} has no component {1}; name another");

    case FaultKind::NoSuchPath: return translatable("{0}: there is no path {1}; add it or name another");
    case FaultKind::NoSuchTrain: return translatable("{0}: there is no train {1}; add it or name another");
    case FaultKind::NoSuchLine: return translatable("{0}: there is no influence line {1}; add it or name another");
    case FaultKind::NoSuchEnvelope: return translatable("{0}: there is no moving envelope {1}; add it or name another");
    default: return femoop::pattern(kind);
    }
}

} // namespace frame
