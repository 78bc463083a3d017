#pragma once

#include <QColor>
#include <QFont>
#include <QPaintDevice>
#include <QPainter>
#include <QStringList>

namespace carina
{

struct PageTextStyle {
    double points = 9.0;
    bool isBold = false;
    QColor ink{32, 32, 32};
};

inline const PageTextStyle kBodyText{};
inline const PageTextStyle kPaleText{.ink = {80, 80, 80}};
inline const PageTextStyle kSmallText{.points = 7.5, .ink = {80, 80, 80}};

/// Text broken into lines of at most a given width. Widths and positions are in dots of the device.
class PageText
{
public:
    /// A word wider than `width` is broken.
    /// @param device for its font metrics
    PageText(const QString& words, const PageTextStyle& style, double width,
             const QPaintDevice& device);

    [[nodiscard]] const QStringList& lines() const { return m_lines; }
    [[nodiscard]] double lineHeight() const { return m_lineHeight; }
    [[nodiscard]] double height() const
    {
        return m_lineHeight * static_cast<double>(m_lines.size());
    }
    /// The width of the widest line.
    [[nodiscard]] double width() const { return m_width; }

    /// @param place of the first line; the others follow below
    void draw(QPainter& painter, const QRectF& place,
              Qt::Alignment alignment = Qt::AlignLeft) const;
    void drawLine(qsizetype line, QPainter& painter, const QRectF& place,
                  Qt::Alignment alignment = Qt::AlignLeft) const;

private:
    QFont m_font;
    QColor m_ink;
    QStringList m_lines;
    double m_lineHeight = 0.0;
    double m_width = 0.0;
};

} // namespace carina
