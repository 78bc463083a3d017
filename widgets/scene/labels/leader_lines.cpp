#include "widgets/scene/labels/leader_lines.h"

#include <QPainter>
#include <QPolygon>
#include <QRegion>
#include <QWindow>

namespace carina
{
namespace
{

constexpr double kWidth = 2.0; ///< pixels
constexpr int kDot = 7;        ///< pixels across
constexpr QColor kColor{255, 255, 255};

/// The pixels of a line and its dot.
QRegion shapeOf(const QLineF& line)
{
    const QRect dot{line.p1().toPoint() - QPoint{kDot / 2, kDot / 2}, QSize{kDot, kDot}};
    QRegion shape{dot, QRegion::Ellipse};
    if (line.length() == 0.0)
        return shape;
    const QLineF across = line.normalVector().unitVector();
    const QPointF half{0.5 * kWidth * across.dx(), 0.5 * kWidth * across.dy()};
    const QPolygonF strip{{line.p1() + half, line.p2() + half, line.p2() - half, line.p1() - half}};
    return shape + QRegion{strip.toPolygon()};
}

} // namespace

LeaderLines::LeaderLines(QWidget& over) : QWidget{&over}
{
    setAttribute(Qt::WA_NativeWindow); // else the scene's own window would cover it
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void LeaderLines::setLines(const std::vector<QLineF>& lines)
{
    const QRect whole = parentWidget()->rect();
    if (lines != m_lines || geometry() != whole) {
        m_lines = lines;
        setGeometry(whole);
        QRegion shape;
        for (const QLineF& line : lines)
            shape += shapeOf(line);
        setMask(shape);
    }
    setVisible(!lines.empty());
    if (QWindow* window = windowHandle(); window != nullptr && !lines.empty())
        window->raise();
}

void LeaderLines::paintEvent(QPaintEvent* /*event*/) { QPainter{this}.fillRect(rect(), kColor); }

} // namespace carina
