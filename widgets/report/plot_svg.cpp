#include "widgets/report/plot_svg.h"

#include "widgets/report/plot_style.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kMargin = 14.0;
constexpr double kSpace = 8.0;
constexpr double kTitlePixels = 20.0;
constexpr double kTitleHeight = 24.0;
constexpr double kWordPixels = 16.0; ///< 12 points
constexpr double kLineHeight = 22.0;
constexpr double kLetterWidth = 0.6 * kWordPixels; ///< about that of DejaVu Sans, a wide font
constexpr double kSampleLength = 48.0;             ///< of a line in the legend
const QString kInk = QStringLiteral("#202020");
const QString kPaleInk = QStringLiteral("#606060");
const QString kGridInk = QStringLiteral("#dddddd");
const QString kWhite = QStringLiteral("#ffffff");
const QString kNone = QStringLiteral("none");

double widthOf(const QString& words) { return kLetterWidth * static_cast<double>(words.size()); }

/// Draws one plot from the top of its page to the bottom.
class PlotDrawing
{
public:
    explicit PlotDrawing(const Plot& plot)
        : m_plot{plot},
          m_svg{QSizeF{kFigureWidth, kFigureHeight}, plot.title, plot.stamp},
          m_left{QRectF{0.0, 0.0, kFigureWidth, kFigureHeight}.adjusted(kMargin, kMargin, -kMargin,
                                                                        -kMargin)},
          m_x{xScaleOf(plot)},
          m_y{yScaleOf(plot)}
    {
    }

    QByteArray draw()
    {
        m_svg.rectangle(QRectF{0.0, 0.0, kFigureWidth, kFigureHeight}, kWhite, {});
        m_svg.text(m_left.topLeft() + QPointF{0.0, kTitleHeight / 2}, m_plot.title,
                   {.pixels = kTitlePixels, .colour = kInk});
        m_left.setTop(m_left.top() + kTitleHeight + kSpace);
        drawLegend();
        m_svg.text(m_left.bottomRight() - QPointF{0.0, kLineHeight / 2}, m_plot.stamp,
                   {.pixels = kWordPixels, .colour = kPaleInk, .anchor = Anchor::End});
        m_left.setBottom(m_left.bottom() - kLineHeight - kSpace);
        layOutAxes();
        drawAxes();
        drawLabels();
        for (std::size_t series = 0; series < m_plot.series.size(); ++series)
            drawSeries(series);
        return m_svg.finish();
    }

private:
    using Anchor = SvgText::Anchor;

    /// In columns as wide as the longest name.
    void drawLegend()
    {
        if (m_plot.series.empty())
            return;
        double width = 0.0;
        for (const PlotSeries& series : m_plot.series)
            width = std::max(width, kSampleLength + 4.0 * kSpace + widthOf(series.name));
        const auto columns =
            std::max(std::size_t{1}, static_cast<std::size_t>(m_left.width() / width));
        for (std::size_t i = 0; i < m_plot.series.size(); ++i) {
            const auto column = static_cast<double>(i % columns);
            const auto row = static_cast<double>(i / columns);
            drawSample(i, m_left.topLeft() + QPointF{column * width, (row + 0.5) * kLineHeight});
        }
        const std::size_t rows = (m_plot.series.size() + columns - 1) / columns;
        m_left.setTop(m_left.top() + static_cast<double>(rows) * kLineHeight + kSpace);
    }

    /// A path, for a polyline is the line of a series.
    void drawSample(std::size_t series, const QPointF& at)
    {
        const QPointF right = at + QPointF{kSampleLength, 0.0};
        if (!m_plot.series[series].line.empty())
            m_svg.path(QLatin1Char{'M'} + svgPoint(at) + QLatin1Char{'L'} + svgPoint(right), kNone,
                       lineStroke(m_plot, series));
        if (!m_plot.series[series].marks.empty())
            drawMarks(series, {(at + right) / 2.0});
        m_svg.text(right + QPointF{kSpace, 0.0}, m_plot.series[series].name,
                   {.pixels = kWordPixels, .colour = kInk});
    }

    void layOutAxes()
    {
        double labels = 0.0;
        for (const PlotScale::Tick& tick : m_y.ticks())
            labels = std::max(labels, widthOf(tick.label));
        m_axes = m_left.adjusted(kLineHeight + labels + 2.0 * kSpace, kLineHeight / 2,
                                 -kLineHeight / 2 - kSpace, -2.0 * kLineHeight - 2.0 * kSpace);
    }

    [[nodiscard]] QPointF placeOf(double x, double y) const
    {
        return {m_axes.left() + m_x.placeOf(x) * m_axes.width(),
                m_axes.bottom() - m_y.placeOf(y) * m_axes.height()};
    }

    void drawAxes()
    {
        QString grid;
        const auto line = [&grid](const QPointF& from, const QPointF& to) {
            grid += QLatin1Char{'M'} + svgPoint(from) + QLatin1Char{'L'} + svgPoint(to);
        };
        for (const PlotScale::Tick& tick : m_x.ticks())
            line(placeOf(tick.value, m_y.least()), placeOf(tick.value, m_y.greatest()));
        for (const PlotScale::Tick& tick : m_y.ticks())
            line(placeOf(m_x.least(), tick.value), placeOf(m_x.greatest(), tick.value));
        m_svg.path(grid, kNone, {.colour = kGridInk, .width = 1.0});
        m_svg.rectangle(m_axes, kNone, {.colour = kInk, .width = 1.5});
    }

    void drawLabels()
    {
        SvgText style{.pixels = kWordPixels, .colour = kInk, .anchor = Anchor::Middle};
        const QPointF below{0.0, kSpace / 2 + kLineHeight / 2};
        for (const PlotScale::Tick& tick : m_x.ticks())
            if (!tick.label.isEmpty())
                m_svg.text(placeOf(tick.value, m_y.least()) + below, tick.label, style);
        m_svg.text({m_axes.center().x(), m_left.bottom() - kLineHeight / 2}, m_plot.x.label, style);
        style.isUpwards = true;
        m_svg.text({m_left.left() + kLineHeight / 2, m_axes.center().y()}, m_plot.y.label, style);
        style.isUpwards = false;
        style.anchor = Anchor::End;
        for (const PlotScale::Tick& tick : m_y.ticks())
            if (!tick.label.isEmpty())
                m_svg.text(placeOf(m_x.least(), tick.value) - QPointF{kSpace, 0.0}, tick.label,
                           style);
    }

    [[nodiscard]] std::vector<QPointF> placesOf(const std::vector<QPointF>& points) const
    {
        std::vector<QPointF> places;
        for (const QPointF& point : points)
            if (m_x.shows(point.x()) && m_y.shows(point.y()))
                places.push_back(placeOf(point.x(), point.y()));
        return places;
    }

    void drawMarks(std::size_t series, const std::vector<QPointF>& places)
    {
        QString outlines;
        for (const QPointF& place : places)
            outlines += markOutline(series, place);
        m_svg.path(outlines, markFill(m_plot, series),
                   {.colour = lineStroke(m_plot, series).colour, .width = 1.5});
    }

    void drawSeries(std::size_t series)
    {
        const std::vector<QPointF> line = placesOf(m_plot.series[series].line);
        if (!line.empty())
            m_svg.polyline(line, lineStroke(m_plot, series));
        const std::vector<QPointF> marks = placesOf(m_plot.series[series].marks);
        if (!marks.empty())
            drawMarks(series, marks);
    }

    const Plot& m_plot;
    SvgWriter m_svg;
    QRectF m_left; // of the page
    QRectF m_axes;
    PlotScale m_x;
    PlotScale m_y;
};

} // namespace

QByteArray svgOf(const Plot& plot) { return PlotDrawing{plot}.draw(); }

} // namespace carina
