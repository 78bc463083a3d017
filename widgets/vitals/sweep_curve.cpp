#include "widgets/vitals/sweep_curve.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

SweepCurve::SweepCurve(double span_s, double bottom, double top)
    : m_span_s{span_s}, m_bottom{bottom}, m_top{top}
{
    CARINA_EXPECTS(span_s > 0.0 && top > bottom);
}

void SweepCurve::setTop(double top)
{
    CARINA_EXPECTS(top > m_bottom);
    m_top = top;
}

void SweepCurve::add(double time_s, std::optional<double> value)
{
    CARINA_EXPECTS(std::isfinite(time_s) && (!value || std::isfinite(*value)));
    const bool follows = !m_values.empty() && time_s > m_values.back().time_s
                         && time_s < m_values.back().time_s + m_span_s;
    if (!follows)
        m_values.clear();
    m_values.push_back({time_s, value});
    while (m_values.front().time_s <= time_s - (1.0 - kGapShare) * m_span_s)
        m_values.pop_front();
}

double SweepCurve::sweepOf(double time_s) const { return std::floor(time_s / m_span_s); }

QPointF SweepCurve::placeOf(double time_s, double value, const QRectF& frame) const
{
    const double along = time_s / m_span_s - sweepOf(time_s);
    const double up = std::clamp((value - m_bottom) / (m_top - m_bottom), 0.0, 1.0);
    return {frame.left() + along * frame.width(), frame.bottom() - up * frame.height()};
}

std::vector<QPolygonF> SweepCurve::lines(const QRectF& frame) const
{
    std::vector<QPolygonF> lines;
    const Value* before = nullptr;
    for (const Value& value : m_values) {
        if (value.value) {
            const bool goesOn =
                before && before->value && sweepOf(before->time_s) == sweepOf(value.time_s);
            if (!goesOn)
                lines.emplace_back();
            lines.back() << placeOf(value.time_s, *value.value, frame);
        }
        before = &value;
    }
    return lines;
}

std::optional<double> SweepCurve::bar(const QRectF& frame) const
{
    if (m_values.empty())
        return std::nullopt;
    return placeOf(m_values.back().time_s, m_bottom, frame).x();
}

} // namespace carina
