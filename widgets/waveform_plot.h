#pragma once

#include <QPolygonF>
#include <QWidget>

#include <deque>
#include <optional>
#include <vector>

namespace carina
{

/// A waveform drawn as on patient monitors: the newest point sweeps from left to right and starts
/// again at the left; to its right, after a gap, is the previous sweep. Curves already drawn do not
/// move. The scale has round ends and covers zero and both extremes; it grows as needed and shrinks
/// only at the start of a sweep. Both ends and, where there is room, round values between them are
/// written at their height; lines across mark round values and lines down round times.
///
/// While it is frozen, values that arrive are not shown, and a cursor can be set by mouse (click or
/// drag) or by keyboard (left and right: to the next value; with Shift by ten).
class WaveformPlot : public QWidget
{
    Q_OBJECT

public:
    /// A value written beside the frame, at its height.
    struct Tick {
        double value = 0.0;
        double y = 0.0; ///< pixels
    };
    /// A value that was added.
    struct Value {
        double time_s = 0.0;
        double value = 0.0;
    };
    /// What is drawn, in pixels.
    struct Drawing {
        QRectF title; ///< above the frame, so that no curve lies on it
        QRectF frame;
        double bottom = 0.0; ///< the value at the bottom of the frame
        double top = 1.0;    ///< the value at the top of the frame
        double zero = 0.0;   ///< y of the value 0
        std::vector<QPolygonF> curves;
        double now = 0.0;             ///< x of the newest value
        std::vector<Tick> ticks;      ///< from bottom to top, with both ends
        std::vector<double> across;   ///< y of the lines across
        std::vector<double> times;    ///< x of the lines down
        std::optional<double> cursor; ///< its x
        std::optional<double> mark;   ///< likewise
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

    /// Duration of a sweep from now on; what was drawn stays as far as it is within the new one.
    /// @pre above 0 and at most kLongestSweep_s, as in setUp.
    void setSpan(double span_s);
    [[nodiscard]] double span() const { return m_span_s; }
    /// Holds the picture as it is, or lets it run on, from an empty frame.
    void setFrozen(bool frozen);
    [[nodiscard]] bool isFrozen() const { return m_isFrozen; }
    /// Marks the value nearest to a time; std::nullopt: none.
    void setCursor(std::optional<double> time_s);
    /// Marks another value, with which that at the cursor is compared, likewise.
    void setMark(std::optional<double> time_s);
    /// Written above the frame, at its right end.
    void setNote(const QString& note);
    [[nodiscard]] const QString& note() const { return m_note; }
    /// The value at the cursor.
    [[nodiscard]] std::optional<Value> atCursor() const;
    /// Removes all values.
    void clear();

    [[nodiscard]] Drawing drawing() const;
    [[nodiscard]] QSize sizeHint() const override;

    static constexpr double kLongestSweep_s = 60.0;

Q_SIGNALS:
    /// A place was pointed at while the plot is frozen: the time of the nearest value.
    void pointedAt(double time_s);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] std::deque<Value>::const_iterator firstShown() const;
    [[nodiscard]] double xOf(double time_s, const QRectF& frame) const;
    [[nodiscard]] std::optional<Value> valueAt(std::optional<double> time_s) const;
    void addTicks(Drawing& drawn) const;
    static void addLines(double step, Drawing& drawn);
    void point(double x);
    [[nodiscard]] qint64 sweepOf(double time_s) const;
    void rescale(bool mayShrink);
    [[nodiscard]] int axisWidth() const;
    void drawScale(QPainter& painter, const Drawing& drawn) const;
    void drawTitle(QPainter& painter, const QRectF& title) const;

    QString m_name;
    QString m_unit;
    QString m_timeUnit;
    double m_span_s = 10.0;
    double m_least = 1.0;
    double m_bottom = 0.0;
    double m_top = 1.0;
    bool m_isFrozen = false;
    std::optional<double> m_cursor_s;
    std::optional<double> m_mark_s;
    QString m_note;
    std::deque<Value> m_values; ///< of the longest sweep
};

} // namespace carina
