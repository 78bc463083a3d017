#include "ui/panels/airway/try_panel.h"

#include "models/scoring/try_words.h"
#include "widgets/plain_label.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kClock_ms = 500;
constexpr double kOutcomeSize = 1.4; ///< as a multiple of the words' size

QString linesText(const std::vector<SummaryLine>& lines)
{
    QStringList texts;
    for (const SummaryLine& line : lines)
        texts += TryPanel::tr("%1: %2", "what is told; its value").arg(line.name, line.value);
    return texts.join(QLatin1Char('\n'));
}

QString adviceLines(const std::vector<Advice>& advice)
{
    QStringList texts;
    for (const Advice each : advice)
        texts += TryPanel::tr("%1. %2", "number of a sentence; the sentence")
                     .arg(texts.size() + 1)
                     .arg(adviceText(each));
    return texts.join(QLatin1Char('\n'));
}

QString rubricText(const Rubric& rubric)
{
    const QString name = QString::fromStdString(rubric.name);
    const QString source = QString::fromStdString(rubric.source);
    return source.isEmpty() ? name
                            : TryPanel::tr("%1 (%2)", "a rubric; its source").arg(name, source);
}

QString pointsLines(const TryReport& report)
{
    return scoreText(report.score) + QLatin1Char('\n') + linesText(judgementLines(report))
           + QLatin1Char('\n') + rubricText(report.rubric);
}

/// The same as rich text, in which what was lost at a moment is a link: the judgement's number.
QString linkedPointsLines(const TryReport& report)
{
    std::vector<SummaryLine> lines = judgementLines(report);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lines[i] = {lines[i].name.toHtmlEscaped(), lines[i].value.toHtmlEscaped()};
        if (report.score.judgements[i].moment)
            lines[i].value = QStringLiteral("<a href=\"%1\">%2</a>").arg(i).arg(lines[i].value);
    }
    const QString text = scoreText(report.score).toHtmlEscaped() + QLatin1Char('\n')
                         + linesText(lines) + QLatin1Char('\n')
                         + rubricText(report.rubric).toHtmlEscaped();
    return QString{text}.replace(QLatin1Char('\n'), QLatin1String{"<br>"});
}

} // namespace

TryPanel::TryPanel(QWidget* parent)
    : QWidget{parent},
      m_state{new PlainLabel},
      m_outcome{new PlainLabel},
      m_finish{new QPushButton{tr("End this try")}}
{
    auto* column = new QVBoxLayout{this};
    m_state->setObjectName(QStringLiteral("tryState"));
    m_state->setWordWrap(true);
    m_finish->setObjectName(QStringLiteral("finishTry"));
    m_finish->setToolTip(tr("A try ends by itself some breaths after the first one, or once tube "
                            "and blade are out for 10 s. An instructor, or who is at work, can "
                            "end it earlier, for everybody."));
    m_outcome->setObjectName(QStringLiteral("tryOutcome"));
    m_outcome->setAccessibleName(tr("Outcome"));
    m_outcome->setWordWrap(true);
    QFont large = m_outcome->font();
    large.setPointSizeF(kOutcomeSize * large.pointSizeF());
    m_outcome->setFont(large);
    column->addWidget(m_state);
    column->addWidget(m_outcome);
    column->addWidget(m_finish);
    m_figures = addPart("tryFigures", tr("How it went"));
    m_advice = addPart("tryAdvice", tr("What to do next"));
    m_points = addPart("tryPoints", tr("Points"));
    m_handling = addPart("tryHandling", tr("Force and motion"));
    m_literature = addPart("tryLiterature", tr("Beside figures of the literature"));
    m_missing = addPart("tryMissing", tr("What nothing measured"));
    column->addStretch(1);
    m_state->setFocusPolicy(Qt::ClickFocus); // by no Tab, but where the panel is brought
    setFocusProxy(m_state);
    m_clock.setInterval(kClock_ms);
    m_clock.callOnTimeout(this, &TryPanel::refreshState);
    refresh();
}

TryPanel::Part TryPanel::addPart(const char* name, const QString& heading)
{
    const Part part{new PlainLabel{heading}, new PlainLabel};
    QFont font = part.heading->font();
    font.setBold(true);
    part.heading->setFont(font);
    part.text->setObjectName(QLatin1String{name});
    part.text->setAccessibleName(heading);
    part.text->setWordWrap(true);
    part.text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout()->addWidget(part.heading);
    layout()->addWidget(part.text);
    return part;
}

void TryPanel::setModel(TryWatch& tries)
{
    m_tries = &tries;
    connect(m_finish, &QPushButton::clicked, &tries, &TryWatch::finish);
    connect(&tries, &TryWatch::changed, this, &TryPanel::refresh);
    refresh();
}

void TryPanel::linkMoments()
{
    m_linksMoments = true;
    QLabel& points = *m_points.text;
    points.setTextFormat(Qt::RichText);
    points.setTextInteractionFlags(points.textInteractionFlags() | Qt::LinksAccessibleByMouse
                                   | Qt::LinksAccessibleByKeyboard);
    points.setToolTip(tr("Points that were lost lead to their moment among the steps beneath the "
                         "patient"));
    connect(&points, &QLabel::linkActivated, this, &TryPanel::askMoment);
    refresh();
}

void TryPanel::askMoment(const QString& link)
{
    const auto& judgements = m_tries->report()->score.judgements;
    Q_EMIT momentAsked(*judgements.at(link.toUInt()).moment);
}

/// A part without a text takes no room.
void TryPanel::tell(const Part& part, const QString& text)
{
    part.text->setText(text);
    part.heading->setVisible(!text.isEmpty());
    part.text->setVisible(!text.isEmpty());
}

void TryPanel::refresh()
{
    const bool isUnderWay = m_tries && m_tries->isUnderWay();
    isUnderWay ? m_clock.start() : m_clock.stop();
    refreshState();
    if (m_tries && m_tries->report())
        return showReport(*m_tries->report());
    m_outcome->hide();
    for (const Part& part : {m_figures, m_advice, m_points, m_handling, m_literature, m_missing})
        tell(part, {});
}

void TryPanel::refreshState()
{
    m_finish->setEnabled(m_tries && m_tries->mayFinish());
    if (m_tries && m_tries->isUnderWay()) {
        const auto seconds = std::chrono::floor<std::chrono::seconds>(m_tries->time()).count();
        return m_state->setText(
            tr("● A try is under way: %1 min %2 s").arg(seconds / 60).arg(seconds % 60));
    }
    m_state->setText(m_tries && m_tries->report()
                         ? tr("✓ The last try has ended")
                         : tr("○ No try yet: it begins when a tracked blade or tube passes the "
                              "teeth"));
}

void TryPanel::showReport(const TryReport& report)
{
    m_outcome->setText(outcomeText(report.metrics));
    m_outcome->show();
    tell(m_figures, linesText(tryLines(report)));
    tell(m_advice, adviceLines(report.advice));
    tell(m_points, m_linksMoments ? linkedPointsLines(report) : pointsLines(report));
    tell(m_handling, linesText(handlingLines(report.metrics)));
    tell(m_literature, linesText(literatureLines(report.metrics)));
    tell(m_missing, notMeasuredText(report.metrics));
}

} // namespace carina
