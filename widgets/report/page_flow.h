#pragma once

#include "widgets/report/page_text.h"

#include <QPdfWriter>

#include <functional>

namespace carina
{

/// The unit of positions on a page is a dot.
inline constexpr int kPageDotsPerMillimetre = 50;
inline constexpr int kPageDotsPerInch = 1270;
constexpr double pageDots(double mm) { return kPageDotsPerMillimetre * mm; }

/// Lays out content from top to bottom on the pages of a document. A first flow without a painter
/// counts the pages, so that the footers of a second one can state the total. Heights and widths
/// are in dots.
class PageFlow
{
public:
    using Drawing = std::function<void(QPainter& painter, const QRectF& place)>;
    using Footer = std::function<QString(int page)>;

    /// Draws nothing.
    explicit PageFlow(QPdfWriter& writer);
    /// @param painter active on the writer, both at the first page
    /// @param title   at the left of each page's footer
    /// @param footer  at the right of the footer
    PageFlow(QPdfWriter& writer, QPainter& painter, QString title, Footer footer);

    [[nodiscard]] const QPaintDevice& device() const { return m_writer; }
    [[nodiscard]] int pages() const { return m_page; }
    [[nodiscard]] double width() const { return m_area.width(); }
    [[nodiscard]] double heightOfPage() const { return m_area.height(); }
    /// The height left on the page.
    [[nodiscard]] double room() const { return m_area.height() - m_used; }

    void beginPage();
    /// Begins a new page if less height than this is left.
    void need(double height);
    /// Leaves vertical space, except at the top of a page.
    void skip(double height);
    /// Draws at the next position; on the next page if this one has too little height left.
    void add(double height, const Drawing& drawing);

    /// Text at the full width, line by line.
    void addText(const QString& words, const PageTextStyle& style = kBodyText);
    /// A section heading, kept on one page with at least the height `following` of what follows.
    void addHeading(const QString& words, double following);

private:
    void drawFooter();

    QPdfWriter& m_writer;
    QPainter* m_painter = nullptr; // null if it only counts pages
    QString m_title;
    Footer m_footer;
    QRectF m_area; // of the content
    double m_used = 0.0;
    int m_page = 1;
};

} // namespace carina
