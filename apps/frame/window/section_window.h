#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/frame/session/commands.h"
#include "femoop/section/profile.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/side_window.h"

namespace frame {

/// Where a section is made: from a shape and its dimensions, or a rolled profile that is found by its name; its picture
/// and its properties below. The structure beside it shows what becomes of it.
class SectionWindow {
public:
    explicit SectionWindow(const ui::Fonts& fonts) : fonts_(fonts) {}

    /// Nothing where no section is being made.
    void show(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields);

private:
    void show_content(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields);
    void show_name(Workspace& workspace, ui::TabStops& stops);
    void show_shapes(Workspace& workspace, ui::ImGuiSession& gui, ui::TabStops& stops);
    void show_families(Workspace& workspace, ui::TabStops& stops);
    /// What was pressed in the filter of profiles.
    struct Filtering {
        bool is_entered = false;
        bool is_edited = false;
        int step = 0; ///< through the list: 1 down, -1 up
    };
    Filtering show_filter(const Workspace& workspace, ui::TabStops& stops);
    void show_profiles(Workspace& workspace, ui::TabStops& stops);
    void show_turned(Workspace& workspace) const;
    void show_picture(Workspace& workspace, ui::ImGuiSession& gui, float height) const;
    void show_buttons(Workspace& workspace, ui::NumberFields& fields) const;
    bool lists_profiles(const SectionDraft& draft) const { return is_listing_ || draft.section().profile; }
    std::vector<const femoop::Profile*> listed_profiles() const; ///< of the family, with the filter in their names
    std::optional<ui::Message> why_not_accept(const SectionDraft& draft) const;

    const ui::Fonts& fonts_;
    ui::SideWindow window_;
    std::string name_;                            ///< as it is typed
    bool is_naming_ = false;                      ///< it has the keyboard
    std::optional<ui::Message> reason_;           ///< why it is not taken
    std::string filter_;                          ///< of profiles
    std::optional<femoop::ProfileFamily> family_; ///< of profiles; all when absent
    const femoop::Profile* seen_ = nullptr;       ///< the chosen one that was last brought into sight
    bool begins_filter_ = false;                  ///< a family was chosen: a part of a name is typed next
    bool is_listing_ = false;                     ///< profiles are looked through, though none is chosen
};

} // namespace frame
