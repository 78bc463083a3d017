#include "widgets/report/page_text.h"

#include <QFontMetricsF>
#include <QTextLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kLeading = 1.12;       ///< of a font's height, from line to line
constexpr double kLetterSpacing = 0.02; ///< pixels of a screen: nothing that is seen

QFont fontOf(const PageTextStyle& style)
{
    QFont font{QStringLiteral("DejaVu Sans")};
    font.setStyleHint(QFont::SansSerif);
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setPointSizeF(style.points);
    font.setBold(style.isBold);
    // Any spacing makes Qt do without ligatures, in which a reader of the file finds no words.
    font.setLetterSpacing(QFont::AbsoluteSpacing, kLetterSpacing);
    return font;
}

} // namespace

PageText::PageText(const QString& words, const PageTextStyle& style, double width,
                   const QPaintDevice& device)
    : m_font{fontOf(style)},
      m_ink{style.ink},
      m_lineHeight{kLeading * QFontMetricsF{m_font, &device}.height()}
{
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    for (const QString& paragraph : words.split(QLatin1Char{'\n'}, Qt::SkipEmptyParts)) {
        QTextLayout layout{paragraph, m_font, &device};
        layout.setTextOption(option);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(width);
            m_lines.append(paragraph.mid(line.textStart(), line.textLength()).trimmed());
            m_width = std::max(m_width, line.naturalTextWidth());
        }
        layout.endLayout();
    }
}

void PageText::draw(QPainter& painter, const QRectF& place, Qt::Alignment alignment) const
{
    for (qsizetype line = 0; line < m_lines.size(); ++line)
        drawLine(line, painter, place.translated(0.0, static_cast<double>(line) * m_lineHeight),
                 alignment);
}

void PageText::drawLine(qsizetype line, QPainter& painter, const QRectF& place,
                        Qt::Alignment alignment) const
{
    painter.setFont(m_font);
    painter.setPen(m_ink);
    const QRectF row{place.left(), place.top(), place.width(), m_lineHeight};
    painter.drawText(
        row, static_cast<int>(alignment) | Qt::AlignVCenter | Qt::TextDontClip | Qt::TextSingleLine,
        m_lines[line]);
}

} // namespace carina
