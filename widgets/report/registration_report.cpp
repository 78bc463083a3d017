#include "widgets/report/registration_report.h"

#include "widgets/report/registration_report_tables.h"

#include <QCoreApplication>
#include <QPdfWriter>
#include <QSaveFile>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr QMarginsF kMargins_mm{18.0, 16.0, 18.0, 12.0};

using Facts = std::vector<std::pair<QString, QString>>; ///< what, and its value

constexpr double kBetween = pageDots(2.0);   ///< blocks
constexpr double kFactName = pageDots(34.0); ///< its width
constexpr double kVerdictPadding = pageDots(3.0);
constexpr double kSectionStart = pageDots(32.0); ///< of a table, to stay with its heading
constexpr double kLeastPicture = pageDots(80.0); ///< its height, unless a page has less
constexpr double kLargestPicture = pageDots(130.0);
const PageTextStyle kTitleText{.points = 18.0, .isBold = true};
const PageTextStyle kVerdictText{.points = 14.0, .isBold = true};

/// Composes the words of a report, section by section.
class ReportPages
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationReport)

public:
    ReportPages(PageFlow& flow, const RegistrationReport& report) : m_flow{flow}, m_report{report}
    {
    }

    static QString title() { return tr("Registration report"); }

    static QString footTitle(const RegistrationReport& report)
    {
        QStringList parts{title(), report.patient, report.date};
        parts.removeAll(QString{});
        return parts.join(QStringLiteral(" · "));
    }

    static QString footPage(int page, int pages)
    {
        return tr("Page %1 of %2").arg(page).arg(pages);
    }

    void add()
    {
        m_flow.addText(title(), kTitleText);
        m_flow.skip(kBetween);
        addVerdict();
        addFacts({{tr("Patient"), m_report.patient},
                  {tr("Date"), m_report.date},
                  {tr("Manikin"), m_report.manikin},
                  {tr("Operator"), m_report.operatorName},
                  {tr("Verdict of"), m_report.judged},
                  {tr("Tracker"), m_report.tracker},
                  {tr("Site file"), m_report.siteFile}});
        addNotes();
        addChecked();
        addTargets();
        addLandmarks();
        addStylus();
        addPicture();
    }

private:
    /// The same marks as on the screens.
    [[nodiscard]] QString verdict() const
    {
        switch (m_report.verdict) {
        case RegistrationReport::Verdict::Verified:
            return tr("✓ Verified");
        case RegistrationReport::Verdict::NotGoodEnough:
            return tr("▲ Not good enough");
        case RegistrationReport::Verdict::NotVerified:
            break;
        }
        return tr("○ Not verified");
    }

    /// What the verdict rests on.
    [[nodiscard]] QString reasons() const
    {
        QStringList sentences;
        const auto& checked = m_report.checked;
        if (!checked.empty()) {
            const auto within = std::count_if(checked.begin(), checked.end(),
                                              [](const auto& point) { return point.isWithin(); });
            const auto worst =
                std::max_element(checked.begin(), checked.end(), [](const auto& a, const auto& b) {
                    return a.error_mm < b.error_mm;
                });
            sentences += tr("Points not used in the fit that lie within their bounds: %1 of %2. "
                            "Largest error: %3, at %4.")
                             .arg(QString::number(within), QString::number(checked.size()),
                                  reportedMillimetres(worst->error_mm), worst->name);
        }
        if (m_report.bound_mm)
            sentences +=
                tr("Expected error: below %1 in 95 % of registrations, at the worst target.")
                    .arg(reportedMillimetres(m_report.bound_mm));
        return sentences.join(QLatin1Char{'\n'});
    }

    void addVerdict()
    {
        const double width = m_flow.width() - 2.0 * kVerdictPadding;
        const PageText word{verdict(), kVerdictText, width, m_flow.device()};
        const PageText why{reasons(), kBodyText, width, m_flow.device()};
        m_flow.add(word.height() + why.height() + 2.0 * kVerdictPadding,
                   [&](QPainter& painter, const QRectF& place) {
                       painter.setPen({kBodyText.ink, pageDots(0.4)});
                       painter.setBrush(Qt::NoBrush);
                       painter.drawRect(place);
                       const QRectF inside = place.adjusted(kVerdictPadding, kVerdictPadding,
                                                            -kVerdictPadding, -kVerdictPadding);
                       word.draw(painter, inside);
                       why.draw(painter, inside.translated(0.0, word.height()));
                   });
        m_flow.skip(kBetween);
    }

    /// Those with a value, two beside each other.
    void addFacts(Facts facts)
    {
        std::erase_if(facts, [](const auto& fact) { return fact.second.isEmpty(); });
        const double column = m_flow.width() / 2.0;
        for (std::size_t i = 0; i < facts.size(); i += 2) {
            std::vector<PageText> texts; // name and value in turn
            for (std::size_t j = i; j < std::min(i + 2, facts.size()); ++j) {
                texts.emplace_back(facts[j].first, kPaleText, kFactName - kBetween,
                                   m_flow.device());
                texts.emplace_back(facts[j].second, kBodyText, column - kFactName - kBetween,
                                   m_flow.device());
            }
            double height = 0.0;
            for (const PageText& text : texts)
                height = std::max(height, text.height());
            m_flow.add(height, [&](QPainter& painter, const QRectF& place) {
                for (std::size_t j = 0; j < texts.size(); ++j) {
                    const double left = static_cast<double>(j / 2) * column
                                        + static_cast<double>(j % 2) * kFactName;
                    texts[j].draw(painter, place.adjusted(left, 0.0, 0.0, 0.0));
                }
            });
        }
    }

    void addNotes()
    {
        if (m_report.notes.isEmpty())
            return;
        m_flow.addHeading(tr("Notes"), pageDots(4.0));
        for (const QString& note : m_report.notes)
            m_flow.addText(tr("▲ %1", "a warning").arg(note));
    }

    void addChecked()
    {
        if (m_report.checked.empty())
            return;
        m_flow.addHeading(tr("Verification"), kSectionStart);
        m_flow.addText(tr("Points that were not used in the fit, touched afterwards. 95 % of such "
                          "errors are expected to be below the bound."),
                       kSmallText);
        addTable(m_flow, tableOfChecked(m_report));
    }

    void addTargets()
    {
        if (m_report.targets.empty())
            return;
        m_flow.addHeading(tr("Expected error at targets"), kSectionStart);
        m_flow.addText(
            tr("Target registration error (TRE): expected distance between the drawn anatomy and "
               "its true place, predicted from the landmarks and the error of the touches."),
            kSmallText);
        addTable(m_flow, tableOfTargets(m_report));
    }

    void addLandmarks()
    {
        if (m_report.landmarks.empty() && !m_report.fre_mm && !m_report.fle)
            return;
        m_flow.addHeading(tr("Landmarks and fit"), kSectionStart);
        if (m_report.fre_mm)
            m_flow.addText(tr("Fiducial registration error (FRE), the root mean square of the "
                              "residuals: %1.")
                               .arg(reportedMillimetres(m_report.fre_mm)));
        if (m_report.fle)
            m_flow.addText(tr("Fiducial localisation error (FLE) of a touch, estimated from the "
                              "residuals: %1; upper 95 % confidence limit: %2.")
                               .arg(reportedMillimetres(m_report.fle->rms_mm),
                                    reportedMillimetres(m_report.fle->limit_mm)));
        if (!m_report.landmarks.empty())
            addLandmarkTable();
    }

    void addLandmarkTable()
    {
        m_flow.skip(kBetween / 2.0);
        m_flow.addText(tr("Spread: of the stylus's tip during the touch. Left out: residual after "
                          "a fit of all other landmarks (leave-one-out)."),
                       kSmallText);
        addTable(m_flow, tableOfLandmarks(m_report));
    }

    void addStylus()
    {
        if (!m_report.stylus)
            return;
        const auto& stylus = *m_report.stylus;
        m_flow.addHeading(tr("Stylus"), pageDots(12.0));
        addFacts({{tr("Tip from divot, root mean square"), reportedMillimetres(stylus.rms_mm)},
                  {tr("Uncertainty of the tip"), reportedMillimetres(stylus.uncertainty_mm)},
                  {tr("Poses"), QString::number(stylus.poses)},
                  {tr("Coverage"), stylus.coverage},
                  {tr("Calibrated"), stylus.date}});
    }

    /// As large as the rest of the page allows, unless that is little.
    void addPicture()
    {
        if (m_report.picture.isNull())
            return;
        const PageText caption{m_report.caption, kSmallText, m_flow.width(), m_flow.device()};
        const double others = kBetween + caption.height();
        m_flow.addHeading(tr("Expected error on the anatomy"), kLeastPicture + others);
        const QSizeF most{m_flow.width(), std::min(kLargestPicture, m_flow.room() - others)};
        const QSizeF size = QSizeF{m_report.picture.size()}.scaled(most, Qt::KeepAspectRatio);
        m_flow.add(size.height(), [&](QPainter& painter, const QRectF& place) {
            painter.drawImage(QRectF{place.topLeft(), size}, m_report.picture);
        });
        m_flow.skip(kBetween);
        m_flow.addText(m_report.caption, kSmallText);
    }

    PageFlow& m_flow;
    const RegistrationReport& m_report;
};

/// @returns false where nothing can be drawn; whether all was written, the device tells.
bool drawReport(QIODevice& device, const RegistrationReport& report)
{
    QPdfWriter writer{&device};
    writer.setResolution(kPageDotsPerInch);
    writer.setPageSize(QPageSize{QPageSize::A4});
    writer.setPageMargins(kMargins_mm, QPageLayout::Millimeter);
    writer.setTitle(ReportPages::footTitle(report));
    writer.setCreator(QStringLiteral("Carina"));
    PageFlow counted{writer};
    ReportPages{counted, report}.add();
    QPainter painter;
    if (!painter.begin(&writer))
        return false;
    PageFlow drawn{writer, painter, ReportPages::footTitle(report),
                   [&counted](int page) { return ReportPages::footPage(page, counted.pages()); }};
    ReportPages{drawn, report}.add();
    return painter.end();
}

} // namespace

Result<void> writeRegistrationReport(const std::filesystem::path& file,
                                     const RegistrationReport& report)
{
    QSaveFile target{QString::fromStdString(file.string())};
    // It names its operator; whoever wants others to read it passes it on.
    if (!target.open(QIODevice::WriteOnly)
        || !target.setPermissions(QSaveFile::ReadOwner | QSaveFile::WriteOwner)
        || !drawReport(target, report) || !target.commit())
        return fail(Errc::FileUnwritable, file.string() + ": cannot be written");
    return {};
}

} // namespace carina
