#pragma once

#include <QWidget>

#include <vector>

namespace carina
{

/// Numbered points in a frame of their own, from the front (x to the right, y up) and from the side
/// (z to the right, y up), both at one scale, which a bar tells in millimetres. One point can be
/// selected, by a click or by the arrow keys.
class MarkerLayout : public QWidget
{
    Q_OBJECT

public:
    /// Millimetres.
    struct Point {
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;

        friend bool operator==(const Point&, const Point&) = default;
    };

    explicit MarkerLayout(QWidget* parent = nullptr);

    void setPoints(std::vector<Point> points);
    /// The index of the selected point; -1: none.
    void select(int point);
    [[nodiscard]] int selected() const { return m_selected; }

    /// Where a place is drawn from the front, and from the side.
    [[nodiscard]] QPointF placeFromFront(const Point& point) const;
    [[nodiscard]] QPointF placeFromSide(const Point& point) const;
    /// The length of the bar: 1, 2 or 5 times a power of ten.
    [[nodiscard]] double barLength_mm() const;
    /// Pixels for a millimetre.
    [[nodiscard]] double unit() const;

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    /// By a person.
    void chosen(int point);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF half(int which) const;
    [[nodiscard]] QPointF placeIn(int which, double across, double up) const;
    void choose(int point);
    void drawPicture(QPainter& painter, int which) const;
    void drawBar(QPainter& painter) const;

    std::vector<Point> m_points;
    int m_selected = -1;
};

} // namespace carina
