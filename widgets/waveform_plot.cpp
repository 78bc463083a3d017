#include "widgets/waveform_plot.h"

#include "engine/core/expects.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace carina
{
namespace
{

constexpr int kPlotMargin = 6; ///< pixels
constexpr int kTitleGap = 2;   ///< between the title and the frame beneath it
constexpr int kPlotWidth = 320;
constexpr int kPlotHeight = 72;
constexpr double kGapShare = 0.04;    ///< of a sweep, ahead of the newest value
constexpr double kTickSpacing = 1.4;  ///< least, in lines of text
constexpr double kTimeSpacing = 24.0; ///< least, pixels
constexpr double kLineSpacing = 9.0;  ///< least, pixels
constexpr int kNoteGap = 8;           ///< pixels between the title and the note
constexpr std::ptrdiff_t kFewValues = 10;

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

/// The smallest of the steps 1, 2 and 5 times a power of ten that is not below a value.
double stepUp(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
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
    CARINA_EXPECTS(span_s > 0.0 && span_s <= kLongestSweep_s && least > 0.0);
    m_name = name;
    m_unit = unit;
    m_timeUnit = timeUnit;
    m_span_s = span_s;
    m_least = least;
    setMinimumHeight(kPlotHeight + (timeUnit.isEmpty() ? 0 : fontMetrics().height()));
    clear();
}

void WaveformPlot::setSpan(double span_s)
{
    CARINA_EXPECTS(span_s > 0.0 && span_s <= kLongestSweep_s);
    m_span_s = span_s;
    rescale(true);
    update();
}

void WaveformPlot::setFrozen(bool frozen)
{
    if (std::exchange(m_isFrozen, frozen) == frozen)
        return;
    m_cursor_s.reset();
    m_mark_s.reset();
    if (!frozen)
        clear();
    update();
}

void WaveformPlot::setCursor(std::optional<double> time_s)
{
    m_cursor_s = time_s;
    update();
}

void WaveformPlot::setMark(std::optional<double> time_s)
{
    m_mark_s = time_s;
    update();
}

void WaveformPlot::setNote(const QString& note)
{
    m_note = note;
    update();
}

std::optional<WaveformPlot::Value> WaveformPlot::atCursor() const { return valueAt(m_cursor_s); }

/// The nearest of those that are shown.
std::optional<WaveformPlot::Value> WaveformPlot::valueAt(std::optional<double> time_s) const
{
    if (!time_s || firstShown() == m_values.end())
        return std::nullopt;
    return *std::min_element(firstShown(), m_values.end(),
                             [at = *time_s](const Value& a, const Value& b) {
                                 return std::abs(a.time_s - at) < std::abs(b.time_s - at);
                             });
}

/// The first value of the present sweep, and of what of the one before is not swept over.
std::deque<WaveformPlot::Value>::const_iterator WaveformPlot::firstShown() const
{
    if (m_values.empty())
        return m_values.end();
    const double after = m_values.back().time_s - (1.0 - kGapShare) * m_span_s;
    return std::find_if(m_values.begin(), m_values.end(),
                        [after](const Value& v) { return v.time_s > after; });
}

double WaveformPlot::xOf(double time_s, const QRectF& frame) const
{
    const double along = time_s / m_span_s - static_cast<double>(sweepOf(time_s));
    return frame.left() + along * frame.width();
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
    if (m_isFrozen)
        return;
    const bool follows = !m_values.empty() && time_s > m_values.back().time_s
                         && time_s < m_values.back().time_s + m_span_s;
    if (!follows)
        m_values.clear();
    const bool begins = m_values.empty() || sweepOf(time_s) != sweepOf(m_values.back().time_s);
    m_values.push_back({time_s, value});
    while (m_values.front().time_s <= time_s - kLongestSweep_s)
        m_values.pop_front();
    rescale(begins);
    update();
}

void WaveformPlot::rescale(bool mayShrink)
{
    double least = 0.0;
    double greatest = 0.0;
    for (auto v = firstShown(); v != m_values.end(); ++v) {
        least = std::min(least, v->value);
        greatest = std::max(greatest, v->value);
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
    for (auto v = firstShown(); v != m_values.end(); ++v) {
        if (sweep != sweepOf(v->time_s)) {
            sweep = sweepOf(v->time_s);
            drawn.curves.emplace_back();
        }
        drawn.now = xOf(v->time_s, drawn.frame);
        drawn.curves.back() << QPointF{drawn.now, y(v->value)};
    }
    if (const auto value = atCursor())
        drawn.cursor = xOf(value->time_s, drawn.frame);
    if (const auto value = valueAt(m_mark_s))
        drawn.mark = xOf(value->time_s, drawn.frame);
    addTicks(drawn);
    return drawn;
}

/// Both ends, and of the round values between them those that have room for their text.
void WaveformPlot::addTicks(Drawing& drawn) const
{
    const double perPixel = (drawn.top - drawn.bottom) / drawn.frame.height();
    const double apart = kTickSpacing * fontMetrics().height() * perPixel;
    const double step = stepUp(apart);
    const auto tick = [&](double value) {
        drawn.ticks.push_back({value, drawn.frame.bottom() - (value - drawn.bottom) / perPixel});
    };
    tick(drawn.bottom);
    for (double value = step * std::ceil((drawn.bottom + apart) / step);
         value <= drawn.top - 0.999 * apart; value += step)
        tick(std::abs(value) < 0.5 * step ? 0.0 : value);
    tick(drawn.top);
    const bool isWritten = drawn.ticks.size() > 2; // something between the ends
    addLines(isWritten ? step : stepUp(kLineSpacing * perPixel), drawn);
    const double every_s = std::max(1.0, stepUp(kTimeSpacing * m_span_s / drawn.frame.width()));
    for (double time_s = every_s; time_s < m_span_s; time_s += every_s)
        drawn.times.push_back(drawn.frame.left() + time_s / m_span_s * drawn.frame.width());
}

/// Across the frame at the multiples of a step between both ends.
void WaveformPlot::addLines(double step, Drawing& drawn)
{
    const double perPixel = (drawn.top - drawn.bottom) / drawn.frame.height();
    const double rounding = 0.01 * step;
    for (double n = std::ceil((drawn.bottom + rounding) / step); n * step < drawn.top - rounding;
         n += 1.0)
        drawn.across.push_back(drawn.frame.bottom() - (n * step - drawn.bottom) / perPixel);
}

void WaveformPlot::drawTitle(QPainter& painter, const QRectF& title) const
{
    const QString name = QStringLiteral("%1 (%2)").arg(m_name, m_unit);
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter, name);
    const int room = int(title.width()) - fontMetrics().horizontalAdvance(name) - kNoteGap;
    painter.drawText(title, Qt::AlignRight | Qt::AlignVCenter,
                     fontMetrics().elidedText(m_note, Qt::ElideRight, std::max(0, room)));
}

void WaveformPlot::drawScale(QPainter& painter, const Drawing& drawn) const
{
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(drawn.frame);
    painter.drawLine(QPointF{drawn.frame.left(), drawn.zero},
                     QPointF{drawn.frame.right(), drawn.zero});
    QColor faint = palette().color(QPalette::Mid);
    faint.setAlphaF(0.5F);
    painter.setPen({faint, 0.0, Qt::DotLine});
    for (const double x : drawn.times)
        painter.drawLine(QPointF{x, drawn.frame.top()}, QPointF{x, drawn.frame.bottom()});
    for (const double y : drawn.across)
        painter.drawLine(QPointF{drawn.frame.left(), y}, QPointF{drawn.frame.right(), y});
    painter.setPen(palette().color(QPalette::Text));
    const double line = fontMetrics().height();
    for (const Tick& tick : drawn.ticks)
        painter.drawText(QRectF{0.0, tick.y - 0.5 * line, drawn.frame.left() - kPlotMargin, line},
                         Qt::AlignRight | Qt::AlignVCenter, plain(tick.value));
    drawTitle(painter, drawn.title);
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
    for (const auto& [x, line] :
         {std::pair{drawn.cursor, Qt::DashLine}, std::pair{drawn.mark, Qt::DotLine}}) {
        if (!x)
            continue;
        painter.setPen({palette().color(QPalette::Text), 1.0, line});
        painter.drawLine(QPointF{*x, drawn.frame.top()}, QPointF{*x, drawn.frame.bottom()});
    }
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

void WaveformPlot::mousePressEvent(QMouseEvent* event) { point(event->position().x()); }

void WaveformPlot::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        point(event->position().x());
}

/// At the value that is drawn nearest to this x.
void WaveformPlot::point(double x)
{
    if (!m_isFrozen || firstShown() == m_values.cend())
        return;
    const QRectF frame = drawing().frame;
    const auto nearest =
        std::min_element(firstShown(), m_values.cend(), [&](const Value& a, const Value& b) {
            return std::abs(xOf(a.time_s, frame) - x) < std::abs(xOf(b.time_s, frame) - x);
        });
    Q_EMIT pointedAt(nearest->time_s);
}

void WaveformPlot::keyPressEvent(QKeyEvent* event)
{
    const bool isBack = event->key() == Qt::Key_Left;
    const auto first = firstShown();
    if (!m_isFrozen || first == m_values.cend() || (!isBack && event->key() != Qt::Key_Right))
        return QWidget::keyPressEvent(event);
    const auto present = atCursor();
    const auto at = std::find_if(first, m_values.cend(), [&](const Value& v) {
        return !present || v.time_s >= present->time_s;
    });
    const std::ptrdiff_t wide = event->modifiers().testFlag(Qt::ShiftModifier) ? kFewValues : 1;
    const std::ptrdiff_t last = m_values.cend() - first - 1;
    const std::ptrdiff_t next = (at - first) + (isBack ? -wide : wide);
    Q_EMIT pointedAt((first + std::clamp<std::ptrdiff_t>(next, 0, last))->time_s);
}

} // namespace carina
