#include "femoop/model/fault/fault.h"

namespace femoop {

std::string_view pattern(FaultKind kind)
{
    switch (kind) {
    case FaultKind::NoSupport:
        return "no node is supported, so nothing keeps the structure from moving as a whole; add supports";
    case FaultKind::PartWithoutSupport:
        return "no node of the part {0} is supported, so nothing keeps it from moving as a whole; "
               "add supports or join it to the rest";
    case FaultKind::TooFewSupports:
        return "the supports hold {1} of the {2} ways in which the structure can move as a whole; "
               "add supports, or let them act in other directions";
    case FaultKind::PartWithTooFewSupports:
        return "the supports hold {1} of the {2} ways in which the part {0} can move as a whole; "
               "add supports, or join it to the rest";
    case FaultKind::MechanismSwayX:
        return "the structure can move without strain: nodes {0} sway to the right together; "
               "nothing holds ux; add a brace or a support";
    case FaultKind::MechanismSwayY:
        return "the structure can move without strain: nodes {0} move along y together; "
               "nothing holds uy; add a brace or a support";
    case FaultKind::MechanismSwayZ:
        return "the structure can move without strain: nodes {0} move up together; "
               "nothing holds uz; add a brace or a support";
    case FaultKind::MechanismMoveX:
        return "the structure can move without strain: node {0} moves along x; nothing holds ux; add a brace or a support";
    case FaultKind::MechanismMoveY:
        return "the structure can move without strain: node {0} moves along y; nothing holds uy; add a brace or a support";
    case FaultKind::MechanismMoveZ:
        return "the structure can move without strain: node {0} moves along z; nothing holds uz; add a brace or a support";
    case FaultKind::MechanismMoveOblique:
        return "the structure can move without strain: {0} can move along {1}; add a brace or a support";
    case FaultKind::MechanismTurn:
        return "the structure can move without strain: nodes {0} turn together about {1}; "
               "add {2}";
    case FaultKind::MechanismNodeTurns:
        return "the structure can move without strain: node {0} rotates freely, nothing holds {1}; "
               "add a support or a rigid joint";
    case FaultKind::MechanismSpin:
        return "the structure can move without strain: node {0} rotates freely, nothing holds {1}; "
               "add a support or a rigid joint, or take the moment away";
    case FaultKind::MechanismSpins:
        return "the structure can move without strain: {0} rotate freely; "
               "add a support or a rigid joint against the rotation";
    case FaultKind::MechanismMixed:
        return "the structure can move without strain: nodes {0} move, {1} along {2}; "
               "add {3}";
    case FaultKind::MechanismMemberSwings:
        return "the structure can move without strain: member {0} swings about node {1}, its other end is released; "
               "take a release away or hold the rotation of node {1}";
    case FaultKind::MechanismMemberFlies:
        return "the structure can move without strain: member {0} is loose, "
               "its releases leave {1} free; take a release away";
    case FaultKind::ConstraintConflict:
        return "case {1}: a settlement, temperature or misfit would deform members that are inextensible or rigid ({0}); "
               "take this property from one of them, or let a support move with it";
    case FaultKind::StiffnessBeyondRange:
        return "the stiffness at {0} is beyond the range of numbers; "
               "check E, the sections, the lengths and their units";
    case FaultKind::ResultsBeyondRange:
        return "case {0}: its forces or displacements are beyond the range of numbers; "
               "check the loads, the lengths and their units";
    case FaultKind::MemoryInsufficient:
        return "a system of {0} equations takes {1} GB of memory to solve, and {2} GB are free; "
               "close other programs or make the model smaller";
    case FaultKind::NearlySingular:
        return "structure is nearly a mechanism: condition estimate {0}, softest at {1}; "
               "results may have few correct digits; check supports, releases and very small stiffnesses";
    case FaultKind::HugeDisplacement:
        return "node {0} moves {1} in case {2}, which is no small displacement: "
               "the structure is nearly a mechanism, or far too soft; check supports, releases, stiffnesses and units";
    case FaultKind::InaccurateCase:
        return "case {0}: loads and reactions balance to {1} digits only, and no more of any result is sure; "
               "members of very unlike lengths or stiffnesses bring that: make them more alike";
    case FaultKind::IllConditionedCase:
        return "case {0} cannot be solved: the structure holds, but is too ill-conditioned for its forces to balance, "
               "even with 32 digits; use fewer members in a row, or members of more alike lengths and stiffnesses";

    case FaultKind::InaccurateBody:
        return "case {0}: loads and reactions balance to {1} digits only, and no more of any result is sure; slender "
               "parts, materials of very unlike stiffness, and elements that are very flat or of very unlike sizes bring "
               "that: make them less so";
    case FaultKind::IllConditionedBody:
        return "case {0} cannot be solved: the body is held, but too slender, its elements too flat or its materials too "
               "unlike for its forces to balance in 16 digits; use elements that are less flat, materials that are less "
               "unlike, or a frame in place of a slender plate";

    case FaultKind::InaccurateLines:
        return "influence lines: unit loads and their reactions balance to {0} digits only, and no more of any "
               "ordinate is sure; members of very unlike lengths or stiffnesses bring that: make them more alike";
    case FaultKind::IllConditionedLine:
        return "{0}: its influence line along the path from {1} to {2} cannot be computed: the structure holds, but is "
               "too ill-conditioned for its forces to balance, even with 32 digits; use fewer members in a row, or "
               "members of more alike lengths and stiffnesses";
    case FaultKind::LineBeyondRange:
        return "{0}: its influence line along the path from {1} to {2} is beyond the range of numbers; "
               "check E, the sections, the lengths and their units";

    case FaultKind::NothingHasMass: return "nothing has mass, so nothing vibrates; give a material a density";
    case FaultKind::RegionWithoutMass:
        return "regions {0} have no mass, since material {1} has no density; give it one if they have any";
    case FaultKind::MasslessMotion:
        return "something without mass can move freely, so its vibration has no frequency; hold it, or give its material "
               "a density";
    case FaultKind::TooFewModes: return "mode {0} wanted, the model has {1}; ask for fewer, or make the mesh finer";
    case FaultKind::ModeLostInRounding:
        return "the frequency of mode {0} is lost in rounding: a part is too slender for its elements, or soft beside the "
               "rest; use larger elements, or ask for fewer modes";
    case FaultKind::InaccurateMode:
        return "the frequency of mode {0} holds {1} digits only: the body is slender or its elements very small beside it";
    case FaultKind::ModesNotCounted:
        return "the {0} modes that were found are right, but one between them may be missing: counting them failed";

    case FaultKind::FileUnreadable: return "cannot read {0}: {1}; check the name and that you may read it";
    case FaultKind::FileUnwritable: return "cannot write {0}: {1}; choose another folder or name";
    case FaultKind::FileEmpty:
        return "the file is empty; a model file is a JSON object that begins {\"cremona\": 1, ...}";
    case FaultKind::FileNotUtf8:
        return "line {0}, column {1}: byte {2} is not UTF-8 text; save the file as UTF-8 (a model file is plain text)";
    case FaultKind::FileWithControlCharacter:
        return "line {0}, column {1}: control character {2}; "
               "a model file is plain text: is this another kind of file? Save it as UTF-8 text";
    case FaultKind::FileWithSecondMark:
        return "the file begins with two byte-order marks (U+FEFF), wanted none or one; save it again as UTF-8";
    case FaultKind::JsonTooDeep:
        return "line {0}, column {1}: brackets nest deeper than {2}; "
               "no model file needs that: look for a bracket that is never closed";
    case FaultKind::JsonCutOff:
        return "line {0}, column {1}: the file ends here with brackets or quotation marks still open; "
               "is it cut off? Close them or fetch the whole file";
    case FaultKind::JsonOpenText:
        return "line {0}, column {1}: text without a closing quotation mark; add the mark before the line ends";
    case FaultKind::JsonComment: return "line {0}, column {1}: found {2}; JSON has no comments: use \"notes\"";
    case FaultKind::JsonSingleQuotes: return "line {0}, column {1}: found {2}; write text in double quotation marks";
    case FaultKind::JsonTrailingComma: return "line {0}, column {1}: comma before {2}; take the comma away";
    case FaultKind::JsonMissingComma: return "line {0}, column {1}: a comma is missing before {2}; add it";
    case FaultKind::JsonNotFinite: return "line {0}, column {1}: found {2}; write a finite number";
    case FaultKind::JsonSpelling: return "line {0}, column {1}: found {2}; write {3}";
    case FaultKind::JsonNoNumber:
        return "line {0}, column {1}: found {2}, which is no number; write it like -12.5 or 3e-4";
    case FaultKind::JsonBareQuantity:
        return "line {0}, column {1}: found {2}; write a number with its unit in quotation marks, like \"12.5 kN\"";
    case FaultKind::JsonBareText: return "line {0}, column {1}: found {2}; write keys and texts between two \" marks";
    case FaultKind::JsonDecimalComma: return "line {0}, column {1}: found {2}; write a decimal point: {3}";
    case FaultKind::JsonNumberTooLarge:
        return "line {0}, column {1}: {2} is beyond the range of numbers (1.8e308); write a smaller one";
    case FaultKind::JsonAfterEnd:
        return "line {0}, column {1}: found {2} after the end of the model; "
               "a file holds one JSON object: take the rest away";
    case FaultKind::JsonUnexpected:
        return "line {0}, column {1}: found {2}, which JSON does not allow here; "
               "take it away, or look for a bracket or quotation mark that is missing before it";
    case FaultKind::RepeatedKey: return "{0}: key is given twice in one object; keep one of them";

    case FaultKind::RepeatedDof: return "{0}: \"{1}\" stands at {2} already; keep one of them";

    case FaultKind::WrongType: return "{0}: found {1}, wanted {2}; write it like {3}";
    case FaultKind::WrongTypeText: return "{0}: found a text {1}, wanted {2}; write it like {3}";
    case FaultKind::UnknownKey: return "{0}: unknown key; take it away or use one of {1}";
    case FaultKind::UnknownKeyNear: return "{0}: unknown key; did you mean \"{1}\"?";
    case FaultKind::MissingKey: return "{0}: \"{1}\" is missing; add it";
    case FaultKind::UnknownFormat:
        return "cremona: found format {0}, wanted 1; write \"cremona\": 1, or read this file with a newer program";
    case FaultKind::UnknownChoice: return "{0}: \"{1}\" is none of {2}; choose one of them";
    case FaultKind::UnknownChoiceNear: return "{0}: \"{1}\" is none of {2}; did you mean \"{3}\"?";
    case FaultKind::WrongCoordinateCount:
        return "{0}: found a list of {1}, wanted {2} lengths in {3}; give one per coordinate";
    case FaultKind::WrongNodeCount:
        return "{0}: found a list of {1}, wanted the names of 2 nodes; name the first and the second";
    case FaultKind::WrongVectorSize: return "{0}: found a list of {1}, wanted 3 numbers; give x, y and z";
    case FaultKind::WrongLineLoadSize:
        return "{0}: found a list of {1}, wanted one number or two [value at \"from\", value at \"to\"]; "
               "leave out the others or add one";
    case FaultKind::BadPercentage: return "{0}: cannot read \"{1}\" as a percentage; write it like \"50%\"";
    case FaultKind::BadMode:
        return "{0}: found {1}, wanted the number of a mode or the rank of a face (1, 2, ...), \"max\" or \"min\"; write one of these";
    case FaultKind::SizeWithoutShape: return "{0}: \"{1}\" is the size of a shape; add \"shape\" or take \"{1}\" away";
    case FaultKind::NoSuchNode: return "{0}: no node \"{1}\"; add the node or name another";
    case FaultKind::NoSuchNodeNear: return "{0}: no node \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchMember: return "{0}: no member \"{1}\"; add the member or name another";
    case FaultKind::NoSuchMemberNear: return "{0}: no member \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchMaterial: return "{0}: no material \"{1}\"; add the material or name another";
    case FaultKind::NoSuchMaterialNear: return "{0}: no material \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchSection: return "{0}: no section \"{1}\"; add the section or name another";
    case FaultKind::NoSuchSectionNear: return "{0}: no section \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchCase: return "{0}: no load case or combination \"{1}\"; add it or name another";
    case FaultKind::NoSuchCaseNear: return "{0}: no load case or combination \"{1}\"; did you mean \"{2}\"?";

    case FaultKind::QuantityWithoutNumber:
        return "{0}: \"{1}\" does not begin with a number; write a number and its unit, like \"{2}\"";
    case FaultKind::QuantityWithTypographicMinus:
        return "{0}: \"{1}\" begins with a dash, wanted a number and its unit; write the minus as a hyphen: \"{2}\"";
    case FaultKind::QuantityWithoutUnit:
        return "{0}: \"{1}\" has no unit; write \"{2}\" for example, or a number without quotation marks";
    case FaultKind::QuantityWithComma: return "{0}: \"{1}\" has a comma; write a decimal point";
    case FaultKind::QuantityBadUnit:
        return "{0}: \"{1}\": cannot read the unit at \"{2}\"; join units with * / and ^, like kN*m/rad or cm^4";
    case FaultKind::QuantityUnknownUnit:
        return "{0}: \"{1}\": no unit \"{2}\"; there are m mm cm km in ft, "
               "N kN MN lbf kip tf kgf, Pa kPa MPa GPa psi ksi, kg g t lb, s ms Hz, deg rad, K degC degF";
    case FaultKind::QuantityUnknownUnitNear: return "{0}: \"{1}\": no unit \"{2}\"; did you mean \"{3}\"?";
    case FaultKind::QuantityWrongDimension: return "{0}: \"{1}\" measures {2}, wanted {3}, in {4} for example";
    case FaultKind::QuantityUnwantedUnit: return "{0}: \"{1}\" measures {2}, wanted a plain number; take the unit away";
    case FaultKind::QuantityTooLarge:
        return "{0}: \"{1}\" is beyond the range of numbers; write one that is nearer to 1, or 0 where nothing is meant";

    case FaultKind::EmptyId: return "{0}: \"id\" is empty; give it a name";
    case FaultKind::ControlCharacterInId:
        return "{0}: the id has a control character, such as a line break or a tab; use letters, digits and blanks";
    case FaultKind::RepeatedId: return "{0}: the id is taken by {1} already; choose another";
    case FaultKind::DanglingReference:
        return "{0}: refers to entry {2} of {1}, which has {3}; refer to one that is there";
    case FaultKind::NotFinite: return "{0}: {1} is {2}; give a finite number";
    case FaultKind::OutOfReach:
        return "{0}: {1} is {2}, too far for stiffnesses to be reckoned with; "
               "give a length up to {3}, and check its unit";
    case FaultKind::NotPositive: return "{0}: {1} is {2}; give a value greater than 0";
    case FaultKind::Negative: return "{0}: {1} is {2}; give 0 or a positive value";
    case FaultKind::ZeroStiffness:
        return "{0}: {1} is {2}, which holds nothing; take it away or give a value greater than 0";
    case FaultKind::ZeroEndSpring:
        return "{0}: {1} is {2}, which is a full release; write \"release\": [\"{3}\"] or give a value greater than 0";
    case FaultKind::RepeatedComponent: return "{0}: {1} is given twice; keep one";
    case FaultKind::PoissonOutOfRange: return "{0}: nu is {1}; give a value greater than -1 and at most 0.5";
    case FaultKind::CentroidOutside:
        return "{0}: yc is {1}, more than the depth h = {2}; measure it from the -y' fibre";
    case FaultKind::TurnedNumbers:
        return "{0}: \"turned\" is for a shape or a profile, and this section is given by numbers; exchange Iy and Iz, and "
               "Asy and Asz, or take it away";
    case FaultKind::ShapeAndProfile: return "{0}: has both a shape and a profile; keep one";
    case FaultKind::ShapeSizeMissing: return "{0}: shape {1} needs {2}; add \"{3}\"";
    case FaultKind::ShapeSizeUnwanted: return "{0}: shape {1} has no \"{2}\"; take it away: its sizes are {3}";
    case FaultKind::ShapeTooThick: return "{0}: {1} is {2}, which is not less than {3} = {4}; make it thinner";
    case FaultKind::UnknownProfile:
        return "{0}: no profile \"{1}\"; there are IPE, HEA, HEB, HEM, UPN, W (AISC and BR), HP, L, CHS, SHS and RHS: "
               "name one of these, or give the section's shape or properties";
    case FaultKind::UnknownProfileNear: return "{0}: no profile \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::MissingProperty:
        return "{0}: {1} is missing, which {2} needs for member \"{3}\"; add it, a shape or a profile";
    case FaultKind::IyzLeftOut:
        return "{0}: shape {1} bends about y' and z' through its centroid: Iyz and the shear centre's "
               "distance are left out; expect this where the member is held against bending sideways and twisting";
    case FaultKind::RollerNotPlane:
        return "{0}: \"roller\" is for truss2d and frame2d, this is {1}; use {\"fixed\": [...]}";
    case FaultKind::AngleNotPlane: return "{0}: \"angle\" is for truss2d and frame2d, this is {1}; take it away";
    case FaultKind::FixedDofLacking: return "{0}: fixes {1}, which {2} does not have; take it away: there are {3}";
    case FaultKind::SpringDofLacking:
        return "{0}: has a spring for {1}, which {2} does not have; take it away: there are {3}";
    case FaultKind::SpringOnFixedDof: return "{0}: {1} is fixed and has a spring; keep one";
    case FaultKind::MassDofLacking:
        return "{0}: has a mass for {1}, which {2} does not have; take it away: there are {3}";
    case FaultKind::MemberWithoutMaterial: return "{0}: has no material; name one (only a rigid member needs none)";
    case FaultKind::MemberWithoutSection: return "{0}: has no section; name one (only a rigid member needs none)";
    case FaultKind::SameNodeTwice: return "{0}: goes from node \"{1}\" to itself; name two different nodes";
    case FaultKind::ZeroLength:
        return "{0}: length is {1} because nodes \"{2}\" and \"{3}\" are both at {4}; move a node or delete the member";
    case FaultKind::OffsetsEatMember:
        return "{0}: its offsets leave nothing of the {1} between its nodes; shorten them";
    case FaultKind::OffsetSize:
        return "{0}: its {1} offset has {2} lengths, which {3} does not; give one per coordinate";
    case FaultKind::TrussOffsetAcross:
        return "{0}: {1} offset {2} lies {3} across the member, whose moment no node of a truss can take; "
               "give the part along the member, {4}, or use {5} with bars";
    case FaultKind::ReleaseDofLacking:
        return "{0}: releases {1} at its {2}, which a member of {3} does not have; take it away: there are {4}";
    case FaultKind::EndSpringDofLacking:
        return "{0}: has a spring for {1} at its {2}, which a member of {3} does not have; take it away: there are {4}";
    case FaultKind::ReleaseAndSpring: return "{0}: {1} at its {2} is released and has a spring; keep one";
    case FaultKind::HingeAndSpring:
        return "{0}: {1} at its {2} has a spring, but node \"{3}\" is a hinge, which releases it; take one away";
    case FaultKind::TensionAndCompressionOnly:
        return "{0}: takes tension only and compression only, so nothing; keep one";
    case FaultKind::FoundationOfBar:
        return "{0}: has a foundation but carries axial force only; take the foundation away or use a frame member";
    case FaultKind::FoundationTooStiff:
        return "{0}: foundation y {1} is too stiff for the member of {2}; "
               "give {3} or less, or hold its nodes by supports instead";
    case FaultKind::DepthCount:
        return "{0}: found a list of {1} depths, wanted 2; give that at the first end and that at the second";
    case FaultKind::DepthsOutsidePlaneFrame:
        return "{0}: has depths, which are for members of frame2d; this is {1}: take them away";
    case FaultKind::DepthsBeside: return "{0}: has depths and {1}, which do not go together yet; take one of them away";
    case FaultKind::DepthsOfSection:
        return "{0}: its depths cannot vary the section \"{1}\"; give it a shape rectangle, box, i or c by its "
               "dimensions alone, not turned";
    case FaultKind::DepthTooSmall:
        return "{0}: depth {1} leaves no room between the flanges of section \"{2}\"; give more than {3}";
    case FaultKind::DepthsTooDifferent:
        return "{0}: depths {1} and {2} differ too much for one member; divide it, or give at most {3} times the smaller";
    case FaultKind::OneWayMember:
        return "{0}: takes tension only or compression only, which the linear analysis cannot follow: "
               "it counts as an ordinary member there";
    case FaultKind::UpNot3d: return "{0}: \"up\" is for 3D models, this is {1}; take it away";
    case FaultKind::UpSize: return "{0}: \"up\" has {1} numbers, wanted 3; give x, y and z";
    case FaultKind::UpZero: return "{0}: \"up\" is the zero vector; give a direction";
    case FaultKind::UpAlongMember: return "{0}: \"up\" points along the member; give another direction";
    case FaultKind::UnusedMaterial: return "{0}: no member uses this material; use it or delete it";
    case FaultKind::UnusedSection: return "{0}: no member uses this section; use it or delete it";
    case FaultKind::NodeWithoutMembers: return "{0}: no member is joined to this node; join one or delete the node";
    case FaultKind::NoMembers: return "the model has no members: there is nothing to analyse; add some";
    case FaultKind::CoincidentNodes:
        return "{0}: lies where node \"{1}\" lies, at {2}; the two are not joined: use one of them or move one";
    case FaultKind::MembersCross:
        return "{0}: crosses member \"{1}\" at {2} without a node; if they are joined there, add a node and split both";
    case FaultKind::MembersOverlap:
        return "{0}: lies on member \"{1}\" around {2}; delete one, or split them where they part";
    case FaultKind::MemberPassesNode:
        return "{0}: passes node \"{1}\" at {2} without being joined to it; "
               "if it is joined there, split it at the node";
    case FaultKind::MoreCrossings: return "and {0} more members that cross, overlap or pass a node";

    case FaultKind::LoadDofLacking:
        return "{0}: {1} works on {2}, which {3} does not have there; take it away: there are {4}";
    case FaultKind::LoadedNodeWithoutMembers:
        return "{0}: node \"{1}\" carries a load but no member is joined to it; join one or move the load";
    case FaultKind::EmptyLoad: return "{0}: does nothing: it has no component; give one or delete it";
    case FaultKind::SettlementOfFreeDof:
        return "{0}: {1} of node \"{2}\" is free, so it cannot be made to settle; "
               "fix it, give it a spring, or use a load";
    case FaultKind::MissingDensity:
        return "{0}: self_weight needs the density of material \"{1}\" (member \"{2}\"); add \"density\"";
    case FaultKind::MissingAreaForWeight:
        return "{0}: self_weight needs the area of section \"{1}\" (member \"{2}\"); add \"A\"";
    case FaultKind::PositionBeforeStart:
        return "{0}: \"{1}\" is {2}, before the start of member \"{3}\"; give a length from 0 to {4}";
    case FaultKind::PositionBeyondEnd:
        return "{0}: \"{1}\" is {2}, beyond the end of member \"{3}\"; give a length from 0 to {4}";
    case FaultKind::LoadEndsBeforeStart: return "{0}: goes from {1} to {2}; \"from\" has to be less than \"to\"";
    case FaultKind::ProjectedLocalLoad:
        return "{0}: a projected load has global axes; take \"axes\" or \"projected\" away";
    case FaultKind::ProjectedMoment:
        return "{0}: {1} is a moment, which has no projected length; give it in a load of its own";
    case FaultKind::TorqueOnBar:
        return "{0}: turns member \"{1}\" about its own axis, which a bar does not resist; "
               "take the torque away, or take \"bar\" from the member";
    case FaultKind::TemperatureOfRigid:
        return "{0}: member \"{1}\" has no material and section that could be warmed; load another member";
    case FaultKind::MissingExpansion:
        return "{0}: material \"{1}\" of member \"{2}\" has no coefficient of thermal expansion; add \"alpha\"";
    case FaultKind::MissingDepth:
        return "{0}: top and bottom differ, which needs the depth of section \"{1}\" (member \"{2}\"); add \"h\"";
    case FaultKind::MisfitOfGrillage:
        return "{0}: a misfit works along the member, which a grillage cannot feel; take the load away";
    case FaultKind::CombinationCircle: return "{0}: names itself: {1}; break the circle";

    case FaultKind::CrossNeedsPlaneFrame:
        return "moment distribution works on continuous beams and plane frames, not on a {0}; make the model a frame2d";
    case FaultKind::CrossRigidMember:
        return "member {0} is rigid, and moment distribution has no stiffness factor for it; "
               "give it a section, or join its nodes";
    case FaultKind::CrossSkewOffset:
        return "member {0} has an offset across its axis, which couples its axial force with the moments at its joint; "
               "take the offset away or let it lie along the member";
    case FaultKind::CrossAxialSpring:
        return "member {0} has a spring along its axis, "
               "and moment distribution takes members as axially rigid; take the spring away";
    case FaultKind::CrossHeldElongation:
        return "case {1}: a temperature or misfit would change the length of members that are held at both ends ({0}), "
               "and moment distribution takes members as axially rigid; "
               "let an end move along the member, or distribute another case";
    case FaultKind::CrossHeldSettlement:
        return "case {1}: a settlement would change the length of members ({0}), "
               "and moment distribution takes members as axially rigid; "
               "take away the settlement along them, or distribute another case";
    case FaultKind::CrossTooLarge:
        return "the structure has {0} nodes, and a sheet of moment distribution is made for {1} at most; use solve";
    case FaultKind::CrossWithoutCase: return "the model has no load case to distribute; add one to load_cases";
    case FaultKind::CrossJointFree:
        return "joint {0} has no stiffness against rotation, so nothing takes its moment {1}; "
               "join a member rigidly to it, hold its rotation, or take the moment away";
    case FaultKind::CrossNoSuchJoint: return "{0} is no joint that can be balanced; choose from {1}";
    case FaultKind::CrossSteps:
        return "after {0} steps joint {2} still has an unbalance of {1}, more than the tolerance {3}; "
               "give a larger tolerance, more digits, or an order with every joint";
    case FaultKind::CrossSwayUndetermined:
        return "the sways of the structure are resisted by nothing, so that their equations have no solution; "
               "add a brace or a support";
    case FaultKind::CrossNoSuchEnd: return "{0}: there is no member end \"{1}\"; choose from {2}";
    case FaultKind::CrossNodeWithoutImage:
        return "the structure is not symmetric about x = {1}: "
               "node {0} has no mirror image at {2}; move a node, or balance the whole structure";
    case FaultKind::CrossEndWithoutImage:
        return "the structure is not symmetric about x = {1}: "
               "member end {0} has no mirror image at node {2} with the same stiffness and carry-over; "
               "make members and supports alike on both sides, or balance the whole structure";
    case FaultKind::CrossSkewLoads:
        return "the loads are neither symmetric nor antisymmetric about x = {4}: "
               "fixed-end moments or loads on joints are {1} at {0} and {3} at {2}, wanted "
               "opposite ones everywhere or equal ones everywhere; change a load, or balance the whole structure";
    case FaultKind::CrossSkewSway:
        return "the sway with the prop at node {0} is neither symmetric nor antisymmetric about x = {1}; "
               "hold the sway, or balance the whole structure";
    case FaultKind::CrossSheetTooLong: return "{0}: found {1} rows, and the sheet has {2}; give as many";

    case FaultKind::ExpectedWithoutCase:
        return "{0}: which case? the file has {1} load cases and combinations; add \"case\"";
    case FaultKind::ExpectedKeyMissing: return "{0}: a check of a {1} needs \"{2}\"; add it";
    case FaultKind::ExpectedNodeAndMember: return "{0}: names a node and a member; keep one";
    case FaultKind::ExpectedDofLacking: return "{0}: component {1} does not exist in {2}; name another";
    case FaultKind::ExpectedReactionOfFreeNode:
        return "{0}: node \"{1}\" has no support, so no reaction; name a supported node";

    case FaultKind::NoSuchPath: return "{0}: no path \"{1}\"; add it to paths or name another";
    case FaultKind::NoSuchPathNear: return "{0}: no path \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchTrain: return "{0}: no train \"{1}\"; add it to trains or name another";
    case FaultKind::NoSuchTrainNear: return "{0}: no train \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchLine: return "{0}: no influence line \"{1}\"; add it to influence_lines or name another";
    case FaultKind::NoSuchLineNear: return "{0}: no influence line \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchEnvelope:
        return "{0}: no moving envelope \"{1}\"; add it to moving_envelopes or name another";
    case FaultKind::NoSuchEnvelopeNear: return "{0}: no moving envelope \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::PathWithoutMembers: return "{0}: has no members, so nothing moves along it; name some";
    case FaultKind::PathBroken:
        return "{0}: member \"{3}\" ({4}) does not begin where member \"{1}\" ({2}) ends; "
               "name members that follow one another, node by node";
    case FaultKind::PathMissing:
        return "{0}: along which path does the load move? name a path, or members that follow one another";
    case FaultKind::UnitLoadZero:
        return "{0}: the unit load has no direction; give a component that is not 0, or leave the load out: it is down";
    case FaultKind::BarLoadedBetweenNodes:
        return "{0}: what stands between the nodes of {1} is carried to these as by a simple beam, since a bar takes axial force only";
    case FaultKind::PositionOffPath: return "{0}: position {1} is off the path; give a length from 0 to {2}";
    case FaultKind::BadPathPosition:
        return "{0}: cannot read {1} as a position; write a length, or \"4-\" and \"4+\" for just before and after 4";
    case FaultKind::WrongValueCount: return "{0}: found {1} values for {2} positions; give one for each";
    case FaultKind::TrainWithoutLoad: return "{0}: has neither axles nor a uniform load; give one of them";
    case FaultKind::AxlesAndSpacings:
        return "{0}: number of axles {1}, of spacings {2}, wanted {3}; give one spacing behind each axle but the last";
    case FaultKind::RangeOfNoSpacing:
        return "{0}: there is no spacing \"{1}\" that could have a range; "
               "count from 1, behind the leading axle: there are {2}";
    case FaultKind::RangeReversed: return "{0}: goes from {1} down to {2}; give the smaller value first";
    case FaultKind::WrongRangeSize: return "{0}: found a list of {1}, wanted 2 lengths; give the least and the most";
    case FaultKind::EnvelopeWithoutTrains: return "{0}: names no train; name one or more";
    case FaultKind::EffectNotMoving: return "{0}: \"{1}\" is no effect of a moving load; ask for {2}";

    case FaultKind::RedundantNoForce:
        return "{0}: {1} is no force that could be released; name a reaction or a section force";
    case FaultKind::RedundantReleased:
        return "{0}: {1} is released already, nothing holds there; name a force that the structure carries";
    case FaultKind::RedundantInsideBar:
        return "{0}: {1} is inside a bar, whose parts could turn once it is cut there; cut it at one of its ends";
    case FaultKind::RedundantTwice: return "{0}: {1} is named twice; name another force, or leave it out";
    case FaultKind::RedundantsTooMany:
        return "the structure is {0} times statically indeterminate; more than {1} redundants are not chosen by the "
               "program: name those to release";
    case FaultKind::RedundantsNone:
        return "the structure is statically determinate: it has no redundants, equilibrium alone gives all forces";
    case FaultKind::RedundantsUnstrained:
        return "{0} strain nothing in the primary structure, so that no equation gives them; release other forces, or "
               "give inextensible and rigid members a stiffness";
    case FaultKind::PrimaryMoves: return "the structure does not stand without {0}; release other forces";

    case FaultKind::PlaneModelElsewhere:
        return "{0}: {1} is a plane model, for which this is not built yet; `check`, `mesh`, `solve`, `verify`, `render` and `convert` read it";
    case FaultKind::EdgesWithoutElements:
        return "{0}: found the kind \"edges\" without \"elements\", wanted line, arc, circle, ellipse, bezier or spline; draw the curve, or give the mesh";
    case FaultKind::CurvePlace: return "{0}: is no place of a curve; name a point or write [x, y], like [2.5, 0]";
    case FaultKind::EllipseAxes: return "{0}: an ellipse has two half axes; write [a, b], like [3, 2]";
    case FaultKind::BadDivision:
        return "{0}: found {1}, wanted a whole number of parts from 1 to 1000000; write 8, or {\"n\": 8, \"ratio\": 2}";
    case FaultKind::DrawnPlaceCount: return "{0}: found a list of {1} places, wanted {2}; add some or take some away";
    case FaultKind::CurveWithoutLength:
        return "{0}: a part of this curve has no length: its places are one to within snap; move one or take it away";
    case FaultKind::ArcPlacesInLine:
        return "{0}: its three places lie in one line, so that no circle goes through them; move one, or draw a line";
    case FaultKind::ArcRadiiDiffer:
        return "{0}: its ends are {1} and {2} from the centre, wanted one radius; move an end or the centre";
    case FaultKind::EllipsePlaceOff: return "{0}: an end lies {1} off the ellipse; move it, or change the axes";
    case FaultKind::CurvesRunTogether:
        return "{0}: runs along curve \"{1}\" for a stretch, which only straight lines and arcs of one circle may do; end it there";
    case FaultKind::CurveRunsBack:
        return "{0}: runs back along itself, since what draws it is in one line; put its places in order, or draw straight lines";
    case FaultKind::CurveTooNear:
        return "{0}: comes so near to other curves, a few times snap, that the regions there cannot be told apart; move it, or give a smaller \"snap\"";
    case FaultKind::SnapTooSmall:
        return "snap: found {0}, wanted {1} or more, below which the drawing's coordinates are not told apart; give a larger one";
    case FaultKind::DivisionsOfPieces:
        return "{0}: \"divide\" lists {1} entries for {2} pieces from vertex to vertex; give one of each, or one for all";
    case FaultKind::HoleWithMaterial: return "{0}: a hole is left empty; take its material or \"hole\" away";
    case FaultKind::RegionPlaceOutside:
        return "{0}: no face of the drawing is at {1}; give a place inside closed curves";
    case FaultKind::RegionPlaceOnCurve: return "{0}: {1} lies on curve \"{2}\"; give a place inside a face";
    case FaultKind::RegionPlaceTaken: return "{0}: the face at {1} is that of {2} already; give another place";
    case FaultKind::SecondRestOfFaces:
        return "{0}: takes all the rest of the faces, as {1} does; give one of them a place \"at\"";
    case FaultKind::NoFaceLeft: return "{0}: no face is left for it; close an outline or delete the region";
    case FaultKind::FaceWithoutRegion:
        return "the face at {0}, of area {1}, is in no region and is left empty; give it a region, or a hole";
    case FaultKind::DrawnPointAlone: return "{0}: no curve goes through this point; use it or delete it";
    case FaultKind::CurveDangles: return "{0}: a part of this curve bounds nothing; let it go on, or delete it";
    case FaultKind::PlacesMerged:
        return "{0}: meets {1} in one vertex at {2}, though they lie up to {3} from it, since snap is {4}; draw them at one place, or give a smaller snap";
    case FaultKind::SharpCorner:
        return "the corner at {0} has an angle of {1} degrees, so that elements there are poor; widen it";
    case FaultKind::TouchesNoMaterial:
        return "{0}: \"{1}\" touches no material, so that nothing takes it; put a region beside it or take it away";
    case FaultKind::PointsAtOnePlace:
        return "{0}: this point and {1} are one place to within snap, and both are supported; put the support on one of them";
    case FaultKind::MinAngleRange:
        return "{0}: found min_angle {1}, wanted more than 0 and at most 33 degrees; give a smaller one";
    case FaultKind::CornerCount:
        return "{0}: found {1} corners, wanted four points of its outline, or three with the method trilateral; name as many";
    case FaultKind::NothingToMesh:
        return "no face of the drawing has material: no mesh can be made; add an entry to \"regions\"";
    case FaultKind::MeshMethodOfElement:
        return "{0}: the method {1} does not make the element {2}; choose {3}, or the method auto";
    case FaultKind::MappedInside:
        return "{0}: the method {1} is for one outline with nothing inside; choose the method auto";
    case FaultKind::MappedVertices:
        return "{0}: the method {1} is for {2} corners, and its outline has {3} vertices; name {2} of its points as \"corners\"";
    case FaultKind::MappedCornerOff: return "{0}: the corner \"{1}\" is no vertex of its outline; name a point on it";
    case FaultKind::MappedCornerOrder:
        return "{0}: its corners do not follow one another around the outline; list them in that order";
    case FaultKind::MappedSidesDiffer:
        return "{0}: wanted equally many parts on opposite sides, found {2} ({1}) and {4} ({3}); divide them alike";
    case FaultKind::TrilateralSidesDiffer:
        return "{0}: the three sides of a trilateral region have equally many parts, found {2} ({1}) and {4} ({3}); divide them alike";
    case FaultKind::TrilateralOdd:
        return "{0}: a trilateral region of {1} has an even number of parts on each side, found {2}; divide them otherwise, or choose triangles";
    case FaultKind::MeshOrdersDiffer:
        return "{0}: its elements {1} and those of {2}, {3}, share a border, where only one of them has nodes in the middle of edges; choose both with or both without them";
    case FaultKind::MeshTooLarge:
        return "the mesh would have about {0} elements, wanted {1} at most; give a larger \"size\"";
    case FaultKind::MeshEdgesCross:
        return "{0}: straight parts of {1} and {2} cross or touch where the curves do not; divide them finer";
    case FaultKind::MeshElementTurned:
        return "{0}: the element at {1} is turned inside out by the curves around it; divide them finer, or choose the method auto";
    case FaultKind::MeshAngleMissed:
        return "{0}: the smallest angle of its mesh is {1} degrees, at {3}, where {2} were asked for: parts of its outline are long there beside the distance between them, or a corner is sharp; divide the curves finer there";
    case FaultKind::CheckFaceOutside: return "{0}: no face of the drawing is at {1}; give a place inside closed curves";
    case FaultKind::CheckFaceRank: return "{0}: asks for face {1} of {2}; give a smaller number";
    case FaultKind::CheckFacePlace:
        return "{0}: a check of {1} needs to know of what; give \"at\", \"region\" or \"which\"";
    case FaultKind::NoSuchPoint: return "{0}: no point \"{1}\"; add the point or name another";
    case FaultKind::NoSuchPointNear: return "{0}: no point \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchCurve: return "{0}: no curve \"{1}\"; add the curve or name another";
    case FaultKind::NoSuchCurveNear: return "{0}: no curve \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::NoSuchRegion: return "{0}: no region \"{1}\"; add the region or name another";
    case FaultKind::NoSuchRegionNear: return "{0}: no region \"{1}\"; did you mean \"{2}\"?";
    case FaultKind::CurveKindWithElements:
        return "{0}: found the kind {1} beside \"elements\", wanted edges; name the corners of consecutive element edges";
    case FaultKind::ElementPointCount:
        return "{0}: found a list of {1}, wanted the names of {2} points of a {3}; name its corners counter-clockwise, then middle nodes, then the centre";
    case FaultKind::ElementNoArea:
        return "{0}: its points lie in one line, so that it has no area; move a point or delete the element";
    case FaultKind::ElementClockwise: return "{0}: its corners run clockwise; list them counter-clockwise";
    case FaultKind::ElementDistorted:
        return "{0}: too distorted: its Jacobian is {1} at {2}, wanted a positive one; keep its corners convex and middle nodes near mid-side";
    case FaultKind::PointLeftOfAxis:
        return "{0}: x is {1}, wanted 0 or more in an axisymmetric model, where it is the radius; move the point";
    case FaultKind::FormulationLacking:
        return "{0}: the formulation {1} is not made for a {2} in {3}; choose standard or other elements";
    case FaultKind::RegionWithoutThickness:
        return "{0}: has no thickness, which a plane stress needs; add \"thickness\"";
    case FaultKind::ThicknessOfRevolution:
        return "{0}: has a thickness, which an axisymmetric body lacks; take it away";
    case FaultKind::ShearModulusInPlane: return "{0}: gives G, which a plane model takes from E and nu; take it away";
    case FaultKind::IncompressibleInPlane:
        return "{0}: nu is {1}, wanted less than 0.5 in {2}, where the mean stress would be unknown; give 0.4999 for example";
    case FaultKind::CurveTooShort:
        return "{0}: found a list of {1}, wanted 2 points or more; a curve without length has no edge: name its nodes";
    case FaultKind::CurveWithoutEdge:
        return "{0}: no element has an edge from point \"{1}\" to point \"{2}\"; name the corners of consecutive element edges";
    case FaultKind::PressureInside:
        return "{0}: curve \"{1}\" has material on both sides, wanted one, into which a pressure pushes; give a traction";
    case FaultKind::LoadOnTwoThicknesses:
        return "{0}: curve \"{1}\" parts regions of unlike thickness; this force per area acts on that of region \"{2}\", not of "
               "\"{3}\"; with kind \"line\" it is one per length, which needs none";
    case FaultKind::PointWithoutElements:
        return "{0}: no element meets point \"{1}\", so that nothing takes it; join an element or take it away";
    case FaultKind::LonePoint: return "{0}: no element meets this point; use it or delete it";
    case FaultKind::RegionWithoutElements: return "{0}: no element is in this region; give it elements or delete it";
    case FaultKind::NoElements: return "the model has no elements: there is nothing to analyse; add some";
    case FaultKind::AxesAndAngle: return "{0}: has local axes and an angle; keep one";
    case FaultKind::CurveAxesOfPoint:
        return "{0}: {1} follows a curve, and a point has none; give \"fixed\" and \"angle\"";
    case FaultKind::TieOfTurnedNode:
        return "{0}: ties its nodes along x or y, but point \"{1}\" is held in turned axes; take the tie or the angle away";
    case FaultKind::SettlementPlace: return "{0}: settles a point or a curve, one of them; give \"point\" or \"curve\"";
    case FaultKind::SettlementOfFreeCurve:
        return "{0}: {1} of curve \"{2}\" is free, so it cannot be made to settle; fix it, give it a spring, or use a load";
    case FaultKind::SettlementConflict:
        return "{0}: point \"{1}\" would settle by {2} and by {3} in one direction; give one of them";
    case FaultKind::SettlementOffAxis:
        return "{0}: point \"{1}\" is on the axis of revolution, where ux = 0, and would leave it by {2}; take this away";
    case FaultKind::RegionWithoutDensity:
        return "{0}: needs the density of material \"{1}\" (region \"{2}\"); add \"density\"";
    case FaultKind::RegionWithoutExpansion:
        return "{0}: needs the coefficient of thermal expansion of material \"{1}\" (region \"{2}\"); add \"alpha\"";
    case FaultKind::LineLoadOfRevolution:
        return "{0}: a force per length of the curve does not say how far it reaches around the axis; give a traction";
    case FaultKind::AboutOfRevolution: return "{0}: an axisymmetric body turns about its axis; take \"about\" away";
    case FaultKind::FieldNeedsCurve:
        return "{0}: varies along a curve, and there is none here; give a number, a polynomial or a table along x, y or r";
    case FaultKind::FieldEndsSize:
        return "{0}: found a list of {1}, wanted 2 values; give that at the start of the curve and that at its end";
    case FaultKind::PolynomialTerm:
        return "{0}: is no term of a polynomial; write [factor, power of x, power of y] with whole powers from 0 to 12, like [2.5, 1, 0]";
    case FaultKind::TableRow: return "{0}: is no row of a table; write [place, value], like [0, 2.5]";
    case FaultKind::TableNotAscending:
        return "{0}: its place is not beyond that of the row before; let the places ascend";
    case FaultKind::EmptyField: return "{0}: is empty, so it has no value; give an entry or leave it out";
    case FaultKind::TooManyElements: return "found {0} elements, wanted {1} at most; make the mesh coarser";
    case FaultKind::NearlyIncompressible:
        return "{0}: nu is {1}, so near to 0.5 that standard elements lock; choose b_bar for Q4, reduced for Q8, or Q9";
    case FaultKind::CheckPlace: return "{0}: a check of a {1} needs one place; give \"point\" or \"at\"";
    case FaultKind::CheckOutside: return "{0}: no element is at {1}; give a place in the material";
    case FaultKind::CheckRegionNeeded: return "{0}: regions {1} meet here and their stresses differ; add \"region\"";
    case FaultKind::CheckRegionElsewhere: return "{0}: region \"{1}\" has no element here; name another";
    case FaultKind::CheckGaussPlace:
        return "{0}: \"gauss\" goes with an extreme, over all integration points; read a place smoothed or by element";
    case FaultKind::CheckNotSupported:
        return "{0}: nothing holds it, so it has no reaction; name a point or a curve with a support";
    case FaultKind::CheckPlaceSize: return "{0}: is no place; write [x, y], like [2.5, 0]";
    case FaultKind::CutSize: return "{0}: is no cut; write its two ends [[x1, y1], [x2, y2]], apart from one another";
    case FaultKind::CutOutside: return "{0}: the cut meets no material; move it";
    case FaultKind::CutOfRevolution: return "{0}: a cut through an axisymmetric body has no N, V and M; read stresses";
    case FaultKind::RegionMoves:
        return "the structure can move without strain: the part in {0} moves along {1}; add a support against it";
    case FaultKind::RegionTurns:
        return "the structure can move without strain: the part in {0} turns about {1}; add a support against it";
    case FaultKind::RegionDeforms:
        return "the structure can move without strain: elements in {0} deform so that no integration point feels it, most at {1}; choose standard elements or more supports";
    }
    return "";
}

Severity severity(FaultKind kind)
{
    switch (kind) {
    case FaultKind::NearlySingular:
    case FaultKind::HugeDisplacement:
    case FaultKind::InaccurateCase:
    case FaultKind::InaccurateBody:
    case FaultKind::InaccurateLines:
    case FaultKind::RegionWithoutMass:
    case FaultKind::InaccurateMode:
    case FaultKind::ModesNotCounted:
    case FaultKind::IyzLeftOut:
    case FaultKind::OneWayMember:
    case FaultKind::BarLoadedBetweenNodes:
    case FaultKind::UnusedMaterial:
    case FaultKind::UnusedSection:
    case FaultKind::NodeWithoutMembers:
    case FaultKind::NoMembers:
    case FaultKind::CoincidentNodes:
    case FaultKind::MembersCross:
    case FaultKind::MembersOverlap:
    case FaultKind::MemberPassesNode:
    case FaultKind::MoreCrossings:
    case FaultKind::LonePoint:
    case FaultKind::FaceWithoutRegion:
    case FaultKind::DrawnPointAlone:
    case FaultKind::CurveDangles:
    case FaultKind::PlacesMerged:
    case FaultKind::SharpCorner:
    case FaultKind::MeshAngleMissed:
    case FaultKind::RegionWithoutElements:
    case FaultKind::NearlyIncompressible:
    case FaultKind::LoadOnTwoThicknesses:
    case FaultKind::EmptyLoad: return Severity::Warning;
    default: return Severity::Error;
    }
}

} // namespace femoop
