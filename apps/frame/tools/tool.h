#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/dimension.h"
#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/frame/document/change.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/document/selection.h"
#include "apps/frame/tools/snap.h"
#include "femoop/edit/crossing.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"

namespace frame {

class AskedBody;
class AskedEnvelope;
class AskedFunicular;
class AskedLine;
class AskedWork;
class Prediction;

/// The direction of an arm from +x, counter-clockwise [degrees].
double direction_of(const Eigen::Vector2d& arm);

/// The arrow of a load that can be pulled longer.
struct LoadGrip {
    Part load;
    femoop::Dof dof = femoop::Dof::uy;
    Eigen::Vector2d pull = Eigen::Vector2d::UnitY(); ///< from the place it acts at to the end that is pulled [length]
};

/// The symbol of a support that can be turned about its node.
struct SupportGrip {
    femoop::NodeId node;
    double angle = 0.0; ///< at which the symbol is seen from the node [degrees], as the pointer took hold of it
};

/// What the pointer points at.
struct Aim {
    Eigen::Vector2d pointer = Eigen::Vector2d::Zero(); ///< its own place in the plane of the model [length]
    ui::Point on_sheet;                                ///< where it is seen
    Projection projection{Camera(ui::PlaneCamera())};  ///< by which the model is seen there
    Snap snap;                                         ///< the place that is meant
    std::optional<femoop::NodeId> node;                ///< under it
    std::optional<Cut> cut;                            ///< of the member under it, where there is no node
    std::optional<SupportGrip> support;                ///< under it, where there is neither
    std::optional<DimensionPlace> dimension;           ///< the line under it, where there is none of these
    std::optional<LoadGrip> grip;                      ///< of the load under it, where there is none of these
    bool is_on_train = false;                          ///< over a train on an influence line, where there is no part
    std::optional<Eigen::Vector3d> in_space;           ///< the place that is meant in a model in space
    bool is_lost = false;                              ///< none is: the working plane is seen edge-on
    double pixel = 0.01;                               ///< one logical pixel [length]
    bool adds = false;                                 ///< Shift is held
    bool is_exact = false;                             ///< Alt is held: nothing is rounded or cut that need not be

    /// Of what comes to cross: Alt holds off the cutting too.
    femoop::Crossings crossings() const { return is_exact ? femoop::Crossings::Keep : femoop::Crossings::Cut; }
    bool points_at_section() const { return cut && !node; }
    bool points_at_support() const { return support && !node && !cut; } ///< at its symbol, not at its node
    /// The place that is meant, in space: that of the snap in a plane model.
    Eigen::Vector3d place() const { return in_space.value_or(Eigen::Vector3d(snap.place.x(), snap.place.y(), 0.0)); }
    /// A model that lies before the eye is dragged; any other is turned, and its parts stay.
    bool may_drag() const { return projection.is_plane(); }
    /// The part under the pointer.
    std::optional<Part> part() const;
    /// The hand has gone farther from a press to here than it trembles, whatever the places were drawn to.
    bool is_dragged_from(const Aim& press) const;
};

/// A place of a member, a twentieth of it where the hand is near to one; Alt takes the place as it is.
double round_section(double x, double length, const Aim& at);
/// The section of a member that the hand has come along to; nothing where the model has it no more, or it is seen
/// end-on.
std::optional<Cut> section_under(const femoop::Model& model, femoop::MemberId member, const Aim& to);

/// What tools work on.
struct Work {
    const Document& document; ///< as it was before the gesture
    Selection& selection;
    Prediction* prediction = nullptr; ///< that may be sketched; null while results are seen
    /// That is sketched in place of moments; null: none.
    const drawing::InfluencePicture* sketched_line = nullptr;
    AskedLine* influence = nullptr;      ///< that a tool may ask for
    AskedBody* free_body = nullptr;      ///< likewise
    AskedFunicular* funicular = nullptr; ///< likewise
    AskedWork* virtual_work = nullptr;   ///< likewise
    /// Of trains, that is seen; null: none.
    const AskedEnvelope* train_envelope = nullptr;
    ui::DisplayUnits units{}; ///< of what is typed
};

/// What a tool shows before it changes anything.
struct Preview {
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> lines;
    /// What will have come when the hand lets go of what it carries: members, and nodes as lines of no length, each
    /// with its name.
    struct Carried {
        Eigen::Vector3d start, end;
        std::string name;
    };
    std::vector<Carried> carried{};
    /// The rectangle of a selection on the sheet, from where the hand began to where it is.
    std::optional<std::pair<ui::Point, ui::Point>> window{};
    std::span<const Eigen::Vector2d> stroke{}; ///< that is being sketched, in the plane of the model
    bool is_stroke_on_sheet = false;           ///< its places are those of the sheet
    std::optional<femoop::MemberId> member{};  ///< that it is sketched on
    std::optional<DimensionLine> dimension{};
    std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> cut{}; ///< that is being drawn across what is seen
};

/// What the left button does in the picture, from press to release and on to the next press. A tool never changes a
/// document itself; it hands back the change.
class Tool {
public:
    virtual ~Tool() = default;

    virtual std::optional<Change> press(const Work& work, const Aim& at) = 0;
    /// With or without the button held down.
    virtual std::optional<Change> move(const Work&, const Aim&) { return std::nullopt; }
    virtual std::optional<Change> release(const Work&, const Aim&) { return std::nullopt; }
    /// Why a place that was typed is of no use now; nothing where it is.
    virtual std::optional<ui::Message> why_not_type(const Work&, const Eigen::Vector2d&) const { return std::nullopt; }
    /// A place that was typed, as if it had been clicked; tools that draw nothing have no use for it.
    virtual std::optional<Change> type(const Work&, const Eigen::Vector2d&) { return std::nullopt; }
    /// The same in a model in space.
    virtual std::optional<Change> type_in_space(const Work&, const Eigen::Vector3d&) { return std::nullopt; }
    /// Gives up what was begun; false where nothing was, so that the tool itself is left.
    virtual bool escape() { return false; }

    virtual bool is_done() const { return false; } ///< the hand may lay it down
    /// Whether a press here takes hold of what then follows the hand; any other press turns a model in space.
    virtual bool takes_hold(const Work&, const Aim&) const { return false; }
    virtual bool snaps() const { return true; }                                  ///< a place is drawn to what is there
    virtual bool draws() const { return false; }                                 ///< places that are snapped and typed
    virtual std::optional<Eigen::Vector2d> from() const { return std::nullopt; } ///< where drawing began
    virtual std::optional<Eigen::Vector3d> from_in_space() const { return std::nullopt; }
    virtual std::span<const femoop::NodeId> moving() const { return {}; } ///< nodes that the hand drags
    virtual Preview preview() const { return {}; }

protected:
    Tool() = default;
    Tool(const Tool&) = default;
    Tool& operator=(const Tool&) = default;
};

} // namespace frame
