#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/session/commands.h"
#include "apps/frame/session/linked_programs.h"
#include "apps/frame/window/canvas.h"
#include "apps/frame/window/case_list.h"
#include "apps/frame/window/context_menu.h"
#include "apps/frame/window/design_window.h"
#include "apps/frame/window/kind_question.h"
#include "apps/frame/window/property_sets.h"
#include "apps/frame/window/section_window.h"
#include "apps/frame/window/tables_panel.h"
#include "apps/frame/window/title_rows.h"
#include "apps/frame/window/train_window.h"
#include "apps/frame/window/typical_window.h"
#include "apps/frame/window/view_list.h"
#include "ui/app/document_app.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/path_dialog.h"
#include "ui/widgets/unit_window.h"

extern template class ui::DocumentApp<frame::Workspace>;

namespace frame {

/// The frame app on a context, on the screen or off it.
class Application final : public ui::DocumentApp<Workspace> {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    const Canvas& canvas() const { return canvas_; }
    TablesPanel& tables() { return tables_; }
    std::string results_text()
        const override; ///< of the cases that have results, as `cremona solve --json` prints them
    const TablesPanel& tables() const { return tables_; }

private:
    ui::Picture picture() override { return canvas_.picture_of(workspace()); }
    std::optional<ui::Message> write(const std::filesystem::path& path) override; ///< what export.h says
    std::string_view written() const override;
    std::vector<std::string> own_look() const override; ///< what is shown of which case
    void show_left() override;
    void show_right() override;
    void show_tabs();
    float covered_width() const override;
    void show_canvas() override;
    std::string words() const override; ///< with the derivation that is open
    void show_beside_words() override;
    void show_status() const override;
    void show_body() override;
    void show_own_dialogs() override;
    void handle_own_requests() override;
    void handle_own_request(Request request);
    using DerivationWriter = std::string(const femoop::derivation::Derivation&, const femoop::Model&,
                                         const femoop::Translator&);
    void copy_derivation(DerivationWriter* writer);
    const femoop::derivation::Derivation* shown_derivation() const; ///< null where none is
    void fit() override { canvas_.fit(workspace().session); }
    void zoom(double factor) override { canvas_.zoom(workspace().session, factor); }

    bool is_typing() const override { return fields_.is_typing() || tables_.is_editing(); }
    bool is_asking() const override { return tables_.is_asking(); }
    void leave_keys_to_dialog() override { TablesPanel::lend_keyboard(); }
    std::vector<ui::KeyEvent> take_keys(const ui::Input& all) override;
    ui::Input without_answer(const ui::Input& all);
    void settle_fields() override;
    bool refuses_text() const override { return is_typing(); }
    bool is_for_field(const ui::KeyEvent& event) const;
    bool handle_typing(ui::Key key);
    bool close_topmost() override;
    bool cancel_gesture();

    std::optional<ui::FootMessage> foot_message() const override;
    void answer(const ui::FootMessage& message, std::size_t pressed) override;
    void follow_links(double seconds) override;
    void answer_offer(ui::Request request) override;
    void start(const ui::ExportToApp& exported) override;

    Canvas canvas_;
    TypicalWindow typical_window_;
    TablesPanel tables_;
    SectionWindow section_window_;
    TrainWindow train_window_;
    DesignWindow design_window_;
    ViewList view_list_;
    ui::UnitWindow unit_window_;
    PropertySets property_sets_;
    TitleRows title_rows_;
    CaseList case_list_;
    ContextMenu context_menu_;
    KindQuestion kind_question_;
    ui::PathDialog import_dialog_;
    ui::NumberFields fields_;
    LinkedPrograms linked_;
};

} // namespace frame
