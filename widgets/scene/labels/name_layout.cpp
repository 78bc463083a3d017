#include "widgets/scene/labels/name_layout.h"

#include <QLineF>

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <optional>

namespace carina
{
namespace
{

constexpr std::array kDistances{14.0, 30.0, 50.0, 75.0, 105.0, 140.0, 180.0}; ///< pixels, to a box
constexpr int kDirections = 16;
constexpr int kGap = 2; ///< pixels between names
/// Pixels, from an anchor to a name that stays where it was.
constexpr double kNearestStay = 5.0;
constexpr double kFarthestStay = 60.0;

/// Directions as they are tried: to the right, then in turns below and above it, last to the left.
double directionOf(int i)
{
    const double step = 2.0 * std::numbers::pi / kDirections;
    return (i % 2 == 0 ? -1.0 : 1.0) * step * ((i + 1) / 2);
}

/// A box of a size in a direction from a point, at a distance from it.
QRect boxBeside(const QPointF& anchor, const QSize& size, double distance, double angle)
{
    const QPointF middle = anchor
                           + QPointF{std::cos(angle) * (distance + 0.5 * size.width()),
                                     std::sin(angle) * (distance + 0.5 * size.height())};
    return {(middle - QPointF{0.5 * size.width(), 0.5 * size.height()}).toPoint(), size};
}

QPointF nearestIn(const QRect& box, const QPointF& p)
{
    return {std::clamp<double>(p.x(), box.left(), box.right()),
            std::clamp<double>(p.y(), box.top(), box.bottom())};
}

/// The smallest rectangle around a name and its anchor, and a gap more.
QRect extentOf(const PlacedName& name)
{
    const QPoint anchor = name.anchor.toPoint();
    return QRect{
        QPoint{std::min(name.box.left(), anchor.x()), std::min(name.box.top(), anchor.y())},
        QPoint{std::max(name.box.right(), anchor.x()), std::max(name.box.bottom(), anchor.y())}}
        .adjusted(-kGap, -kGap, kGap, kGap);
}

QRect withGap(const QRect& box) { return box.adjusted(-kGap, -kGap, kGap, kGap); }

bool crosses(const QLineF& a, const QLineF& b)
{
    return a.intersects(b, nullptr) == QLineF::BoundedIntersection;
}

bool crosses(const QLineF& line, const QRect& box)
{
    const QRectF area{box};
    return area.contains(line.p1()) || area.contains(line.p2())
           || crosses(line, QLineF{area.topLeft(), area.bottomRight()})
           || crosses(line, QLineF{area.topRight(), area.bottomLeft()});
}

/// What is laid out already, and what must not be covered.
class Layout
{
public:
    Layout(std::span<const NameWish> wishes, const QSize& picture, std::span<const QRect> taken)
        : m_wishes{wishes}, m_picture{QPoint{0, 0}, picture}, m_taken{taken}
    {
    }

    void place(std::size_t wish)
    {
        if (mayStay(m_wishes[wish]) && tryPlace(wish, m_wishes[wish].before))
            return;
        for (const double distance : kDistances)
            for (int i = 0; i < kDirections; ++i)
                if (tryPlace(wish, boxBeside(m_wishes[wish].anchor, m_wishes[wish].size, distance,
                                             directionOf(i))))
                    return;
    }

    [[nodiscard]] std::vector<PlacedName> take() { return std::move(m_placed); }

private:
    static bool mayStay(const NameWish& wish)
    {
        if (wish.before.size() != wish.size || wish.before.isNull())
            return false;
        const double way = QLineF{wish.anchor, nearestIn(wish.before, wish.anchor)}.length();
        return way >= kNearestStay && way <= kFarthestStay;
    }

    bool tryPlace(std::size_t wish, const QRect& box)
    {
        const QPointF& anchor = m_wishes[wish].anchor;
        const PlacedName name{wish, box, anchor, nearestIn(box, anchor)};
        if (!isFree(name))
            return false;
        m_placed.push_back(name);
        return true;
    }

    [[nodiscard]] bool isFree(const PlacedName& name) const
    {
        const QRect wide = withGap(name.box);
        const QLineF leader{name.anchor, name.leaderEnd};
        return m_picture.contains(wide)
               && std::ranges::none_of(m_taken, [&](const QRect& t) { return wide.intersects(t); })
               && std::ranges::none_of(m_placed, [&](const PlacedName& other) {
                      return collide(name, wide, leader, other);
                  });
    }

    [[nodiscard]] static bool collide(const PlacedName& name, const QRect& wide,
                                      const QLineF& leader, const PlacedName& other)
    {
        if (!extentOf(name).intersects(extentOf(other)))
            return false;
        const QLineF otherLeader{other.anchor, other.leaderEnd};
        return wide.intersects(other.box) || QRectF{wide}.contains(other.anchor)
               || crosses(leader, otherLeader) || crosses(leader, other.box)
               || crosses(otherLeader, name.box);
    }

    std::span<const NameWish> m_wishes;
    QRect m_picture;
    std::span<const QRect> m_taken;
    std::vector<PlacedName> m_placed;
};

} // namespace

std::vector<PlacedName> layOutNames(std::span<const NameWish> wishes, const QSize& picture,
                                    std::span<const QRect> taken)
{
    std::vector<std::size_t> order(wishes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wishes[i].depth; });
    Layout layout{wishes, picture, taken};
    for (const std::size_t wish : order)
        layout.place(wish);
    return layout.take();
}

} // namespace carina
