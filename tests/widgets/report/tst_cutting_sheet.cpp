#include "tests/support/test_class.h"
#include "tests/widgets/report/pdf_reader.h"
#include "widgets/report/cutting_sheet.h"

#include <QTemporaryDir>

namespace carina::cutting_sheet_test
{
namespace
{

constexpr int kDotsPerInch = 300;
constexpr double kMillimetresPerDot = 25.4 / kDotsPerInch;
constexpr double kTolerance_mm = 2.0 * kMillimetresPerDot;

bool isInk(const QImage& page, int x, int y) { return qGray(page.pixel(x, y)) < 100; }

/// The longest run of ink in each row, and where it begins.
struct Run {
    int begin = 0;
    int length = 0;
    int row = 0;
};

Run longestRun(const QImage& page, int fromRow, int toRow)
{
    Run longest;
    for (int y = fromRow; y < toRow; ++y)
        for (int x = 0; x < page.width();) {
            int end = x;
            while (end < page.width() && isInk(page, end, y))
                ++end;
            if (end - x > longest.length)
                longest = {x, end - x, y};
            x = std::max(end, x + 1);
        }
    return longest;
}

CutPiece square()
{
    CutPiece piece{.title = QStringLiteral("Square"),
                   .steps = {QStringLiteral("Look at it.")},
                   .size = {60.0, 70.0}};
    piece.ink.push_back({10.0, 20.0, 36.0, 27.0});
    return piece;
}

} // namespace

/// Sheets, as pdftoppm prints them.
class TestCuttingSheet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTrueToScale()
    {
        if (!test::hasPdfReader())
            QSKIP("poppler-utils is not installed");
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("sheets.pdf"));
        QVERIFY(writeCuttingSheets(file.toStdString(), {square()}));
        const QImage page = test::firstPageOf(file, kDotsPerInch);
        QVERIFY(!page.isNull());
        const int below = int(95.0 / kMillimetresPerDot); // between the ink and the bar
        const Run ink = longestRun(page, 0, below);
        QVERIFY(std::abs(ink.length * kMillimetresPerDot - 36.0) < kTolerance_mm);
        int rows = 0;
        for (int y = 0; y < below; ++y)
            rows += isInk(page, ink.begin + ink.length / 2, y) ? 1 : 0;
        QVERIFY(std::abs(rows * kMillimetresPerDot - 27.0) < kTolerance_mm);
    }

    void hasABarOfAHundredMillimetres()
    {
        if (!test::hasPdfReader())
            QSKIP("poppler-utils is not installed");
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("sheets.pdf"));
        CutPiece empty = square();
        empty.ink.clear();
        QVERIFY(writeCuttingSheets(file.toStdString(), {empty}));
        const QImage page = test::firstPageOf(file, kDotsPerInch);
        const Run bar = longestRun(page, 0, page.height());
        QVERIFY2(std::abs(bar.length * kMillimetresPerDot - kScaleBar_mm) < 3.0 * kTolerance_mm,
                 qPrintable(QString::number(bar.length * kMillimetresPerDot)));
        QVERIFY(test::pagesOf(file)[0].contains(QStringLiteral("100 mm")));
    }

    void hasAPageForEachPiece()
    {
        if (!test::hasPdfReader())
            QSKIP("poppler-utils is not installed");
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("sheets.pdf"));
        CutPiece second = square();
        second.title = QStringLiteral("Another");
        second.folds.emplace_back(0.0, 0.0, 10.0, 0.0);
        QVERIFY(writeCuttingSheets(file.toStdString(), {square(), second}));
        const QStringList pages = test::pagesOf(file);
        QCOMPARE(pages.size(), 2);
        QVERIFY(pages[0].contains(QStringLiteral("Square Look at it.")));
        QVERIFY(!pages[0].contains(QStringLiteral("fold")));
        QVERIFY(pages[1].contains(QStringLiteral("Another")));
        QVERIFY(pages[1].contains(QStringLiteral("fold along the dashed")));
        QVERIFY(pages[1].contains(QStringLiteral("2 of 2")));
    }

    void saysWhereItCannotWrite()
    {
        const auto wrote = writeCuttingSheets("/no-such-folder/sheets.pdf", {square()});
        QVERIFY(!wrote);
        QCOMPARE(wrote.error().code, Errc::FileUnwritable);
    }
};

CARINA_SCREEN_TEST(TestCuttingSheet)

} // namespace carina::cutting_sheet_test

#include "tst_cutting_sheet.moc"
