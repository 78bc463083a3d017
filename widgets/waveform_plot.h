#pragma once

#include <QPolygonF>
#include <QWidget>

#include <deque>
#include <vector>

namespace carina
{

/// A waveform drawn as on patient monitors: the newest point sweeps from left to right and starts
/// again at the left; to its right, after a gap, is the previous sweep. Curves already drawn do not
/// move. The scale has round ends and covers zero and both extremes; it grows as needed and shrinks
/// only at the start of a sweep.
class WaveformPlot : public QWidget
{
    Q_OBJECT

public:
    /// What is drawn, in pixels.
    struct Drawing {
        QRectF title; ///< above the frame, so that no curve lies on it
        QRectF frame;
        double bottom = 0.0; ///< the value at the bottom of the frame
        double top = 1.0;    ///< the value at the top of the frame
        double zero = 0.0;   ///< y of the value 0
        std::vector<QPolygonF> curves;
        double now = 0.0; ///< x of the newest value
    };

    explicit WaveformPlot(QWidget* parent = nullptr);

    /// @param name of the quantity, written above the frame with `unit`
    /// @param span_s duration of a sweep
    /// @param least least extent of the scale in each direction that has values
    /// @param timeUnit written after the time at the right end; empty: no times are written
    void setUp(const QString& name, const QString& unit, double span_s, double least,
               const QString& timeUnit);
    /// Adds the next value. A time not later than the last one, or later by a sweep or more,
    /// restarts the plot.
    /// @pre both are finite
    void add(double time_s, double value);

    /// Removes all values.
    void clear();

    [[nodiscard]] Drawing drawing() const;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Value {
        double time_s = 0.0;
        double value = 0.0;
    };

    [[nodiscard]] qint64 sweepOf(double time_s) const;
    void rescale(bool mayShrink);
    [[nodiscard]] int axisWidth() const;
    void drawScale(QPainter& painter, const Drawing& drawn) const;

    QString m_name;
    QString m_unit;
    QString m_timeUnit;
    double m_span_s = 10.0;
    double m_least = 1.0;
    double m_bottom = 0.0;
    double m_top = 1.0;
    std::deque<Value> m_values; ///< of one span
};

} // namespace carina
