#include "widgets/report/plot_picture.h"

#include "engine/core/expects.h"
#include "widgets/report/plot_svg.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

namespace carina
{
namespace
{

constexpr int kPixelRatio = 2;

} // namespace

QByteArray pngOf(const QByteArray& svg, const QString& description)
{
    QSvgRenderer renderer{svg};
    CARINA_EXPECTS(renderer.isValid());
    QImage image{kPixelRatio * kFigureWidth, kPixelRatio * kFigureHeight, QImage::Format_RGB32};
    image.fill(Qt::white);
    const int dotsPerMetre = qRound(kPixelRatio * kFigurePixelsPerInch / 0.0254);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    image.setText(QStringLiteral("Description"), description);
    QPainter painter{&image};
    renderer.render(&painter);
    painter.end();
    QByteArray png;
    QBuffer buffer{&png};
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return png;
}

} // namespace carina
