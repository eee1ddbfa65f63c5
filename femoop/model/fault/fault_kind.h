#pragma once

#include <cstdint>

namespace femoop {

/// Every kind of fault that a file or a model can have. Its sentence stands in fault_pattern.cpp, which says what the
/// arguments are; the first one is the place: members[2] "BC".
enum class FaultKind : std::uint16_t {
    // the structure, found by the analysis
    NoSupport,
    PartWithoutSupport,     ///< {0} nodes
    TooFewSupports,         ///< {1} how many motions of a rigid body are held, {2} of how many
    PartWithTooFewSupports, ///< {0} nodes, {1}, {2} likewise
    MechanismSwayX,         ///< {0} nodes that move along x together
    MechanismSwayY,         ///< {0} nodes that move along y together
    MechanismSwayZ,         ///< {0} nodes that move along z together
    MechanismMoveX,         ///< {0} the one node that moves along x
    MechanismMoveY,         ///< {0} the one node that moves along y
    MechanismMoveZ,         ///< {0} the one node that moves along z
    MechanismMoveOblique,   ///< {0} nodes, {1} direction
    MechanismTurn,          ///< {0} nodes that turn together, {1} the point they turn about
    MechanismNodeTurns,     ///< {0} node, {1} rotation
    MechanismSpin,          ///< {0} node that a moment spins, {1} rotation
    MechanismSpins,         ///< {0} nodes that only rotate
    MechanismMixed,         ///< {0} nodes that move, each in its way
    MechanismMemberSwings,  ///< {0} member, {1} node
    MechanismMemberFlies,   ///< {0} member, {1} release
    ConstraintConflict,     ///< {0} members, {1} case
    StiffnessBeyondRange,   ///< {0} nodes
    ResultsBeyondRange,     ///< {0} case
    MemoryInsufficient,     ///< {0} equations, {1} gigabytes needed, {2} gigabytes free
    NearlySingular,         ///< {0} condition estimate, {1} nodes
    HugeDisplacement,       ///< {0} node, {1} distance, {2} case

    // the file
    FileUnreadable,
    FileUnwritable,
    FileEmpty,
    FileNotUtf8,
    FileWithControlCharacter,
    FileWithSecondMark,

    // the file's JSON: {0} line, {1} column, {2} what was found
    JsonTooDeep,
    JsonCutOff,
    JsonOpenText,
    JsonComment,
    JsonSingleQuotes,
    JsonTrailingComma,
    JsonMissingComma,
    JsonNotFinite,
    JsonSpelling, ///< {3} how JSON writes it
    JsonNoNumber,
    JsonBareQuantity,
    JsonBareText,
    JsonDecimalComma, ///< {3} the number with a point
    JsonNumberTooLarge,
    JsonAfterEnd,
    JsonUnexpected,
    RepeatedKey,
    RepeatedDof, ///< {1} which, {2} the first one's place

    // the file's keys and values
    WrongType,
    WrongTypeText,
    UnknownKey,
    UnknownKeyNear,
    MissingKey,
    UnknownFormat,
    UnknownChoice,
    UnknownChoiceNear,
    WrongCoordinateCount,
    WrongNodeCount,
    WrongVectorSize,
    WrongLineLoadSize,
    BadPercentage,
    BadMode,
    SizeWithoutShape,
    NoSuchNode,
    NoSuchNodeNear,
    NoSuchMember,
    NoSuchMemberNear,
    NoSuchMaterial,
    NoSuchMaterialNear,
    NoSuchSection,
    NoSuchSectionNear,
    NoSuchCase,
    NoSuchCaseNear,

    // quantities: {1} the text
    QuantityWithoutNumber,
    QuantityWithTypographicMinus,
    QuantityWithoutUnit,
    QuantityWithComma,
    QuantityBadUnit,
    QuantityUnknownUnit,
    QuantityUnknownUnitNear,
    QuantityWrongDimension,
    QuantityUnwantedUnit,
    QuantityTooLarge,

    // the parts of a model
    EmptyId,
    ControlCharacterInId,
    RepeatedId,
    DanglingReference,
    NotFinite,
    OutOfReach,
    NotPositive,
    Negative,
    ZeroStiffness,
    ZeroEndSpring,
    RepeatedComponent,
    PoissonOutOfRange,
    CentroidOutside,
    ShapeAndProfile,
    TurnedNumbers,
    ShapeSizeMissing,
    ShapeSizeUnwanted,
    ShapeTooThick,
    UnknownProfile,
    UnknownProfileNear,
    MissingProperty,
    IyzLeftOut,
    RollerNotPlane,
    AngleNotPlane,
    FixedDofLacking,
    SpringDofLacking,
    SpringOnFixedDof,
    MassDofLacking,
    MemberWithoutMaterial,
    MemberWithoutSection,
    SameNodeTwice,
    ZeroLength,
    OffsetsEatMember,
    OffsetSize,
    TrussOffsetAcross,
    ReleaseDofLacking,
    EndSpringDofLacking,
    ReleaseAndSpring,
    HingeAndSpring,
    TensionAndCompressionOnly,
    FoundationOfBar,
    FoundationTooStiff,
    DepthCount,
    DepthsOutsidePlaneFrame,
    DepthsBeside,
    DepthsOfSection,
    DepthTooSmall,
    DepthsTooDifferent,
    OneWayMember,
    UpNot3d,
    UpSize,
    UpZero,
    UpAlongMember,
    UnusedMaterial,
    UnusedSection,
    NodeWithoutMembers,
    NoMembers,
    CoincidentNodes,
    MembersCross,
    MembersOverlap,
    MemberPassesNode,
    MoreCrossings,

    // its loads and combinations
    LoadDofLacking,
    LoadedNodeWithoutMembers,
    EmptyLoad,
    SettlementOfFreeDof,
    MissingDensity,
    MissingAreaForWeight,
    PositionBeforeStart,
    PositionBeyondEnd,
    LoadEndsBeforeStart,
    ProjectedLocalLoad,
    ProjectedMoment,
    TorqueOnBar, ///< {1} member
    TemperatureOfRigid,
    MissingExpansion,
    MissingDepth,
    MisfitOfGrillage,
    CombinationCircle,

    // what the hand methods cannot do
    CrossNeedsPlaneFrame,  ///< {0} analysis
    CrossRigidMember,      ///< {0} member
    CrossSkewOffset,       ///< {0} member
    CrossAxialSpring,      ///< {0} member
    CrossHeldElongation,   ///< {0} members, {1} case
    CrossHeldSettlement,   ///< {0} members, {1} case
    CrossTooLarge,         ///< {0} how many nodes, {1} the most
    CrossWithoutCase,      ///< no load case
    CrossJointFree,        ///< {0} node, {1} its moment
    CrossNoSuchJoint,      ///< {0} what was found, {1} the joints that can be balanced
    CrossSteps,            ///< {0} steps, {1} unbalance that is left, {2} its joint, {3} tolerance
    CrossSwayUndetermined, ///< no case: sways that nothing resists
    CrossNoSuchEnd,        ///< {0} place, {1} what was found, {2} the ends
    CrossSheetTooLong,     ///< {0} place, {1} how many rows, {2} how many the sheet has
    CrossNodeWithoutImage, ///< {0} node, {1} x of the axis, {2} where its image should be
    CrossEndWithoutImage,  ///< {0} member end, {1} x of the axis, {2} node of its image
    CrossSkewLoads, ///< {0} member end or joint, {1} its moment, {2} its image, {3} the image's, {4} x of the axis
    CrossSkewSway,  ///< {0} node of the prop, {1} x of the axis

    // what is expected of it
    ExpectedWithoutCase,
    ExpectedKeyMissing,
    ExpectedNodeAndMember,
    ExpectedDofLacking,
    ExpectedReactionOfFreeNode,

    // its moving loads
    NoSuchPath,
    NoSuchPathNear,
    NoSuchTrain,
    NoSuchTrainNear,
    NoSuchLine,
    NoSuchLineNear,
    NoSuchEnvelope,
    NoSuchEnvelopeNear,
    PathWithoutMembers,    ///< {0} place
    PathBroken,            ///< {0} place, {1} member, {2} its ends, {3} the member named next, {4} its ends
    PathMissing,           ///< {0} place: neither named nor the only one
    UnitLoadZero,          ///< {0} place
    BarLoadedBetweenNodes, ///< {0} place, {1} members
    PositionOffPath,       ///< {0} place, {1} position, {2} length of the path
    BadPathPosition,       ///< {0} place, {1} what was found
    WrongValueCount,       ///< {0} place, {1} values, {2} positions
    TrainWithoutLoad,      ///< {0} place
    AxlesAndSpacings,      ///< {0} place, {1} axles, {2} spacings, {3} how many there should be
    RangeOfNoSpacing,      ///< {0} place, {1} what was found, {2} how many spacings there are
    RangeReversed,         ///< {0} place, {1} min, {2} max
    WrongRangeSize,        ///< {0} place, {1} how many numbers
    EnvelopeWithoutTrains, ///< {0} place
    EffectNotMoving,       ///< {0} place, {1} quantity, {2} those that move with a load

    // redundants of the force method
    RedundantNoForce,     ///< {0} place, {1} effect
    RedundantReleased,    ///< {0} place, {1} effect
    RedundantInsideBar,   ///< {0} place, {1} effect
    RedundantTwice,       ///< {0} place, {1} effect
    RedundantsTooMany,    ///< {0} degree of static indeterminacy, {1} most that are chosen
    RedundantsNone,       ///< the structure is determinate
    RedundantsUnstrained, ///< {0} redundants
    PrimaryMoves,         ///< {0} redundants

    // plane models
    PlaneModelElsewhere,  ///< {0} place, {1} analysis
    EdgesWithoutElements, ///< {0} place
    CurvePlace,           ///< {0} place
    EllipseAxes,          ///< {0} place
    BadDivision,          ///< {0} place, {1} what was found
    DrawnPlaceCount,      ///< {0} place, {1} how many, {2} the kind and how many it wants
    CurveWithoutLength,   ///< {0} place
    ArcPlacesInLine,      ///< {0} place
    ArcRadiiDiffer,       ///< {0} place, {1} and {2} radii
    EllipsePlaceOff,      ///< {0} place, {1} how far
    CurvesRunTogether,    ///< {0} place, {1} curve
    CurveRunsBack,        ///< {0} place
    CurveTooNear,         ///< {0} place
    SnapTooSmall,         ///< {0} what was found, {1} least
    DivisionsOfPieces,    ///< {0} place, {1} divisions, {2} pieces
    HoleWithMaterial,     ///< {0} place
    RegionPlaceOutside,   ///< {0} place, {1} place in the plane
    RegionPlaceOnCurve,   ///< {0} place, {1} place in the plane, {2} curve
    RegionPlaceTaken,     ///< {0} place, {1} place in the plane, {2} the other's place
    SecondRestOfFaces,    ///< {0} place, {1} the other's place
    NoFaceLeft,           ///< {0} place
    FaceWithoutRegion,    ///< {0} place in the plane, {1} area
    DrawnPointAlone,      ///< {0} place
    CurveDangles,         ///< {0} place
    PlacesMerged,         ///< {0} place, {1} what it meets, {2} place in the plane, {3} how far apart, {4} snap
    SharpCorner,          ///< {0} place in the plane, {1} degrees
    TouchesNoMaterial,    ///< {0} place, {1} curve or point
    PointsAtOnePlace,     ///< {0} place, {1} the other's place
    MinAngleRange,        ///< {0} place, {1} what was found
    CornerCount,          ///< {0} place, {1} how many
    NothingToMesh,
    MeshMethodOfElement,   ///< {0} place, {1} method, {2} element
    MappedInside,          ///< {0} place, {1} method
    MappedVertices,        ///< {0} place, {1} method, {2} corners that it wants, {3} vertices of its outline
    MappedCornerOff,       ///< {0} place, {1} point
    MappedCornerOrder,     ///< {0} place
    MappedSidesDiffer,     ///< {0} place, {1} and {3} curves of opposite sides, {2} and {4} how many parts
    TrilateralSidesDiffer, ///< {0} place, {1} and {3} curves of two sides, {2} and {4} how many parts
    TrilateralOdd,         ///< {0} place, {1} element, {2} parts of each side
    MeshOrdersDiffer,      ///< {0} place, {1} and {3} elements, {2} the other's place
    MeshTooLarge,          ///< {0} elements, {1} most
    MeshEdgesCross,        ///< {0} place, {1} and {2} curves
    MeshElementTurned,     ///< {0} place, {1} place in the plane
    MeshAngleMissed,       ///< {0} place, {1} degrees, {2} degrees asked for, {3} place in the plane
    CheckFaceOutside,      ///< {0} place, {1} place in the plane
    CheckFaceRank,         ///< {0} place, {1} rank, {2} faces
    CheckFacePlace,        ///< {0} place, {1} quantity
    NoSuchPoint,
    NoSuchPointNear,
    NoSuchCurve,
    NoSuchCurveNear,
    NoSuchRegion,
    NoSuchRegionNear,
    CurveKindWithElements,  ///< {0} place, {1} kind
    ElementPointCount,      ///< {0} place, {1} points, {2} how many there should be, {3} kind
    ElementNoArea,          ///< {0} place
    ElementClockwise,       ///< {0} place
    ElementDistorted,       ///< {0} place, {1} Jacobian, {2} where
    PointLeftOfAxis,        ///< {0} place, {1} x
    FormulationLacking,     ///< {0} place, {1} formulation, {2} kind of element, {3} analysis
    RegionWithoutThickness, ///< {0} place
    ThicknessOfRevolution,  ///< {0} place
    ShearModulusInPlane,    ///< {0} place
    IncompressibleInPlane,  ///< {0} place, {1} nu, {2} analysis
    CurveTooShort,          ///< {0} place, {1} points
    CurveWithoutEdge,       ///< {0} place, {1} point, {2} point
    PressureInside,         ///< {0} place, {1} curve
    LoadOnTwoThicknesses,   ///< {0} place, {1} curve, {2} region whose thickness counts, {3} the other
    PointWithoutElements,   ///< {0} place, {1} point
    LonePoint,              ///< {0} place
    RegionWithoutElements,  ///< {0} place
    NoElements,
    AxesAndAngle,           ///< {0} place
    CurveAxesOfPoint,       ///< {0} place, {1} what was found
    TieOfTurnedNode,        ///< {0} place, {1} point
    SettlementPlace,        ///< {0} place
    SettlementOfFreeCurve,  ///< {0} place, {1} direction, {2} curve
    SettlementConflict,     ///< {0} place, {1} point, {2} and {3} displacements
    SettlementOffAxis,      ///< {0} place, {1} point, {2} displacement
    RegionWithoutDensity,   ///< {0} place, {1} material, {2} region
    RegionWithoutExpansion, ///< {0} place, {1} material, {2} region
    LineLoadOfRevolution,   ///< {0} place
    AboutOfRevolution,      ///< {0} place
    FieldNeedsCurve,        ///< {0} place
    FieldEndsSize,          ///< {0} place, {1} how many
    PolynomialTerm,         ///< {0} place
    TableRow,               ///< {0} place
    TableNotAscending,      ///< {0} place
    EmptyField,             ///< {0} place
    TooManyElements,        ///< {0} elements, {1} most
    NearlyIncompressible,   ///< {0} place, {1} nu
    CheckPlace,             ///< {0} place, {1} quantity
    CheckOutside,           ///< {0} place, {1} place in the plane
    CheckRegionNeeded,      ///< {0} place, {1} regions
    CheckRegionElsewhere,   ///< {0} place, {1} region
    CheckGaussPlace,        ///< {0} place
    CheckNotSupported,      ///< {0} place
    CheckPlaceSize,         ///< {0} place
    CutSize,                ///< {0} place
    CutOutside,             ///< {0} place
    CutOfRevolution,        ///< {0} place
    RegionMoves,            ///< {0} regions, {1} direction
    RegionTurns,            ///< {0} regions, {1} the point that it turns about
    RegionDeforms,          ///< {0} regions, {1} points

    // how well the analysis could solve it
    InaccurateCase,     ///< {0} case, {1} how many digits hold
    IllConditionedCase, ///< {0} case
    InaccurateBody,     ///< the same of plates and bodies
    IllConditionedBody,
    InaccurateLines,    ///< {0} how many digits hold of influence lines
    IllConditionedLine, ///< {0} effect of the influence line, {1} node where its path begins, {2} where it ends
    LineBeyondRange,    ///< likewise

    // natural vibrations
    NothingHasMass,     ///< of regions
    RegionWithoutMass,  ///< {0} regions, {1} materials
    MasslessMotion,     ///< something moves that has neither stiffness nor mass
    TooFewModes,        ///< {0} wanted, {1} there are
    ModeLostInRounding, ///< {0} which
    InaccurateMode,     ///< {0} which, {1} how many digits hold
    ModesNotCounted,    ///< {0} how many were found
};

} // namespace femoop
