#pragma once

#include "widgets/report/page_text.h"

#include <QPdfWriter>

#include <functional>

namespace carina
{

/// Dots of a page, in which places on it are.
inline constexpr int kPageDotsPerMillimetre = 50;
inline constexpr int kPageDotsPerInch = 1270;
constexpr double pageDots(double mm) { return kPageDotsPerMillimetre * mm; }

/// Puts things below each other on the pages of a document. A first flow without a painter counts
/// the pages, so that the footers of a second one can tell how many there are.
class PageFlow
{
public:
    using Drawing = std::function<void(QPainter& painter, const QRectF& place)>;
    using Footer = std::function<QString(int page)>;

    /// Draws nothing.
    explicit PageFlow(QPdfWriter& writer);
    /// @param painter active on the writer, both at the first page
    /// @param title   at the left of each page's foot
    /// @param footer  at its right
    PageFlow(QPdfWriter& writer, QPainter& painter, QString title, Footer footer);

    [[nodiscard]] const QPaintDevice& device() const { return m_writer; }
    [[nodiscard]] int pages() const { return m_page; }
    [[nodiscard]] double width() const { return m_area.width(); }
    [[nodiscard]] double heightOfPage() const { return m_area.height(); }
    /// The height that is left of the page.
    [[nodiscard]] double room() const { return m_area.height() - m_used; }

    void beginPage();
    /// Begins a page where less is left of this one.
    void need(double height);
    /// Leaves room, but none at the top of a page.
    void skip(double height);
    /// Gives a drawing the next place, on the next page where this one is too full.
    void add(double height, const Drawing& drawing);

    /// Words at the full width, line by line.
    void addText(const QString& words, const PageTextStyle& style = kBodyText);
    /// A section's, kept on one page with that much of what follows.
    void addHeading(const QString& words, double following);

private:
    void drawFooter();

    QPdfWriter& m_writer;
    QPainter* m_painter = nullptr; // null where it only counts
    QString m_title;
    Footer m_footer;
    QRectF m_area; // for what is added
    double m_used = 0.0;
    int m_page = 1;
};

} // namespace carina
