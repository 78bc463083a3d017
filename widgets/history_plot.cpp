#include "widgets/history_plot.h"

#include "engine/core/expects.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMargin = 6; ///< pixels
constexpr int kHintWidth = 320;
constexpr int kHintHeight = 110;
constexpr int kBandOpacity = 70; ///< of 255

} // namespace

double roundUpTo125(double value)
{
    if (!(value > 0.0))
        return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (value <= factor * power)
            return factor * power;
    return 10.0 * power;
}

HistoryPlot::HistoryPlot(QWidget* parent) : QWidget{parent}
{
    setFocusPolicy(Qt::TabFocus);
    setMinimumHeight(kHintHeight);
}

void HistoryPlot::setUp(std::size_t capacity, const QString& unit, const QString& whenEmpty)
{
    CARINA_EXPECTS(capacity >= 2);
    m_capacity = capacity;
    m_unit = unit;
    m_whenEmpty = whenEmpty;
    update();
}

void HistoryPlot::setHistory(std::vector<double> values, const std::optional<Band>& band)
{
    m_values = std::move(values);
    m_band = band;
    update();
}

QSize HistoryPlot::sizeHint() const { return {kHintWidth, kHintHeight}; }

QString HistoryPlot::numberText(double value) const
{
    return QStringLiteral("%1 %2").arg(value, 0, 'g', 3).arg(m_unit);
}

HistoryPlot::Drawing HistoryPlot::drawing() const
{
    Drawing drawn;
    double largest = m_band ? m_band->mean + m_band->sigma : 0.0;
    for (const double value : m_values)
        largest = std::max(largest, value);
    drawn.top = roundUpTo125(largest);
    const int words = std::max(fontMetrics().horizontalAdvance(numberText(drawn.top)),
                               fontMetrics().horizontalAdvance(numberText(0.0)));
    drawn.frame = QRectF{rect()}.adjusted(2 * kMargin + words, kMargin, -kMargin, -kMargin);

    const auto y = [&](double value) {
        return drawn.frame.bottom()
               - std::clamp(value / drawn.top, 0.0, 1.0) * drawn.frame.height();
    };
    const double step = drawn.frame.width() / static_cast<double>(m_capacity - 1);
    const std::size_t shown = std::min(m_values.size(), m_capacity);
    for (std::size_t age = shown; age-- > 0;)
        drawn.curve << QPointF{drawn.frame.right() - static_cast<double>(age) * step,
                               y(m_values[m_values.size() - 1 - age])};
    if (m_band) {
        drawn.mean = y(m_band->mean);
        drawn.band = {QPointF{drawn.frame.left(), y(m_band->mean + m_band->sigma)},
                      QPointF{drawn.frame.right(), y(m_band->mean - m_band->sigma)}};
    }
    return drawn;
}

void HistoryPlot::drawScale(QPainter& painter, const Drawing& drawn) const
{
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(drawn.frame);
    painter.setPen(palette().color(QPalette::Text));
    const QRectF words = QRectF{rect()}.adjusted(kMargin, 0, 0, 0);
    const QRectF column{words.topLeft(), QPointF{drawn.frame.left() - kMargin, words.bottom()}};
    painter.drawText(column, Qt::AlignRight | Qt::AlignTop, numberText(drawn.top));
    painter.drawText(column, Qt::AlignRight | Qt::AlignBottom, numberText(0.0));
}

void HistoryPlot::paintEvent(QPaintEvent*)
{
    QPainter painter{this};
    const Drawing drawn = drawing();
    painter.fillRect(drawn.frame, palette().color(QPalette::Base));
    if (m_values.empty()) {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(rect(), Qt::AlignCenter, m_whenEmpty);
    } else {
        QColor band = palette().color(QPalette::Highlight);
        band.setAlpha(kBandOpacity);
        painter.fillRect(drawn.band, band);
        drawScale(painter, drawn);
        painter.setRenderHint(QPainter::Antialiasing);
        if (drawn.mean) {
            painter.setPen({palette().color(QPalette::Highlight), 1.0, Qt::DashLine});
            painter.drawLine(QPointF{drawn.frame.left(), *drawn.mean},
                             QPointF{drawn.frame.right(), *drawn.mean});
        }
        painter.setPen({palette().color(QPalette::Text), 1.5});
        painter.drawPolyline(drawn.curve);
    }
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

} // namespace carina
