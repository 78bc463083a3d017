#pragma once

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace carina
{

/// The latest values of a non-negative quantity as a curve, the newest at the right edge, over the
/// band from mean - sigma to mean + sigma. The scale runs from zero to a round number.
class HistoryPlot : public QWidget
{
    Q_OBJECT

public:
    struct Band {
        double mean = 0.0;
        double sigma = 0.0;
    };
    /// What is drawn, in pixels.
    struct Drawing {
        QRectF frame;
        double top = 1.0; ///< the value at the top of the frame
        QPolygonF curve;
        QRectF band;
        std::optional<double> mean{}; ///< y of its line
    };

    explicit HistoryPlot(QWidget* parent = nullptr);

    /// @param capacity how many values fill the width of the plot; at least 2
    /// @param unit written behind numbers
    /// @param whenEmpty written if there is no value
    void setUp(std::size_t capacity, const QString& unit, const QString& whenEmpty);
    /// @pre all values are finite
    void setHistory(std::vector<double> values, const std::optional<Band>& band);

    [[nodiscard]] Drawing drawing() const;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QString numberText(double value) const;
    void drawScale(QPainter& painter, const Drawing& drawn) const;

    std::size_t m_capacity = 2;
    QString m_unit;
    QString m_whenEmpty;
    std::vector<double> m_values;
    std::optional<Band> m_band;
};

/// The smallest number >= value of the form 1, 2 or 5 times a power of ten; 1 for a value <= 0.
[[nodiscard]] double roundUpTo125(double value);

} // namespace carina
