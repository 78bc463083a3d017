#include "ui/instructor/status_line.h"

#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"
#include "widgets/spoken_label.h"

#include <QHBoxLayout>

namespace carina
{
namespace
{

const QString kBetween = QStringLiteral("      ");

} // namespace

StatusLine::StatusLine(QWidget* parent) : QWidget{parent}, m_label{new PlainLabel}
{
    m_label->setObjectName(QStringLiteral("status"));
    m_label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(8, 0, 0, 0);
    row->addWidget(m_label, 1);
}

void StatusLine::say(const QStringList& statements)
{
    if (statements == m_statements)
        return;
    m_statements = statements;
    speakInstead(*m_label, statements.join(QStringLiteral(". ")));
    m_label->setToolTip(shownAsIs(statements.join(QLatin1Char{'\n'})));
    fit();
}

void StatusLine::fit()
{
    const int room = m_label->width();
    QString shown;
    for (const QString& each : m_statements) {
        const QString longer = shown.isEmpty() ? each : shown + kBetween + each;
        if (m_label->fontMetrics().horizontalAdvance(longer) <= room)
            shown = longer;
        else if (shown.isEmpty())
            shown = m_label->fontMetrics().elidedText(each, Qt::ElideRight, room);
    }
    m_label->setText(shown);
}

void StatusLine::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

} // namespace carina
