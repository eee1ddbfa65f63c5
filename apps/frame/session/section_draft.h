#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/document/section_command.h"
#include "apps/frame/session/session.h"

namespace frame {

/// Whether a section of the document is changed, or a new one made.
enum class SectionTarget : std::uint8_t { This, New };

/// A section while it is made: the document has it already, as a gesture that is under way, so that the results show
/// what becomes of it. `accept` settles it as one step, `cancel` takes it back.
class SectionDraft {
public:
    bool is_open() const { return is_open_; }
    /// The section that is selected, else that of the first selected member; without either a new one.
    void open(Session& session);
    /// A new one, for the selected members.
    void open_new(Session& session);
    void accept(Session& session);
    void cancel(Session& session);

    void choose_shape(Session& session, femoop::SectionShapeKind kind);
    void choose_profile(Session& session, std::string_view name);
    /// \returns why the shape cannot have it; the section stays then as it was. \pre the section has a shape
    std::optional<ui::Message> set_dimension(Session& session, const femoop::ShapeDimension& dimension,
                                             const femoop::Quantity& value);
    /// On its side or upright. \pre the section has a shape or a profile
    void set_turned(Session& session, bool turned);
    std::optional<ui::Message> set_name(Session& session, std::string_view name);
    void set_target(Session& session, SectionTarget target);

    const femoop::Section& section() const { return section_; }
    SectionTarget target() const { return existing_ ? target_ : SectionTarget::New; }
    const std::optional<femoop::SectionId>& existing() const { return existing_; }
    std::size_t n_members() const { return members_.size(); } ///< selected: those that a new section is for

    /// What a scenario says: "shape i", "set h 400 mm", "profile IPE 300", "turned yes", "name beam", "new", "accept", "cancel".
    /// \returns the complaint
    std::optional<std::string> run_command(Session& session, std::string_view verb, std::string_view argument);

private:
    void begin(Session& session, std::optional<femoop::SectionId> existing);
    void show(Session& session);
    std::optional<std::string> set_named(Session& session, std::string_view argument);

    bool is_open_ = false;
    femoop::Section section_;
    std::optional<femoop::SectionId> existing_;
    SectionTarget target_ = SectionTarget::This;
    std::vector<femoop::MemberId> members_;
    Selection selected_; ///< stays, though a selected section is renamed
};

} // namespace frame
