#include "apps/frame/window/export.h"

#include <stdexcept>
#include <system_error>

#include "apps/drawing/results/envelope_cases.h"
#include "apps/frame/report/report.h"
#include "apps/frame/session/shown_method.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/results/results_csv.h"
#include "ui/context/write_picture.h"
#include "ui/files/ending.h"
#include "ui/paint/surface/pdf.h"
#include "ui/report/html.h"
#include "ui/report/pages.h"
#include "ui/workbench/file_sentences.h"

namespace frame {

namespace {

/// Writes one session's exports.
class Exporter {
public:
    Exporter(const std::filesystem::path& path, const Session& session, const ui::Fonts& fonts)
        : path_(path), session_(session), fonts_(fonts)
    {}

    std::optional<ui::Message> write(const WindowContent& content)
    {
        if (const auto reason = ui::why_not_ending(path_, export_endings())) return reason;
        const auto is_a = [this](std::string_view ending) { return ui::has_ending(path_, ending); };
        if (is_a(".report.pdf")) write_pdf(path_, ui::report_pages(report(), fonts_), fonts_, pdf_look());
        else if (is_a(".html")) return text(ui::report_html(report(), fonts_));
        else if (is_a(".txt")) return text(description(session_));
        else if (is_a(".csv")) return results();
        else if (is_a(".tex")) return latex(content.derivation);
        else return write_picture(path_, content.picture, fonts_, picture_look(content.png_scale));
        return std::nullopt;
    }

private:
    ui::PictureLook picture_look(double png_scale) const
    {
        return {.background = ui::Theme(session_.view.theme).background(),
                .title = session_.model().title,
                .png_scale = png_scale};
    }
    ui::PdfLook pdf_look() const { return {.background = ui::rgb(0xFFFFFF), .title = session_.model().title}; }
    ui::Report report() const
    {
        const auto about = session_.hidden ? ReportAbout::Data : ReportAbout::Everything;
        return make_report(session_.model(), session_.solution(),
                           {.view = session_.results_view(),
                            .dimensions = session_.document().companion.dimensions,
                            .matrices = session_.reports_matrices,
                            .about = about,
                            .truss = session_.truss.method()},
                           fonts_);
    }

    std::optional<ui::Message> results() const
    {
        const std::optional<femoop::Results> results = session_.described_results();
        if (!results) return session_.why_no_results();
        if (session_.shows_train_envelope()) return train_envelope();
        if (session_.view.is_envelope)
            return text(long_envelope_csv(session_.model(), *results,
                                          envelope_cases(session_.model(), session_.results_view()),
                                          femoop::usual_n_stations));
        return text(long_csv(session_.model(), *results, session_.solution().solved_cases(), femoop::usual_n_stations));
    }

    std::optional<ui::Message> train_envelope() const
    {
        const AskedEnvelope& envelope = session_.train_envelope;
        const auto* const picture = envelope.whole_picture(session_.model(), session_.generation(),
                                                           session_.results_view());
        if (picture == nullptr) return ui::Message(ui::translatable("the envelope of trains has no values"));
        return text(envelope.csv());
    }

    std::optional<ui::Message> latex(const std::string& derivation) const
    {
        const std::string shown = derivation.empty() ? shown_method_latex(session_) : derivation;
        if (!shown.empty()) return text(shown);
        return ui::Message(ui::translatable(
            "a .tex file has what is worked out by hand, and nothing is; show a free body, a funicular, "
            "virtual work or a truss by hand, or explain a number (W)"));
    }

    std::optional<ui::Message> text(const std::string& content) const
    {
        const std::error_code error = files::write_whole_file(path_, content);
        if (!error) return std::nullopt;
        return ui::not_written(path_, error.message());
    }

    const std::filesystem::path& path_;
    const Session& session_;
    const ui::Fonts& fonts_;
};

} // namespace

std::vector<std::string> export_endings()
{
    return {".png", ".svg", ".pdf", ".report.pdf", ".html", ".csv", ".txt", ".tex"};
}

std::optional<ui::Message> export_to(const std::filesystem::path& path, const Session& session, const ui::Fonts& fonts,
                                     const WindowContent& content)
{
    try {
        return Exporter(path, session, fonts).write(content);
    } catch (const std::exception& error) {
        return ui::not_written(path, error);
    }
}

} // namespace frame
