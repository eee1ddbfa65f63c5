#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/mohr/session/commands.h"
#include "apps/mohr/window/canvas.h"
#include "apps/mohr/window/exercises_panel.h"
#include "apps/mohr/window/state_panel.h"
#include "ui/app/document_app.h"

extern template class ui::DocumentApp<mohr::Workspace>;

namespace mohr {

/// Mohr's circle on a context, on the screen or off it.
class Application final : public ui::DocumentApp<Workspace> {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    const Canvas& canvas() const { return canvas_; }

private:
    ui::Picture picture() override { return canvas_.picture_of(session()); }
    /// The picture (.png, .svg or .pdf) or the results (.csv, .tex).
    std::optional<ui::Message> write(const std::filesystem::path& path) override;
    bool is_typing() const override { return state_panel_.is_typing() || exercises_panel_.is_typing(); }
    bool refuses_text() const override { return state_panel_.is_typing(); }
    void show_left() override;
    void show_right() override;
    void show_canvas() override;
    void show_own_dialogs() override;
    void show_status() const override;
    std::string words() const override;

    Canvas canvas_;
    StatePanel state_panel_;
    ExercisesPanel exercises_panel_;
};

} // namespace mohr
