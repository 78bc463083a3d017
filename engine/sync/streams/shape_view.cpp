#include "engine/sync/streams/shape_view.h"

#include "engine/sync/streams/stream_view.h"

#include <algorithm>
#include <iterator>

namespace carina
{

void ShapeView::take(const StreamShape& shape)
{
    if (!m_shapes.empty() && shape.time <= m_shapes.back().time)
        return;
    if (!m_shapes.empty()
        && (shape.time - m_shapes.back().time > kLongestGap
            || !shape.isOfSameObject(m_shapes.back())))
        m_shapes.clear();
    if (m_shapes.size() == kKept)
        m_shapes.pop_front();
    m_shapes.push_back(shape);
}

std::optional<ShapeBetween> ShapeView::at(SessionTime t) const
{
    if (m_shapes.empty() || t - m_shapes.back().time > kLongestGap)
        return std::nullopt;
    if (t >= m_shapes.back().time)
        return beyond(t);
    const auto next = std::ranges::upper_bound(m_shapes, t, {}, &StreamShape::time);
    if (next == m_shapes.begin())
        return ShapeBetween{*next, *next};
    const auto before = std::prev(next);
    return ShapeBetween{*before, *next,
                        toSeconds(t - before->time) / toSeconds(next->time - before->time)};
}

ShapeBetween ShapeView::beyond(SessionTime t) const
{
    const StreamShape& newest = m_shapes.back();
    const auto later =
        std::ranges::upper_bound(m_shapes, newest.time - kBaseline, {}, &StreamShape::time);
    if (later == m_shapes.begin())
        return {newest, newest};
    const StreamShape& before = *std::prev(later);
    const double since = toSeconds(newest.time - before.time);
    return {before, newest, 1.0 + carriedSeconds(t - newest.time) / since};
}

} // namespace carina
