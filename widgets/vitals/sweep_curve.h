#pragma once

#include <QPolygonF>
#include <QRectF>

#include <deque>
#include <optional>
#include <vector>

namespace carina
{

/// A curve as bedside monitors write it: the newest value goes from left to right and begins again
/// at the left, and a gap ahead of it separates it from what is left of the sweep before. What is
/// written does not move. Where nothing is measured the curve is interrupted.
class SweepCurve
{
public:
    static constexpr double kGapShare = 0.05; ///< of a sweep, ahead of the newest value

    /// @param span_s duration of a sweep
    /// @param bottom,top values at the edges of the frame; the top may be raised
    /// @pre span_s is above 0, and top above bottom
    SweepCurve(double span_s, double bottom, double top);

    /// A time not later than the last one, or later by a sweep or more, begins the curve anew.
    void add(double time_s, std::optional<double> value);
    void clear() { m_values.clear(); }

    [[nodiscard]] double bottom() const { return m_bottom; }
    [[nodiscard]] double top() const { return m_top; }
    /// @pre above the bottom
    void setTop(double top);

    /// What is to be drawn in a frame, oldest first. Values beyond the frame are at its edge.
    [[nodiscard]] std::vector<QPolygonF> lines(const QRectF& frame) const;
    /// x of the newest value; nothing before the first one.
    [[nodiscard]] std::optional<double> bar(const QRectF& frame) const;

private:
    struct Value {
        double time_s;
        std::optional<double> value;
    };

    [[nodiscard]] double sweepOf(double time_s) const;
    [[nodiscard]] QPointF placeOf(double time_s, double value, const QRectF& frame) const;

    double m_span_s;
    double m_bottom;
    double m_top;
    std::deque<Value> m_values; ///< that are not written over
};

} // namespace carina
