#pragma once

#include <QPolygonF>
#include <QWidget>

#include <deque>
#include <vector>

namespace carina
{

/// A quantity over time as monitors draw it: a point sweeps from left to right and begins again at
/// the left; what is ahead of it is from the sweep before, behind a gap. Nothing that is drawn
/// moves. The scale holds zero and both extremes, between round numbers; it grows when a value
/// needs it and shrinks only as a sweep begins.
class WaveformPlot : public QWidget
{
    Q_OBJECT

public:
    /// What is drawn, in pixels.
    struct Drawing {
        QRectF frame;
        double bottom = 0.0; ///< the value at the bottom of the frame
        double top = 1.0;    ///< and at its top
        double zero = 0.0;   ///< y of the value 0
        std::vector<QPolygonF> curves;
        double now = 0.0; ///< x of the newest value
    };

    explicit WaveformPlot(QWidget* parent = nullptr);

    /// @param name of the quantity, and `unit`, written at its axis
    /// @param span_s how long a sweep takes
    /// @param least the scale is never smaller, in either direction that has values
    /// @param timeUnit written behind the time at the right end; empty: no times are
    void setUp(const QString& name, const QString& unit, double span_s, double least,
               const QString& timeUnit);
    /// The next value. A time that is not later than the last, or a sweep later, starts afresh.
    /// @pre both are finite
    void add(double time_s, double value);

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
