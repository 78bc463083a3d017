#include "widgets/volume_view.h"

#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr int kVolumeHeight = 150;
constexpr int kVolumeWidth = 420;
constexpr double kMarginShare = 0.08; ///< of the depth, around the volume
constexpr double kMarkRadius = 4.0;   // pixels
constexpr double kNameGap = 6.0;      // pixels, between the middle of a mark and its name
constexpr int kMostLines = 9;         ///< that a name is moved up or down
const QColor kOutside{216, 96, 64};

} // namespace

VolumeView::VolumeView(QWidget* parent) : QWidget{parent}
{
    setMinimumHeight(kVolumeHeight);
    setAccessibleName(tr("Place of the tools in the working volume"));
}

QSize VolumeView::sizeHint() const { return {kVolumeWidth, kVolumeHeight}; }

void VolumeView::setVolume(std::vector<Section> sections)
{
    m_sections = std::move(sections);
    update();
}

void VolumeView::setThings(std::vector<Thing> things)
{
    if (things == m_things)
        return;
    m_things = std::move(things);
    update();
}

/// The left half shows it from the side, the right one from above.
QRectF VolumeView::half(int which) const
{
    const double width = 0.5 * this->width();
    return {which * width, 0.0, width, double(height())};
}

/// Pixels for one unit of length, the same in both pictures.
double VolumeView::unit() const
{
    if (m_sections.empty())
        return 1.0;
    double across = 0.0;
    for (const Section& section : m_sections)
        across = std::max({across, section.halfHeight, section.halfWidth});
    const double depth = m_sections.back().depth;
    const double margin = 1.0 + 2.0 * kMarginShare;
    return std::min(half(0).width() / (margin * depth), height() / (2.0 * margin * across));
}

QPointF VolumeView::placeIn(const QRectF& picture, double depth, double across) const
{
    const double depthShown = m_sections.empty() ? 1.0 : m_sections.back().depth;
    const QPointF place{picture.left() + unit() * (depth + kMarginShare * depthShown),
                        picture.center().y() - unit() * across};
    const QRectF inside = picture.adjusted(kMarkRadius, kMarkRadius, -kMarkRadius, -kMarkRadius);
    return {std::clamp(place.x(), inside.left(), inside.right()),
            std::clamp(place.y(), inside.top(), inside.bottom())};
}

QPointF VolumeView::placeFromSide(const Thing& thing) const
{
    return placeIn(half(0), thing.depth, thing.up);
}

QPointF VolumeView::placeFromAbove(const Thing& thing) const
{
    return placeIn(half(1), thing.depth, thing.aside);
}

QPointF VolumeView::placeOf(const Thing& thing, int which) const
{
    return which == 0 ? placeFromSide(thing) : placeFromAbove(thing);
}

/// Each on the line of its mark, or on the nearest one that is free there.
std::vector<QRectF> VolumeView::namesIn(int which) const
{
    const QRectF picture = half(which);
    const double line = fontMetrics().height();
    std::vector<QRectF> names;
    for (const Thing& thing : m_things) {
        const QPointF at = placeOf(thing, which);
        const double width = fontMetrics().horizontalAdvance(thing.name);
        const bool fits = at.x() + kNameGap + width <= picture.right();
        const QRectF beside{fits ? at.x() + kNameGap : at.x() - kNameGap - width,
                            at.y() - 0.5 * line, width, line};
        const auto isFree = [&](const QRectF& place) {
            return picture.top() <= place.top() && place.bottom() <= picture.bottom()
                   && std::ranges::none_of(
                       names, [&](const QRectF& name) { return name.intersects(place); });
        };
        QRectF name = beside;
        for (int step = 1; !isFree(name) && step <= 2 * kMostLines; ++step)
            name = beside.translated(0.0, (step % 2 == 1 ? 1 : -1) * ((step + 1) / 2) * line);
        names.push_back(isFree(name) ? name : beside);
    }
    return names;
}

void VolumeView::paintEvent(QPaintEvent* /*event*/)
{
    if (m_sections.empty())
        return;
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    const auto outline = [this](int which) {
        QPolygonF polygon;
        const auto across = [which](const Section& section) {
            return which == 0 ? section.halfHeight : section.halfWidth;
        };
        for (const Section& section : m_sections)
            polygon << placeIn(half(which), section.depth, across(section));
        for (auto section = m_sections.rbegin(); section != m_sections.rend(); ++section)
            polygon << placeIn(half(which), section->depth, -across(*section));
        return polygon;
    };
    const auto mark = [&](const QPointF& at, const Thing& thing) {
        const QColor color = thing.isInside ? palette().color(QPalette::Highlight) : kOutside;
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        if (thing.isInside)
            painter.drawEllipse(at, kMarkRadius, kMarkRadius);
        else
            painter.drawPolygon(
                QPolygonF{{at + QPointF{0.0, -kMarkRadius}, at + QPointF{kMarkRadius, kMarkRadius},
                           at + QPointF{-kMarkRadius, kMarkRadius}}});
    };
    for (const int which : {0, 1}) {
        painter.setPen(palette().color(QPalette::Mid));
        painter.setBrush(palette().color(QPalette::AlternateBase));
        painter.drawPolygon(outline(which));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(half(which).adjusted(4, 2, -4, -2), Qt::AlignTop | Qt::AlignLeft,
                         which == 0 ? tr("From the side") : tr("From above"));
        const std::vector<QRectF> names = namesIn(which);
        for (std::size_t i = 0; i < m_things.size(); ++i) {
            mark(placeOf(m_things[i], which), m_things[i]);
            const QPointF at = placeOf(m_things[i], which);
            if (std::abs(names[i].center().y() - at.y()) > 0.5 * names[i].height()) {
                const bool isRight = names[i].left() > at.x();
                painter.setPen(palette().color(QPalette::Mid));
                painter.drawLine(at, QPointF{isRight ? names[i].left() : names[i].right(),
                                             names[i].center().y()});
            }
            painter.setPen(palette().color(QPalette::WindowText));
            painter.drawText(names[i], Qt::AlignCenter | Qt::TextDontClip, m_things[i].name);
        }
    }
}

} // namespace carina
