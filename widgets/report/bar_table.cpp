#include "widgets/report/bar_table.h"

#include "engine/core/expects.h"
#include "widgets/report/plot_scale.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kAcross = pageDots(3.0); ///< from a column to the next
constexpr double kAbove = pageDots(0.7);  ///< the words of a row, and below them
constexpr double kBeforeChart = pageDots(2.0);
constexpr double kAfterChart = pageDots(8.0); ///< for the unit after the last number
constexpr double kBarHeight = pageDots(1.9);
constexpr double kMarkHeight = pageDots(3.0);
constexpr double kMarkWidth = pageDots(0.7);
constexpr double kSampleWidth = pageDots(6.0); ///< of a bar in the legend
constexpr double kAfterSample = pageDots(1.2);
constexpr double kHairline = pageDots(0.1);
const QColor kRule{32, 32, 32};
const QColor kGrid{208, 208, 208};
const QColor kBar{140, 184, 219}; ///< pale enough for a mark on it
const PageTextStyle kHeaderText{.points = 7.5, .isBold = true};

PlotScale scaleOf(const BarTable& table)
{
    double greatest = 0.0;
    for (const BarTable::Row& row : table.rows)
        for (const auto& value : {row.bar, row.mark})
            if (value && std::isfinite(*value))
                greatest = std::max(greatest, *value);
    return PlotScale::linear(0.0, greatest);
}

void rule(QPainter& painter, const QColor& colour, const QPointF& from, const QPointF& to)
{
    painter.setPen({colour, kHairline});
    painter.drawLine(from, to);
}

/// The column in which each row has its bar.
class BarChart
{
public:
    BarChart(const PageFlow& flow, const BarTable& table, double left)
        : m_scale{scaleOf(table)},
          m_left{left},
          m_right{flow.width() - kAfterChart},
          m_unit{table.unit},
          m_barLabel{table.barLabel, kSmallText, flow.width() - left - kSampleWidth, flow.device()},
          m_markLabel{table.markLabel, kSmallText, flow.width() - left - kSampleWidth,
                      flow.device()}
    {
        CARINA_EXPECTS(m_left < m_right);
    }

    /// Of the legend and the labels of the axis.
    [[nodiscard]] double headerHeight() const
    {
        return m_barLabel.height() + m_markLabel.height() + m_barLabel.lineHeight() + 2.0 * kAbove;
    }

    void drawHeader(QPainter& painter, const QRectF& place) const
    {
        const double line = m_barLabel.lineHeight();
        QRectF words{m_left + kSampleWidth, place.bottom() - headerHeight() + kAbove, 0.0, line};
        drawBar(painter, m_left, m_left + kSampleWidth - kAfterSample, words.center().y());
        m_barLabel.draw(painter, words);
        words.translate(0.0, m_barLabel.height());
        if (m_markLabel.height() > 0.0)
            drawMark(painter, m_left + (kSampleWidth - kAfterSample) / 2.0, words.center().y());
        m_markLabel.draw(painter, words);
        drawLabels(painter, place.bottom() - kAbove - line);
    }

    void drawRow(QPainter& painter, const QRectF& place, const BarTable::Row& row) const
    {
        for (const PlotScale::Tick& tick : m_scale.ticks())
            rule(painter, tick.value > 0.0 ? kGrid : kRule, {xOf(tick.value), place.top()},
                 {xOf(tick.value), place.bottom()});
        if (row.bar && std::isfinite(*row.bar))
            drawBar(painter, m_left, xOf(*row.bar), place.center().y());
        if (row.mark && std::isfinite(*row.mark))
            drawMark(painter, xOf(*row.mark), place.center().y());
    }

private:
    /// Each number on the middle of its line of the grid, and the unit after the last.
    void drawLabels(QPainter& painter, double top) const
    {
        const std::vector<PlotScale::Tick> ticks = m_scale.ticks();
        for (const PlotScale::Tick& tick : ticks) {
            const PageText number{tick.label, kSmallText, m_right - m_left, *painter.device()};
            const QString unit = &tick == &ticks.back() ? QLatin1Char{' '} + m_unit : QString{};
            const PageText label{tick.label + unit, kSmallText, m_right - m_left,
                                 *painter.device()};
            label.draw(painter, {xOf(tick.value) - number.width() / 2.0, top, 0.0, 0.0});
        }
    }

    [[nodiscard]] double xOf(double value) const
    {
        const double shown = std::clamp(value, m_scale.least(), m_scale.greatest());
        return m_left + m_scale.placeOf(shown) * (m_right - m_left);
    }

    static void drawBar(QPainter& painter, double from, double to, double y)
    {
        painter.setPen({kRule, kHairline});
        painter.setBrush(kBar);
        painter.drawRect(QRectF{from, y - kBarHeight / 2.0, to - from, kBarHeight});
    }

    static void drawMark(QPainter& painter, double x, double y)
    {
        painter.fillRect(
            QRectF{x - kMarkWidth / 2.0, y - kMarkHeight / 2.0, kMarkWidth, kMarkHeight},
            Qt::black);
    }

    PlotScale m_scale;
    double m_left;
    double m_right;
    QString m_unit;
    PageText m_barLabel;
    PageText m_markLabel;
};

/// Adds the rows of one table.
class BarTableFlow
{
public:
    BarTableFlow(PageFlow& flow, const BarTable& table) : m_flow{flow}, m_table{table}
    {
        double width = 0.0;
        for (const BarTable::Column& column : table.columns) {
            width += pageDots(column.width_mm);
            m_headers.append(column.header);
        }
        if (std::any_of(table.rows.begin(), table.rows.end(),
                        [](const BarTable::Row& row) { return row.bar.has_value(); }))
            m_chart.emplace(flow, table, width + kBeforeChart);
    }

    void addHeader()
    {
        const std::vector<PageText> texts = textsOf(m_headers, kHeaderText);
        const double height = std::max(heightOf(texts), m_chart ? m_chart->headerHeight() : 0.0);
        m_flow.add(height, [&](QPainter& painter, const QRectF& place) {
            drawTexts(painter, place.adjusted(0.0, height - heightOf(texts), 0.0, 0.0), texts);
            if (m_chart)
                m_chart->drawHeader(painter, place);
            rule(painter, kRule, place.bottomLeft(), place.bottomRight());
        });
    }

    void addRow(const BarTable::Row& row)
    {
        const std::vector<PageText> texts = textsOf(row.cells, kBodyText);
        const double height = heightOf(texts);
        if (m_flow.room() < height) {
            m_flow.beginPage();
            addHeader();
        }
        m_flow.add(height, [&](QPainter& painter, const QRectF& place) {
            rule(painter, kGrid, place.bottomLeft(), place.bottomRight());
            drawTexts(painter, place, texts);
            if (m_chart)
                m_chart->drawRow(painter, place, row);
        });
    }

private:
    [[nodiscard]] std::vector<PageText> textsOf(const QStringList& cells,
                                                const PageTextStyle& style) const
    {
        CARINA_EXPECTS(cells.size() == static_cast<qsizetype>(m_table.columns.size()));
        std::vector<PageText> texts;
        for (qsizetype i = 0; i < cells.size(); ++i)
            texts.emplace_back(cells[i], style, columnWidth(i), m_flow.device());
        return texts;
    }

    /// Of the words in it.
    [[nodiscard]] double columnWidth(qsizetype column) const
    {
        return pageDots(m_table.columns[static_cast<std::size_t>(column)].width_mm) - kAcross;
    }

    [[nodiscard]] static double heightOf(const std::vector<PageText>& texts)
    {
        double height = 0.0;
        for (const PageText& text : texts)
            height = std::max(height, text.height());
        return height + 2.0 * kAbove;
    }

    void drawTexts(QPainter& painter, const QRectF& place, const std::vector<PageText>& texts) const
    {
        double left = place.left();
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const double width = columnWidth(static_cast<qsizetype>(i));
            texts[i].draw(painter, {left, place.top() + kAbove, width, 0.0},
                          m_table.columns[i].isNumber ? Qt::AlignRight : Qt::AlignLeft);
            left += width + kAcross;
        }
    }

    PageFlow& m_flow;
    const BarTable& m_table;
    QStringList m_headers;
    std::optional<BarChart> m_chart;
};

} // namespace

void addTable(PageFlow& flow, const BarTable& table)
{
    BarTableFlow rows{flow, table};
    rows.addHeader();
    for (const BarTable::Row& row : table.rows)
        rows.addRow(row);
}

} // namespace carina
