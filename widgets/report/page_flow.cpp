#include "widgets/report/page_flow.h"

#include <utility>

namespace carina
{
namespace
{

constexpr double kFooterHeight = pageDots(9.0);
constexpr double kFooterWords = 0.75; ///< of its width, for the title
constexpr double kAboveHeading = pageDots(5.0);
constexpr double kBelowHeading = pageDots(1.2);
const PageTextStyle kHeadingText{.points = 11.5, .isBold = true};

QRectF areaOf(const QPdfWriter& writer)
{
    return QRectF{0.0, 0.0, static_cast<double>(writer.width()),
                  static_cast<double>(writer.height())}
        .adjusted(0.0, 0.0, 0.0, -kFooterHeight);
}

} // namespace

PageFlow::PageFlow(QPdfWriter& writer) : m_writer{writer}, m_area{areaOf(writer)} {}

PageFlow::PageFlow(QPdfWriter& writer, QPainter& painter, QString title, Footer footer)
    : m_writer{writer},
      m_painter{&painter},
      m_title{std::move(title)},
      m_footer{std::move(footer)},
      m_area{areaOf(writer)}
{
    drawFooter();
}

void PageFlow::beginPage()
{
    ++m_page;
    m_used = 0.0;
    if (m_painter == nullptr)
        return;
    m_writer.newPage();
    drawFooter();
}

void PageFlow::need(double height)
{
    if (height > room() && m_used > 0.0)
        beginPage();
}

void PageFlow::skip(double height)
{
    if (m_used > 0.0)
        m_used += height;
}

void PageFlow::add(double height, const Drawing& drawing)
{
    need(height);
    if (m_painter != nullptr)
        drawing(*m_painter, {m_area.left(), m_area.top() + m_used, m_area.width(), height});
    m_used += height;
}

void PageFlow::addText(const QString& words, const PageTextStyle& style)
{
    const PageText text{words, style, width(), m_writer};
    for (qsizetype line = 0; line < text.lines().size(); ++line)
        add(text.lineHeight(),
            [&](QPainter& painter, const QRectF& place) { text.drawLine(line, painter, place); });
}

void PageFlow::addHeading(const QString& words, double following)
{
    const PageText text{words, kHeadingText, width(), m_writer};
    need(kAboveHeading + text.height() + kBelowHeading + following);
    skip(kAboveHeading);
    add(text.height() + kBelowHeading,
        [&](QPainter& painter, const QRectF& place) { text.draw(painter, place); });
}

void PageFlow::drawFooter()
{
    const QRectF foot{m_area.left(), m_area.bottom(), m_area.width(), kFooterHeight};
    const PageText page{m_footer(m_page), kSmallText, foot.width(), m_writer};
    const PageText title{m_title, kSmallText, kFooterWords * foot.width(), m_writer};
    const QRectF line = foot.adjusted(0.0, foot.height() - page.lineHeight(), 0.0, 0.0);
    if (!title.lines().isEmpty())
        title.drawLine(0, *m_painter, line);
    page.drawLine(0, *m_painter, line, Qt::AlignRight);
}

} // namespace carina
