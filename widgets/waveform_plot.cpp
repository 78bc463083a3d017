#include "widgets/waveform_plot.h"

#include "engine/core/expects.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

#include <algorithm>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

constexpr int kPlotMargin = 6; ///< pixels
constexpr int kTitleGap = 2;   ///< between the title and the frame beneath it
constexpr int kPlotWidth = 320;
constexpr int kPlotHeight = 72;
constexpr double kGapShare = 0.04; ///< of a sweep, ahead of the newest value
constexpr int kTimeMarks_s = 1;

/// The smallest of a few round numbers that is not below a value: a scale of no more than half as
/// much again as is needed.
double roundUp(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (value <= factor * power)
            return factor * power;
    return 10.0 * power;
}

QString plain(double value) { return QString::number(value, 'g', 4); }

} // namespace

WaveformPlot::WaveformPlot(QWidget* parent) : QWidget{parent}
{
    setFocusPolicy(Qt::TabFocus);
    setMinimumHeight(kPlotHeight);
}

void WaveformPlot::setUp(const QString& name, const QString& unit, double span_s, double least,
                         const QString& timeUnit)
{
    CARINA_EXPECTS(span_s > 0.0 && least > 0.0);
    m_name = name;
    m_unit = unit;
    m_timeUnit = timeUnit;
    m_span_s = span_s;
    m_least = least;
    setMinimumHeight(kPlotHeight + (timeUnit.isEmpty() ? 0 : fontMetrics().height()));
    clear();
}

void WaveformPlot::clear()
{
    m_values.clear();
    rescale(true);
    update();
}

qint64 WaveformPlot::sweepOf(double time_s) const
{
    return static_cast<qint64>(std::floor(time_s / m_span_s));
}

void WaveformPlot::add(double time_s, double value)
{
    CARINA_EXPECTS(std::isfinite(time_s) && std::isfinite(value));
    const bool follows = !m_values.empty() && time_s > m_values.back().time_s
                         && time_s < m_values.back().time_s + m_span_s;
    if (!follows)
        m_values.clear();
    const bool begins = m_values.empty() || sweepOf(time_s) != sweepOf(m_values.back().time_s);
    m_values.push_back({time_s, value});
    while (m_values.front().time_s <= time_s - (1.0 - kGapShare) * m_span_s)
        m_values.pop_front();
    rescale(begins);
    update();
}

void WaveformPlot::rescale(bool mayShrink)
{
    double least = 0.0;
    double greatest = 0.0;
    for (const Value& v : m_values) {
        least = std::min(least, v.value);
        greatest = std::max(greatest, v.value);
    }
    const double top = roundUp(std::max(greatest, m_least));
    // A little below zero is no reason to halve the curve.
    const double bottom = least < -0.02 * top ? -roundUp(std::max(-least, m_least)) : 0.0;
    m_top = mayShrink ? top : std::max(m_top, top);
    m_bottom = mayShrink ? bottom : std::min(m_bottom, bottom);
}

QSize WaveformPlot::sizeHint() const { return {kPlotWidth, kPlotHeight}; }

/// The same for every plot with the same words, whatever its scale: plots beneath each other align.
int WaveformPlot::axisWidth() const
{
    return fontMetrics().horizontalAdvance(QStringLiteral("-0000")) + kPlotMargin;
}

WaveformPlot::Drawing WaveformPlot::drawing() const
{
    Drawing drawn;
    const int line = fontMetrics().height();
    const int below = m_timeUnit.isEmpty() ? 0 : line;
    drawn.frame = QRectF{rect()}.adjusted(kPlotMargin + axisWidth(), line + kTitleGap, -kPlotMargin,
                                          -kPlotMargin - below);
    drawn.title = {drawn.frame.left(), 0.0, drawn.frame.width(), double(line)};
    drawn.bottom = m_bottom;
    drawn.top = m_top;
    const auto y = [&](double value) {
        const double share = (value - m_bottom) / (m_top - m_bottom);
        return drawn.frame.bottom() - std::clamp(share, 0.0, 1.0) * drawn.frame.height();
    };
    drawn.zero = y(0.0);
    std::optional<qint64> sweep;
    for (const Value& v : m_values) {
        if (sweep != sweepOf(v.time_s)) {
            sweep = sweepOf(v.time_s);
            drawn.curves.emplace_back();
        }
        const double along = v.time_s / m_span_s - static_cast<double>(*sweep);
        drawn.now = drawn.frame.left() + along * drawn.frame.width();
        drawn.curves.back() << QPointF{drawn.now, y(v.value)};
    }
    return drawn;
}

void WaveformPlot::drawScale(QPainter& painter, const Drawing& drawn) const
{
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(drawn.frame);
    painter.drawLine(QPointF{drawn.frame.left(), drawn.zero},
                     QPointF{drawn.frame.right(), drawn.zero});
    for (int mark = kTimeMarks_s; mark < m_span_s; mark += kTimeMarks_s) {
        const double x = drawn.frame.left() + mark / m_span_s * drawn.frame.width();
        painter.drawLine(QPointF{x, drawn.frame.bottom() - 3.0}, QPointF{x, drawn.frame.bottom()});
    }
    painter.setPen(palette().color(QPalette::Text));
    const QRectF column{QPointF{0.0, drawn.frame.top() - kTitleGap},
                        QPointF{drawn.frame.left() - kPlotMargin, drawn.frame.bottom()}};
    painter.drawText(column, Qt::AlignRight | Qt::AlignTop, plain(drawn.top));
    painter.drawText(column, Qt::AlignRight | Qt::AlignBottom, plain(drawn.bottom));
    painter.drawText(drawn.title, Qt::AlignLeft | Qt::AlignVCenter,
                     QStringLiteral("%1 (%2)").arg(m_name, m_unit));
    if (m_timeUnit.isEmpty())
        return;
    const QRectF below{drawn.frame.bottomLeft(), QPointF{drawn.frame.right(), height() * 1.0}};
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, QStringLiteral("0"));
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop,
                     QStringLiteral("%1 %2").arg(plain(m_span_s), m_timeUnit));
}

void WaveformPlot::paintEvent(QPaintEvent*)
{
    QPainter painter{this};
    const Drawing drawn = drawing();
    painter.fillRect(drawn.frame, palette().color(QPalette::Base));
    drawScale(painter, drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen({palette().color(QPalette::Highlight), 2.0});
    for (const QPolygonF& curve : drawn.curves)
        painter.drawPolyline(curve);
    if (!m_values.empty()) {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawLine(QPointF{drawn.now, drawn.frame.top()},
                         QPointF{drawn.now, drawn.frame.bottom()});
    }
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

} // namespace carina
