#include "tests/support/test_class.h"
#include "widgets/wrapped_text.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStandardItemModel>

#include <algorithm>

namespace carina::wrapped_text_test
{
namespace
{

/// A cell of some width.
struct Cell {
    QStandardItemModel model;
    WrappedTextDelegate delegate;
    QStyleOptionViewItem option;

    explicit Cell(const QString& text)
    {
        model.appendRow(new QStandardItem{text});
        option.font = QApplication::font();
        option.fontMetrics = QFontMetrics{option.font};
        option.palette.setColor(QPalette::Text, Qt::white);
        option.palette.setColor(QPalette::Base, Qt::black);
        option.state = QStyle::State_Enabled | QStyle::State_Active;
    }
    [[nodiscard]] QModelIndex index() const { return model.index(0, 0); }
    /// Of a column of this width; 0: of one that is as wide as the text.
    [[nodiscard]] QSize size(int width)
    {
        option.rect = width > 0 ? QRect{0, 0, width, 1} : QRect{};
        return delegate.sizeHint(option, index());
    }
    [[nodiscard]] int line() const { return option.fontMetrics.height(); }
};

/// Whether something is written between two rows of a picture.
bool isWritten(const QImage& picture, int from, int to)
{
    for (int row = std::max(from, 0); row < std::min(to, picture.height()); ++row)
        for (int column = 0; column < picture.width(); ++column)
            if (qGray(picture.pixel(column, row)) > 100)
                return true;
    return false;
}

} // namespace

class TestWrappedText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasOneLineWhereThereIsRoom()
    {
        Cell cell{QStringLiteral("Tom")};
        const QSize whole = cell.size(0);
        QVERIFY(whole.width() >= cell.option.fontMetrics.horizontalAdvance(QStringLiteral("Tom")));
        QCOMPARE(cell.size(whole.width() + 20).height(), whole.height());
    }

    void hasAsManyLinesAsItNeeds_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("words") << QStringLiteral("Maximiliane Charlotte von Hohenlohe");
        QTest::newRow("one word") << QString{40, QLatin1Char{'m'}};
    }
    void hasAsManyLinesAsItNeeds()
    {
        QFETCH(const QString, text);
        Cell cell{text};
        const QSize whole = cell.size(0);
        const int width = whole.width() / 3;
        const QSize wrapped = cell.size(width);
        QCOMPARE(wrapped.width(), width);
        QVERIFY(wrapped.height() >= whole.height() + 2 * cell.line());
        QVERIFY(wrapped.height() < whole.height() + 6 * cell.line());
    }

    void writesAllLines()
    {
        Cell cell{QString{40, QLatin1Char{'m'}}};
        const QSize size = cell.size(cell.size(0).width() / 3);
        QImage picture{size, QImage::Format_RGB32};
        picture.fill(Qt::black);
        {
            QPainter painter{&picture};
            cell.option.rect = QRect{QPoint{}, size};
            cell.delegate.paint(&painter, cell.option, cell.index());
        }
        QVERIFY(isWritten(picture, 0, cell.line()));
        QVERIFY(isWritten(picture, size.height() / 2 - cell.line() / 2,
                          size.height() / 2 + cell.line() / 2));
        QVERIFY(isWritten(picture, size.height() - cell.line(), size.height()));
    }
};

CARINA_SCREEN_TEST(TestWrappedText)

} // namespace carina::wrapped_text_test

#include "tst_wrapped_text.moc"
