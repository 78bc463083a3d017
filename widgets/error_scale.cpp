#include "widgets/error_scale.h"

#include "engine/core/expects.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kScaleMargin = 6; ///< pixels
constexpr int kTick = 4;        ///< pixels, below the strip
constexpr int kHintBand = 30;   ///< pixels, of the widest scale

QString withDecimals(Length length, int decimals)
{
    return QString::number(inMillimetres(length), 'f', decimals);
}

QString numberAt(const ErrorBands& bands, int edge)
{
    return ErrorScale::tr("%1\u00a0mm")
        .arg(withDecimals(bands.edge(edge), inMillimetres(bands.width) < 1.0 ? 1 : 0));
}

QString captionOf(const ErrorRange& range)
{
    return ErrorScale::tr("Expected error (RMS): %1 to %2 mm")
        .arg(withDecimals(range.least, 1), withDecimals(range.most, 1));
}

/// The smallest step of 1, 2 or 4 bands from number to number for which they stay apart.
int stepOf(double bandWidth, double numberWidth)
{
    int step = 1;
    while (step < 4 && step * bandWidth < numberWidth + kScaleMargin)
        step *= 2;
    return step;
}

} // namespace

ErrorScale::ErrorScale(QWidget* parent) : QWidget{parent}
{
    setFocusPolicy(Qt::TabFocus);
    setAccessibleName(tr("Scale of the expected error"));
}

void ErrorScale::setScale(const ErrorBands& bands, const ErrorRange& range)
{
    CARINA_EXPECTS(bands.count >= 1 && bands.count <= kMostErrorBands);
    m_scale = {bands, range};
    setAccessibleDescription(tr("From %1 mm to %2 mm; the darker, the larger.")
                                 .arg(withDecimals(range.least, 1), withDecimals(range.most, 1)));
    update();
}

std::optional<ErrorScale::Drawing> ErrorScale::drawing() const
{
    if (!m_scale)
        return std::nullopt;
    const ErrorBands& bands = m_scale->bands;
    const QFontMetricsF metrics{font()};
    const double widest = metrics.horizontalAdvance(numberAt(bands, bands.count));
    const double line = metrics.height();
    Drawing drawn;
    drawn.caption = captionOf(m_scale->range);
    drawn.strip =
        QRectF{rect()}.adjusted(kScaleMargin + widest / 2.0, kScaleMargin + line,
                                -kScaleMargin - widest / 2.0, -kScaleMargin - kTick - line);
    const double bandWidth = drawn.strip.width() / bands.count;
    const int step = stepOf(bandWidth, widest);
    for (int k = 0; k <= bands.count; ++k) {
        const double x = drawn.strip.left() + k * bandWidth;
        if (k < bands.count)
            drawn.bands.emplace_back(x, drawn.strip.top(), bandWidth, drawn.strip.height());
        if (k % step == 0)
            drawn.numbers.push_back(
                {x,
                 {x - widest / 2.0 - 1.0, drawn.strip.bottom() + kTick, widest + 2.0, line},
                 numberAt(bands, k)});
    }
    return drawn;
}

QSize ErrorScale::sizeHint() const
{
    return minimumSizeHint().expandedTo({kHintBand * kMostErrorBands, 0});
}

QSize ErrorScale::minimumSizeHint() const
{
    constexpr Length kWidest = millimetres(88.8);
    return {fontMetrics().horizontalAdvance(captionOf({kWidest, kWidest})) + 2 * kScaleMargin,
            3 * fontMetrics().height() + kTick + 2 * kScaleMargin};
}

void ErrorScale::paintEvent(QPaintEvent*)
{
    const std::optional<Drawing> drawn = drawing();
    if (!drawn)
        return;
    QPainter painter{this};
    const int count = m_scale->bands.count;
    for (int k = 0; k < count; ++k) {
        const QRectF& band = drawn->bands[static_cast<std::size_t>(k)];
        painter.fillRect(band, bandColor(k, count));
        painter.setPen(isolineColor(k, count));
        if (k > 0)
            painter.drawLine(band.topLeft(), band.bottomLeft());
    }
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF{rect()}.adjusted(kScaleMargin, kScaleMargin / 2.0, -kScaleMargin, 0),
                     Qt::AlignLeft | Qt::AlignTop, drawn->caption);
    for (const Drawing::Number& number : drawn->numbers) {
        painter.drawText(number.words, Qt::AlignCenter, number.text);
        painter.drawLine(QPointF{number.x, drawn->strip.bottom()},
                         QPointF{number.x, number.words.top()});
    }
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

} // namespace carina
