#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/cross/session/commands.h"
#include "apps/cross/window/canvas.h"
#include "apps/cross/window/exercise_panel.h"
#include "apps/cross/window/method_panel.h"
#include "ui/app/document_app.h"

extern template class ui::DocumentApp<cross::Workspace>;

namespace cross {

/// Moment distribution on a context, on the screen or off it.
class Application final : public ui::DocumentApp<Workspace> {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    const Canvas& canvas() const { return canvas_; }

private:
    ui::Picture picture() override { return canvas_.picture_of(session()); }
    /// The picture (.png, .svg or .pdf), the table that is shown (.csv or .tex), or the whole calculation as a report
    /// (.html or .report.pdf).
    std::optional<ui::Message> write(const std::filesystem::path& path) override;
    std::optional<ui::Message> write_report(const std::filesystem::path& path) const;
    bool is_typing() const override { return method_panel_.is_typing() || exercise_panel_.is_typing(); }
    bool leaves_undo() const override { return canvas_.cell_field().is_untouched(); }
    bool refuses_text() const override { return method_panel_.is_typing() || canvas_.is_typing_value(); }
    void show_left() override;
    void show_right() override;
    void show_own_dialogs() override;
    void show_canvas() override;
    void fit() override { workspace().session.look.zoom = {}; }
    void zoom(double factor) override { canvas_.zoom(workspace().session, factor); }
    void show_status() const override;
    std::string words() const override;

    Canvas canvas_;
    MethodPanel method_panel_;
    ExercisePanel exercise_panel_;
};

} // namespace cross
