#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/plane/session/commands.h"
#include "apps/plane/window/canvas.h"
#include "apps/plane/window/tables_panel.h"
#include "ui/app/document_app.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/path_dialog.h"
#include "ui/widgets/unit_window.h"

extern template class ui::DocumentApp<plane::Workspace>;

namespace plane {

/// The plane app on a context, on the screen or off it.
class Application final : public ui::DocumentApp<Workspace> {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    const Canvas& canvas() const { return canvas_; }

private:
    ui::Picture picture() override { return canvas_.picture_of(workspace()); }
    bool is_typing() const override { return fields_.is_typing() || tables_.is_typing(); }
    bool refuses_text() const override { return is_typing(); }
    void show_body() override;
    void show_left() override;
    void show_right() override;
    void show_canvas() override;
    void show_status() const override;
    std::string words() const override;
    void fit() override { canvas_.fit(workspace().session); }
    void zoom(double factor) override { canvas_.zoom(workspace().session, factor); }
    std::vector<ui::KeyEvent> take_keys(const ui::Input& input) override;
    bool close_topmost() override;
    void show_own_dialogs() override;
    void handle_own_requests() override;
    bool is_asking() const override { return insert_dialog_.is_open() || backdrop_dialog_.is_open(); }
    std::optional<ui::FootMessage> foot_message() const override;
    void answer(const ui::FootMessage& message, std::size_t pressed) override;

    bool handle_typing(ui::Key key);
    bool handle_presenter(ui::Key key);
    void show_player();

    Canvas canvas_;
    ui::NumberFields fields_;
    TablesPanel tables_;
    ui::PathDialog backdrop_dialog_;
    ui::PathDialog insert_dialog_;
    ui::UnitWindow unit_window_;
};

} // namespace plane
