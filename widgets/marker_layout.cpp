#include "widgets/marker_layout.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr QSize kUsualLayout{520, 260};
constexpr double kLayoutMargin = 28.0; // pixels, for numbers, titles and the bar
constexpr double kPointRadius = 5.0;
constexpr double kReach = 12.0; // of a click
constexpr double kSmallestShown_mm = 10.0;
constexpr double kBarShare = 0.4; // of a picture's width, at most

/// What a half shows: its origin in the middle of all points, and the origin of the frame in it.
struct Bounds {
    double least = 0.0;
    double most = 0.0;

    void include(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    [[nodiscard]] double middle() const { return 0.5 * (least + most); }
    [[nodiscard]] double size() const { return std::max(most - least, kSmallestShown_mm); }
};

struct Box3 {
    Bounds x, y, z; // the origin of the frame is in it
};

Box3 boxOf(const std::vector<MarkerLayout::Point>& points)
{
    Box3 box;
    for (const MarkerLayout::Point& point : points) {
        box.x.include(point.x);
        box.y.include(point.y);
        box.z.include(point.z);
    }
    return box;
}

double distanceBetween(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

MarkerLayout::MarkerLayout(QWidget* parent) : QWidget{parent}
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(kUsualLayout / 2);
    setAccessibleName(tr("Markers of the tool from the front and from the side"));
}

QSize MarkerLayout::sizeHint() const { return kUsualLayout; }

void MarkerLayout::setPoints(std::vector<Point> points)
{
    if (points == m_points)
        return;
    m_points = std::move(points);
    if (m_selected >= int(m_points.size()))
        m_selected = -1;
    update();
}

void MarkerLayout::select(int point)
{
    m_selected = point >= 0 && point < int(m_points.size()) ? point : -1;
    if (m_selected >= 0) {
        const Point& at = m_points[std::size_t(m_selected)];
        setAccessibleDescription(tr("Marker %1 of %2 at x %3 mm, y %4 mm, z %5 mm")
                                     .arg(m_selected + 1)
                                     .arg(m_points.size())
                                     .arg(at.x, 0, 'f', 2)
                                     .arg(at.y, 0, 'f', 2)
                                     .arg(at.z, 0, 'f', 2));
    } else {
        setAccessibleDescription(tr("%n markers", nullptr, int(m_points.size())));
    }
    update();
}

QRectF MarkerLayout::half(int which) const
{
    const double width = 0.5 * this->width();
    return QRectF{which * width, 0.0, width, double(height())}.adjusted(
        kLayoutMargin, kLayoutMargin, -kLayoutMargin, -kLayoutMargin);
}

double MarkerLayout::unit() const
{
    const Box3 box = boxOf(m_points);
    const QRectF picture = half(0);
    return std::max(std::min(picture.width() / std::max(box.x.size(), box.z.size()),
                             picture.height() / box.y.size()),
                    1e-3);
}

QPointF MarkerLayout::placeIn(int which, double across, double up) const
{
    const Box3 box = boxOf(m_points);
    const QPointF middle = half(which).center();
    const double acrossMiddle = which == 0 ? box.x.middle() : box.z.middle();
    return {middle.x() + unit() * (across - acrossMiddle),
            middle.y() - unit() * (up - box.y.middle())};
}

QPointF MarkerLayout::placeFromFront(const Point& point) const
{
    return placeIn(0, point.x, point.y);
}

QPointF MarkerLayout::placeFromSide(const Point& point) const
{
    return placeIn(1, point.z, point.y);
}

double MarkerLayout::barLength_mm() const
{
    const double most = kBarShare * half(0).width() / unit();
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0})
        if (times * power <= most)
            return times * power;
    return power;
}

void MarkerLayout::choose(int point)
{
    if (point == m_selected)
        return;
    select(point);
    Q_EMIT chosen(m_selected);
}

void MarkerLayout::mousePressEvent(QMouseEvent* event)
{
    int nearest = -1;
    double distance = kReach;
    for (int i = 0; i < int(m_points.size()); ++i) {
        const Point& point = m_points[std::size_t(i)];
        for (const QPointF& place : {placeFromFront(point), placeFromSide(point)})
            if (distanceBetween(place, event->position()) < distance) {
                distance = distanceBetween(place, event->position());
                nearest = i;
            }
    }
    if (nearest >= 0)
        choose(nearest);
}

void MarkerLayout::keyPressEvent(QKeyEvent* event)
{
    const bool isOn = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down;
    const bool isBack = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
    if ((!isOn && !isBack) || m_points.empty())
        return QWidget::keyPressEvent(event);
    choose(std::clamp(m_selected + (isOn ? 1 : -1), 0, int(m_points.size()) - 1));
}

void MarkerLayout::drawPicture(QPainter& painter, int which) const
{
    const QRectF picture = half(which);
    const auto place = [&](const Point& point) {
        return which == 0 ? placeFromFront(point) : placeFromSide(point);
    };
    const QPointF origin = place({});
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(QPointF{picture.left(), origin.y()}, QPointF{picture.right(), origin.y()});
    painter.drawLine(QPointF{origin.x(), picture.top()}, QPointF{origin.x(), picture.bottom()});
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QPointF{picture.left(), picture.top() - 0.4 * kLayoutMargin},
                     which == 0 ? tr("Front: x to the right, y up")
                                : tr("Side: z to the right, y up"));
    for (int i = 0; i < int(m_points.size()); ++i) {
        const QPointF at = place(m_points[std::size_t(i)]);
        const bool isSelected = i == m_selected;
        painter.setBrush(palette().color(isSelected ? QPalette::Highlight : QPalette::Base));
        painter.setPen(QPen{palette().color(QPalette::WindowText), isSelected ? 2.5 : 1.0});
        const double radius = isSelected ? 1.4 * kPointRadius : kPointRadius;
        painter.drawEllipse(at, radius, radius);
        painter.drawText(at + QPointF{kPointRadius + 3.0, -kPointRadius}, QString::number(i + 1));
    }
}

void MarkerLayout::drawBar(QPainter& painter) const
{
    const double length = barLength_mm();
    const QPointF from{half(0).left(), height() - 0.35 * kLayoutMargin};
    const QPointF to = from + QPointF{length * unit(), 0.0};
    painter.setPen(QPen{palette().color(QPalette::WindowText), 2.0});
    painter.drawLine(from, to);
    for (const QPointF& end : {from, to})
        painter.drawLine(end - QPointF{0.0, 4.0}, end + QPointF{0.0, 4.0});
    painter.drawText(to + QPointF{6.0, 4.0}, tr("%1 mm").arg(length));
}

void MarkerLayout::paintEvent(QPaintEvent* /*event*/)
{
    if (m_points.empty())
        return;
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    for (const int which : {0, 1})
        drawPicture(painter, which);
    drawBar(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen{palette().color(QPalette::Highlight), 1.0, Qt::DotLine});
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

} // namespace carina
